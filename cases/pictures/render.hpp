// Pictures of a snapshot: a field with the bodies and the stresses of elastic solids in it, the grids themselves, or,
// in one dimension, curves.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "mortise/grids/output/image.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

struct RenderOptions {
  /// schlieren (from "density"), velocity (|u| from "velocity_x", "velocity_y"), stress (from "von_mises"), grids, or
  /// the name of a cell field: pressure, density, mach, … Elastic solids show their stress where they have no such
  /// field. One-dimensional snapshots show density, velocity, pressure and normal stress whatever the field.
  std::string field = "schlieren";
  int width = 1200;                            // pixels; lettering scales with it
  Box<2> window{};                             // what to show; empty: the fluid's first grid and all solids
  std::optional<std::array<double, 2>> range;  // values at the ends of the colour map; none: of this snapshot
  std::string title;                           // above the picture, before the field's name
};

/// Throws InputError when no grid of the snapshot has the field. The height follows from the window and is even, as is
/// the width. Schlieren are exp(−k|∇ρ|/range[1]); give a fixed range for frames of one film.
Image render(const Snapshot& snapshot, const RenderOptions& options);

}  // namespace mortise
