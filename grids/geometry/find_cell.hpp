// Which cell of a structured grid a point is in, by looking at all of them: for a few points, of grids that change.
#pragma once

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

struct CellPoint {
  Index<2> cell{};                      // 0 ≤ i < along, 0 ≤ j < layers
  Point<2> within = Point<2>::Zero();   // coordinates in [0, 1]² of the bilinear map from the unit square to the cell
};

/// The first cell that holds X, edges included; periods are not searched. Returns false when there is none.
bool find_cell(const GrownGrid& grid, const Point<2>& X, CellPoint& found);

}  // namespace mortise
