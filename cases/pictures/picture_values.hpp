// The scalar that a picture shows, per cell of every grid of a snapshot.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// One vector per grid, one value per cell; NaN in holes and on grids without the field.
using PictureValues = std::vector<std::vector<double>>;

/// "schlieren": |∇ρ|, second order in the mapping's own coordinates, one-sided where a neighbour is a hole or there is
/// none; "velocity": |u|; "stress": von Mises; any other name: the cell field of that name. Throws InputError when no
/// grid has what is needed.
PictureValues picture_values(const Snapshot& snapshot, const std::string& field);

/// Values at the ends of the colour map, over active cells: smallest and largest; for schlieren 0 and the 99.7th
/// percentile, so that one sharp cell does not bleach the rest.
std::array<double, 2> value_range(const Snapshot& snapshot, const PictureValues& values, const std::string& field);

/// Whether there are elastic solids in it.
bool has_solids(const Snapshot& snapshot);

/// Whether the nodes i = 0 and i = n coincide: the grid is closed in direction 0.
bool closed_along(const GridSnapshot& grid);

}  // namespace mortise
