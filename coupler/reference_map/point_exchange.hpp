// Ghosts of values at nodes and on edges. They are stored in a cell's place (its lower left node, its west or south
// edge), so that on a side of the domain that is not periodic the last ones, in column nx or row ny, are themselves in
// ghost places: the exchange of cells does not carry them along the side.
#pragma once

#include <memory>

#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

class PointExchange {
 public:
  /// The grid has to outlive the exchange.
  PointExchange(const ComponentGrid<2>& grid, int components);

  /// Fills all ghosts that lie on the grid, given columns 0 … nx and rows 0 … ny at the sides of the domain and 0 … nx
  /// − 1, 0 … ny − 1 elsewhere. Collective.
  void fill(Field<2>& field);

 private:
  void fill_last(Field<2>& field, std::size_t d);

  const ComponentGrid<2>* grid_;
  GhostExchange<2> exchange_;
  std::unique_ptr<Field<2>> last_;  // the last column or row in place of the first; where it is needed
};

}  // namespace mortise
