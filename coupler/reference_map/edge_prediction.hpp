// Velocities on the edges of a tile's cells half a step ahead, second order, row by row:
//   1. "hat" states from the normal derivative alone (Taylor expansion from both sides, upwinded);
//   2. their transverse differences ½(v̂_N + v̂_S)(q̂_N − q̂_S)/h give each cell's transverse advection;
//   3. full states: normal derivative + transverse advection + ½ Δt × acceleration, upwinded again.
// Source: Rycroft, Wu, Yu & Kamrin, J. Fluid Mech. 898 (2020) A9, after Colella and Bell. Rows of intermediate states
// stay in the first-level cache; nothing between the cells and the final edges goes to memory.
#pragma once

#include <array>
#include <cstddef>

#include "mortise/coupler/reference_map/sides.hpp"
#include "mortise/grids/forest/field.hpp"

namespace mortise {

/// What lies at a side of a tile: `given` is empty where the tile has a neighbour.
struct TileSide {
  bool boundary = false;
  SideKind kind = SideKind::periodic;
  std::array<const double*, 2> velocity{};  // given (u, v) along the side from the tile's first cell on
};

/// Arrays of one tile, cell (0, 0) of component 0 at offset shape->at(0, 0); components are shape->plane doubles apart.
struct EdgeTile {
  const TileShape<2>* shape = nullptr;
  const double* velocity = nullptr;      // u, v with two ghost layers
  const double* slopes = nullptr;        // δ_x u, δ_x v, δ_y u, δ_y v with two ghost layers
  const double* acceleration = nullptr;  // of u, v with one ghost layer
  double* x_edges = nullptr;             // u, v on west edges of cells, columns 0 … nx; rows of the tile
  double* y_edges = nullptr;             // u, v on south edges of cells, rows 0 … ny; columns of the tile
  std::array<TileSide, 4> sides{};
};

/// courant: Δt/h_x, Δt/h_y. Entries around the edges named above are overwritten with numbers of no meaning.
void predict_edges(const EdgeTile& tile, double dt, const std::array<double, 2>& courant);

}  // namespace mortise
