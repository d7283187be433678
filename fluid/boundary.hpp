// Physical boundaries of a grid: two ghost layers beyond each side of a Cartesian background, or of a mesh.
#pragma once

#include <functional>

#include "mortise/fluid/state.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

enum class BoundaryKind {
  periodic,  // filled by the ghost exchange
  inflow,    // a fixed state (supersonic inflow)
  outflow,   // zero gradient
  wall,      // slip wall: mirror image
  exact      // state of a given function of position and time
};

/// State (ρ, u, p̃) as a function of position and time, non-dimensional.
template <int Dim>
using StateFunction = std::function<Primitive<Dim>(const Point<Dim>&, double)>;

/// Sides are numbered 2 d (low end of direction d) and 2 d + 1 (high end).
template <int Dim>
struct Boundaries {
  std::array<BoundaryKind, 2 * Dim> kind{};
  Primitive<Dim> inflow;
  StateFunction<Dim> exact;
};

/// Fills the ghost cells of one tile that lie beyond the domain; ghosts from neighbouring tiles must be there already.
/// Corner ghosts are filled too (last direction last).
template <int Dim>
void fill_boundary(const ComponentGrid<Dim>& grid, int tile, TileBlock& block, const Boundaries<Dim>& boundaries, double gamma, double time);

/// Where the nodes of a tile are, ghosts included: arrays indexed by shape->at().
struct TileNodes {
  const TileShape<2>* shape;
  const double *x, *y;
};

/// The same for a tile of a curvilinear mesh, whose sides are of these kinds; walls mirror about the boundary face beside
/// each ghost cell.
void fill_boundary(const ComponentGrid<2>& grid, int tile, TileBlock& block, const std::array<BoundaryKind, 4>& kinds, const TileNodes& nodes,
                   const Boundaries<2>& boundaries, double gamma, double time);

}  // namespace mortise
