// Walking over the cells of a component grid on this rank, and sums over them that do not depend on the ranks.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// Calls visit(local tile, local cell index, number of the cell in the grid, offset) for every cell on this rank.
template <int Dim, class Visit>
void for_each_local_cell(const ComponentGrid<Dim>& grid, Visit&& visit) {
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    const Index<Dim> first = grid.first_cell(t);
    for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
      std::size_t index = 0;
      for (std::size_t d = Dim; d-- > 0;)
        index = index * static_cast<std::size_t>(grid.cells[d]) + static_cast<std::size_t>(first[d] + c[d]);
      visit(t, c, index, grid.shape.at(c));
    });
  }
}

inline CellState state_of(const TileMask& mask, std::size_t cell) {
  return mask.cut() ? mask.state[cell] : CellState::active;
}

/// Sums of N numbers over the cells of several grids: tile by tile, the tiles in their global order.
template <std::size_t N>
class TileSums {
 public:
  using Sum = std::array<double, N>;

  /// of(local tile, local cell index, offset) gives the summand of a cell; holes are left out.
  template <int Dim, class Summand>
  void add(std::size_t number, const ComponentGrid<Dim>& grid, Summand&& of) {
    const std::size_t base = mine_.size();
    for (int t = 0; t < grid.forest.local_count(); ++t)
      mine_.push_back({static_cast<std::int64_t>(number), grid.forest.first_global() + t, {}});
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>& c, std::size_t, std::size_t cell) {
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) == CellState::hole) return;
      const Sum summand = of(t, c, cell);
      for (std::size_t k = 0; k < N; ++k) mine_[base + static_cast<std::size_t>(t)].sum[k] += summand[k];
    });
  }

  /// The sum of another tile (its global number), to be added to.
  Sum& add_tile(std::size_t number, std::int64_t tile) {
    mine_.push_back({static_cast<std::int64_t>(number), tile, {}});
    return mine_.back().sum;
  }

  /// Collective.
  Sum total(const Communicator& comm) const {
    std::map<std::pair<std::int64_t, std::int64_t>, Sum> in_order;
    for (const Tile& tile : comm.gather_all(mine_)) in_order[{tile.grid, tile.tile}] = tile.sum;
    Sum sum{};
    for (const auto& [place, of_tile] : in_order)
      for (std::size_t k = 0; k < N; ++k) sum[k] += of_tile[k];
    return sum;
  }

 private:
  struct Tile {
    std::int64_t grid, tile;
    Sum sum;
  };
  std::vector<Tile> mine_;
};

}  // namespace mortise
