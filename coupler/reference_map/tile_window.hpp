// The part of a tile near a body, outside of which the body's map holds nothing, so that no loop of a small body runs
// over whole tiles.
#pragma once

#include <algorithm>
#include <vector>

#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// Cells low ≤ (i, j) < high of a tile; ghost cells −2, −1, n and n + 1 count.
struct TileWindow {
  Index<2> low{0, 0}, high{0, 0};

  bool operator==(const TileWindow&) const = default;
  bool empty() const { return low[0] >= high[0] || low[1] >= high[1]; }
  /// Common cells; empty where there are none.
  TileWindow operator&(const TileWindow& other) const {
    return {{std::max(low[0], other.low[0]), std::max(low[1], other.low[1])},
            {std::min(high[0], other.high[0]), std::min(high[1], other.high[1])}};
  }
  /// The smallest window around both.
  TileWindow operator|(const TileWindow& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {{std::min(low[0], other.low[0]), std::min(low[1], other.low[1])},
            {std::max(high[0], other.high[0]), std::max(high[1], other.high[1])}};
  }
  TileWindow moved(const Index<2>& by) const {
    return {{low[0] + by[0], low[1] + by[1]}, {high[0] + by[0], high[1] + by[1]}};
  }
  TileWindow grown(int by) const { return {{low[0] - by, low[1] - by}, {high[0] + by, high[1] + by}}; }
};

/// The cells of a tile without ghosts, and with them.
inline TileWindow tile_cells(const TileShape<2>& shape) { return {{0, 0}, shape.cells}; }
inline TileWindow tile_cells_and_ghosts(const TileShape<2>& shape) {
  return tile_cells(shape).grown(TileShape<2>::ghosts);
}

/// For each local tile the smallest window, ghosts included, around all cells within `reach` ≤ the tile's width of what
/// `boxes` (by local tile, without ghosts) hold on this and neighbouring tiles. Collective.
std::vector<TileWindow> windows_around(const ComponentGrid<2>& grid, const std::vector<TileWindow>& boxes, int reach);

}  // namespace mortise
