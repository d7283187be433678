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

/// Cartesian cells.
template <int Dim>
struct CartesianBoundary {
  const ComponentGrid<Dim>& grid;
  Index<Dim> first;

  Point<Dim> center(Index<Dim> c) const {
    for (std::size_t d = 0; d < Dim; ++d) c[d] += first[d];
    return grid.center(c);
  }
  void mirror(std::array<double, Dim>& momentum, std::size_t d, const Index<Dim>&, int) const {
    momentum[d] = 0.0 - momentum[d];  // keeps +0 a +0
  }
};

/// Quadrilaterals.
struct MeshBoundary {
  const TileNodes& nodes;

  Point<2> node(int i, int j) const { return {nodes.x[nodes.shape->at(i, j)], nodes.y[nodes.shape->at(i, j)]}; }
  Point<2> center(const Index<2>& c) const {
    return 0.25 * (node(c[0], c[1]) + node(c[0] + 1, c[1]) + node(c[0], c[1] + 1) + node(c[0] + 1, c[1] + 1));
  }
  /// The face is the one that begins at node `line` of direction d, beside cell c.
  void mirror(std::array<double, 2>& momentum, std::size_t d, const Index<2>& c, int line) const {
    const Point<2> edge = d == 0 ? node(line, c[1] + 1) - node(line, c[1]) : node(c[0] + 1, line) - node(c[0], line);
    const Point<2> normal = Point<2>(-edge[1], edge[0]).normalized();
    const double twice = 2 * (momentum[0] * normal[0] + momentum[1] * normal[1]);
    for (std::size_t k = 0; k < 2; ++k) momentum[k] -= twice * normal[static_cast<int>(k)];
  }
};

template <int Dim, class Geometry>
void fill_side(int side, BoundaryKind kind, const ComponentGrid<Dim>& grid, TileBlock& block, const Geometry& geometry,
               const Boundaries<Dim>& boundaries, double gamma, double time) {
  const TileShape<Dim>& shape = grid.shape;
  const auto d = static_cast<std::size_t>(side / 2);
  Index<Dim> low, high;
  side_range<Dim>(shape, side, low, high);
  const int line = side % 2 == 0 ? 0 : shape.cells[d];       // of nodes on the boundary
  const int edge = side % 2 == 0 ? 0 : shape.cells[d] - 1;  // the row of cells next to it
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
        from[d] = 2 * line - 1 - c[d];
        Conserved<Dim> U = get<Dim>(block, shape.at(from));
        geometry.mirror(U.momentum, d, c, line);
        put<Dim>(block, ghost, U);
        break;
      }
      case BoundaryKind::exact:
        put<Dim>(block, ghost, to_conserved(boundaries.exact(geometry.center(c), time), gamma));
        break;
      case BoundaryKind::periodic:
        break;
    }
  });
}

/// Of those sides of the tile that are sides of the grid.
template <int Dim, class Kinds, class Geometry>
void fill_sides(const ComponentGrid<Dim>& grid, int tile, const Kinds& kinds, TileBlock& block, const Geometry& geometry,
                const Boundaries<Dim>& boundaries, double gamma, double time) {
  const Index<Dim> first = grid.first_cell(tile);
  for (int side = 0; side < 2 * Dim; ++side) {
    const BoundaryKind kind = kinds[static_cast<std::size_t>(side)];
    const auto d = static_cast<std::size_t>(side / 2);
    const bool at_edge = side % 2 == 0 ? first[d] == 0 : first[d] + grid.shape.cells[d] == grid.cells[d];
    if (at_edge && kind != BoundaryKind::periodic) fill_side<Dim>(side, kind, grid, block, geometry, boundaries, gamma, time);
  }
}

}  // namespace

template <int Dim>
void fill_boundary(const ComponentGrid<Dim>& grid, int tile, TileBlock& block, const Boundaries<Dim>& boundaries, double gamma, double time) {
  fill_sides<Dim>(grid, tile, boundaries.kind, block, CartesianBoundary<Dim>{grid, grid.first_cell(tile)}, boundaries, gamma, time);
}

void fill_boundary(const ComponentGrid<2>& grid, int tile, TileBlock& block, const std::array<BoundaryKind, 4>& kinds, const TileNodes& nodes,
                   const Boundaries<2>& boundaries, double gamma, double time) {
  fill_sides<2>(grid, tile, kinds, block, MeshBoundary{nodes}, boundaries, gamma, time);
}

template void fill_boundary<1>(const ComponentGrid<1>&, int, TileBlock&, const Boundaries<1>&, double, double);
template void fill_boundary<2>(const ComponentGrid<2>&, int, TileBlock&, const Boundaries<2>&, double, double);

}  // namespace mortise
