// Checks shared by those who make grids.
#pragma once

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

/// Throws NumericalError naming the first folded cell and its position.
void require_unfolded(const GrownGrid& grid);

}  // namespace mortise
