// The parts of render(), one per kind of picture.
#pragma once

#include "mortise/cases/pictures/axes.hpp"
#include "mortise/cases/pictures/render.hpp"

namespace mortise {

/// Colours of the field within the axes, and the colour bars to the right of them: of the field (none for schlieren)
/// and of the stress in solids that do not have it.
void draw_field(Image& image, const Axes& axes, const Snapshot& snapshot, const RenderOptions& options, double unit);

/// Cell edges: active cells in the colour of their grid, fringe cells lighter and tinted, holes left empty. Solids are
/// tinted.
void draw_grids(Image& image, const Axes& axes, const Snapshot& snapshot, double unit);

/// Density, velocity, pressure and −σ_nn over x or, for strips, along their middle, one panel below the other; bodies
/// and solids are shaded.
Image plot_lines(const Snapshot& snapshot, const RenderOptions& options, double unit);

/// Title on the left and time on the right, on the line above the axes.
void draw_title(Image& image, const Axes& axes, const std::string& title, double time, double unit);

}  // namespace mortise
