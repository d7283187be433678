// Lines in a body that its reference map draws on the grid of the fluid: its surface φ(ξ) = 0, and lines ξ_x = const
// and ξ_y = const, which were straight in the undeformed body.
#pragma once

#include <vector>

#include "mortise/coupler/reference_map/level_set.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// The cells of a rectangle of a grid, rows in direction 0, and what a map is at their centres.
struct MapSamples {
  Index<2> low{}, size{};   // first cell, number of cells
  std::vector<double> phi;  // not less than unknown_phi: no map
  std::vector<Point<2>> xi;
};
inline constexpr double unknown_phi = 1e30;

/// φ = 0 between cell centres, as closed polygons.
std::vector<std::vector<Point<2>>> surfaces_of(const MapSamples& samples, const ComponentGrid<2>& grid);

/// The parts inside, φ < 0, of the lines ξ_x = center_x + k spacing and ξ_y = center_y + k spacing, k any integer.
std::vector<std::vector<Point<2>>> lines_of(const MapSamples& samples, const ComponentGrid<2>& grid,
                                            const Point<2>& center, double spacing);

/// Where φ < 0, up to the given distance.
Box<2> reference_box(const LevelSet& level_set, double distance);

}  // namespace mortise
