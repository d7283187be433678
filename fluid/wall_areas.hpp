// Area vectors of the wall faces of a grid that moves over a step, as the kernel takes them (plane_metrics.hpp).
#pragma once

#include <vector>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

/// S of the faces of layer 0 at half time, |S| their lengths, pointing into the fluid: to the left of layer 0. Both grids
/// have the same cells; the same bits as the flux through these faces is multiplied by.
std::vector<Point<2>> wall_areas(const GrownGrid& start, const GrownGrid& end);

}  // namespace mortise
