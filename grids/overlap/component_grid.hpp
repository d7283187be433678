// A component grid of an overlapping set: the Cartesian background, or a grid fitted to one side of a body.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mortise/grids/forest/field.hpp"
#include "mortise/grids/forest/forest.hpp"

namespace mortise {

/// What a cell is in the overlapping set; the values are those of the `mask` array in output files.
enum class CellState : std::uint8_t { active = 0, fringe = 1, hole = 2 };

/// Overlap data of one tile. Planes are indexed by TileShape::at(), ghosts included.
struct TileMask {
  std::vector<std::uint8_t> active;     // 1: advanced by the solver; empty: every cell is
  std::vector<CellState> state;         // of the tile's own cells (ghost entries unused); empty with `active`
  std::vector<std::size_t> new_holes;   // offsets of cells that have become holes at the last cut
  int active_count = 0;                 // of the tile's own cells
  bool hole = false;                    // neither active nor fringe cells: the tile needs no memory

  bool cut() const { return !active.empty(); }
};

template <int Dim>
struct ComponentGrid {
  std::string name;
  int body = -1;  // index of the body the grid is fitted to; −1: background
  int side = 0;   // 1D body grids: −1 on the left of the body, +1 on the right
  Index<Dim> cells{};
  std::array<bool, Dim> periodic{};
  Point<Dim> origin = Point<Dim>::Zero();  // background: lower corner
  Point<Dim> spacing = Point<Dim>::Zero(); // background: cell size; body grids: target cell size
  TileShape<Dim> shape;
  Forest<Dim> forest;
  std::vector<TileMask> masks;  // one per local tile

  ComponentGrid(std::string name_, const Communicator& comm, Index<Dim> cells_, std::array<bool, Dim> periodic_, TileShape<Dim> shape_)
      : name(std::move(name_)), cells(cells_), periodic(periodic_), shape(shape_), forest(comm, tile_counts(cells_, shape_), periodic_) {
    masks.resize(static_cast<std::size_t>(forest.local_count()));
  }

  bool background() const { return body < 0; }
  /// Grid-wide index of cell (0, …, 0) of a local tile.
  Index<Dim> first_cell(int tile) const {
    Index<Dim> first = forest.coordinates(tile);
    for (std::size_t d = 0; d < Dim; ++d) first[d] *= shape.cells[d];
    return first;
  }
  /// Background only: centre of the cell with this grid-wide index (any integers).
  Point<Dim> center(const Index<Dim>& c) const {
    Point<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = origin[d] + (c[static_cast<std::size_t>(d)] + 0.5) * spacing[d];
    return x;
  }
  /// Background only: the box of a local tile.
  Box<Dim> box(int tile) const {
    const Index<Dim> first = first_cell(tile);
    Box<Dim> b;
    for (int d = 0; d < Dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      b.low[d] = origin[d] + first[k] * spacing[d];
      b.high[d] = b.low[d] + shape.cells[k] * spacing[d];
    }
    return b;
  }

  static Index<Dim> tile_counts(const Index<Dim>& cells, const TileShape<Dim>& shape) {
    Index<Dim> n;
    for (std::size_t d = 0; d < Dim; ++d) n[d] = cells[d] / shape.cells[d];
    return n;
  }
};

/// Calls visit(local index) for all cells with low ≤ index < high, direction 0 fastest.
template <int Dim, class Visit>
void for_each_index(const Index<Dim>& low, const Index<Dim>& high, Visit&& visit) {
  if constexpr (Dim == 1) {
    for (int i = low[0]; i < high[0]; ++i) visit(Index<1>{i});
  } else {
    for (int j = low[1]; j < high[1]; ++j)
      for (int i = low[0]; i < high[0]; ++i) visit(Index<2>{i, j});
  }
}

/// The same over all cells of a tile, widened by `ghosts` layers.
template <int Dim, class Visit>
void for_each_cell(const TileShape<Dim>& shape, int ghosts, Visit&& visit) {
  Index<Dim> low, high;
  for (std::size_t d = 0; d < Dim; ++d) {
    low[d] = -ghosts;
    high[d] = shape.cells[d] + ghosts;
  }
  for_each_index<Dim>(low, high, visit);
}

}  // namespace mortise
