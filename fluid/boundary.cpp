#include "mortise/fluid/boundary.hpp"

#include "mortise/fluid/cell.hpp"

namespace mortise {
namespace {

/// Ghost cells of one side, as a range of local cell indices; along the side ghosts are included.
template <int Dim>
void side_range(const TileShape<Dim>& shape, int side, Index<Dim>& low, Index<Dim>& high) {
  for (std::size_t d = 0; d < Dim; ++d) {
    low[d] = -shape.ghosts;
    high[d] = shape.cells[d] + shape.ghosts;
  }
  const auto d = static_cast<std::size_t>(side / 2);
  if (side % 2 == 0)
    high[d] = 0;
  else
    low[d] = shape.cells[d];
}

}  // namespace

template <int Dim>
void fill_boundary(const ComponentGrid<Dim>& grid, int tile, TileBlock& block, const Boundaries<Dim>& boundaries, double gamma, double time) {
  const TileShape<Dim>& shape = grid.shape;
  const Index<Dim> first = grid.first_cell(tile);
  for (int side = 0; side < 2 * Dim; ++side) {
    const BoundaryKind kind = boundaries.kind[static_cast<std::size_t>(side)];
    const auto d = static_cast<std::size_t>(side / 2);
    const bool at_edge = side % 2 == 0 ? first[d] == 0 : first[d] + shape.cells[d] == grid.cells[d];
    if (!at_edge || kind == BoundaryKind::periodic) continue;
    Index<Dim> low, high;
    side_range<Dim>(shape, side, low, high);
    const int edge = side % 2 == 0 ? 0 : shape.cells[d] - 1;  // the row of cells next to the boundary
    const Conserved<Dim> inflow = to_conserved(boundaries.inflow, gamma);
    for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
      const std::size_t ghost = shape.at(c);
      Index<Dim> from = c;
      switch (kind) {
        case BoundaryKind::inflow:
          put<Dim>(block, ghost, inflow);
          break;
        case BoundaryKind::outflow:
          from[d] = edge;
          put<Dim>(block, ghost, get<Dim>(block, shape.at(from)));
          break;
        case BoundaryKind::wall: {
          from[d] = side % 2 == 0 ? -1 - c[d] : 2 * shape.cells[d] - 1 - c[d];
          Conserved<Dim> U = get<Dim>(block, shape.at(from));
          U.momentum[d] = 0.0 - U.momentum[d];  // keeps +0 a +0
          put<Dim>(block, ghost, U);
          break;
        }
        case BoundaryKind::exact: {
          Index<Dim> global = c;
          for (std::size_t k = 0; k < Dim; ++k) global[k] += first[k];
          put<Dim>(block, ghost, to_conserved(boundaries.exact(grid.center(global), time), gamma));
          break;
        }
        case BoundaryKind::periodic:
          break;
      }
    });
  }
}

template void fill_boundary<1>(const ComponentGrid<1>&, int, TileBlock&, const Boundaries<1>&, double, double);
template void fill_boundary<2>(const ComponentGrid<2>&, int, TileBlock&, const Boundaries<2>&, double, double);

}  // namespace mortise
