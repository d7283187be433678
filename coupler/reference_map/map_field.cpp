#include "mortise/coupler/reference_map/map_field.hpp"

#include <algorithm>

namespace mortise {
namespace {

std::size_t index(int tile) { return static_cast<std::size_t>(tile); }

/// The smallest window around the cells inside the body.
TileWindow inside_of(const TileShape<2>& shape, const TileWindow& window, const TileBlock& block) {
  TileWindow box;
  for (int j = window.low[1]; j < window.high[1]; ++j) {
    const double* const layer = block.component(3) + shape.at(0, j);
    int first = window.low[0], last = window.high[0];
    while (first < last && layer[first] != 0) ++first;
    while (first < last && layer[last - 1] != 0) --last;
    box = box | TileWindow{{first, j}, {last, j + 1}};
  }
  return box;
}

}  // namespace

MapField::MapField(const ComponentGrid<2>& grid)
    : grid_(grid),
      field_(Field<2>::unallocated(grid.shape, components, grid.forest.local_count())),
      windows_(index(grid.forest.local_count())) {}

std::vector<int> MapField::held() const {
  std::vector<int> tiles;
  for (int t = 0; t < field_.tiles(); ++t)
    if (tile(t).allocated()) tiles.push_back(t);
  return tiles;
}

std::size_t MapField::memory_bytes() const {
  std::size_t bytes = 0;
  for (int t = 0; t < field_.tiles(); ++t) bytes += tile(t).bytes();
  return bytes;
}

void MapField::clear(int t, const TileWindow& window) {
  if (window.empty()) return;
  const auto width = static_cast<std::size_t>(window.high[0] - window.low[0]);
  for (std::size_t n = 0; n < nothing.size(); ++n)
    for (int j = window.low[1]; j < window.high[1]; ++j)
      std::fill_n(tile(t).component(static_cast<int>(n)) + grid_.shape.at(window.low[0], j), width, nothing[n]);
}

void MapField::hold(int t) {
  field_.allocate(t);
  clear(t, tile_cells_and_ghosts(grid_.shape));
}

void MapField::widen() {
  for (const int t : held()) windows_[index(t)] = tile_cells_and_ghosts(grid_.shape);
}

void MapField::take_place_of(const MapField& other) {
  for (int t = 0; t < field_.tiles(); ++t)
    if (!other.tile(t).allocated())
      tile(t).release();
    else if (!tile(t).allocated())
      hold(t);
    else if (window(t) != other.window(t))
      clear(t, window(t));
  windows_ = other.windows_;
}

void MapField::keep_inside() {
  for (const int t : held())
    for_packs(window(t),
              [&](std::size_t k, PackMask own) { empty(tile(t), k, own & (load(tile(t).component(3) + k) != 0)); });
}

void MapField::follow_inside(int reach) {
  std::vector<TileWindow> boxes(windows_.size());
  for (const int t : held()) boxes[index(t)] = inside_of(grid_.shape, cells(t), tile(t));
  windows_ = windows_around(grid_, boxes, reach);
  for (int t = 0; t < field_.tiles(); ++t) {
    const bool wanted = !cells(t).empty();
    if (!wanted) windows_[index(t)] = {};
    if (wanted && !tile(t).allocated()) hold(t);
    if (!wanted && tile(t).allocated()) tile(t).release();
  }
}

void MapField::fill_ghosts(GhostExchange<2>& exchange) {
  const bool alone = grid_.forest.communicator().size() == 1;
  if (!alone) exchange.fill(field_, nothing);
  for (const int t : held()) {
    if (alone)
      for (int side = 0; side < offset_count<2>; ++side) copy_ghosts(t, offset_of<2>(side));
    // Sides of direction 1 come last and take the corners along.
    for (int side = 0; side < 4; ++side) {
      Index<2> outward{};
      outward[static_cast<std::size_t>(side / 2)] = side % 2 != 0 ? 1 : -1;
      if (grid_.forest.neighbor(t, outward).kind == Neighbor::Kind::boundary) fill_ghosts_beyond(t, outward);
    }
  }
}

/// From the neighbour at `offset`, on this rank.
void MapField::copy_ghosts(int t, const Index<2>& offset) {
  const TileShape<2>& shape = grid_.shape;
  const Index<2> shift{offset[0] * shape.cells[0], offset[1] * shape.cells[1]};
  const TileWindow ghosts = tile_cells(shape).moved(shift) & window(t);
  if (offset == Index<2>{0, 0} || ghosts.empty()) return;
  const Neighbor& neighbor = grid_.forest.neighbor(t, offset);
  if (neighbor.kind == Neighbor::Kind::boundary) return;
  const TileBlock& there = tile(neighbor.local);
  if (!there.allocated()) {
    clear(t, ghosts);
    return;
  }
  const auto width = static_cast<std::size_t>(ghosts.high[0] - ghosts.low[0]);
  for (int c = 0; c < components; ++c)
    for (int j = ghosts.low[1]; j < ghosts.high[1]; ++j)
      std::copy_n(there.component(c) + shape.at(ghosts.low[0] - shift[0], j - shift[1]), width,
                  tile(t).component(c) + shape.at(ghosts.low[0], j));
}

void MapField::fill_ghosts_beyond(int t, const Index<2>& outward) {
  const TileShape<2>& shape = grid_.shape;
  const TileWindow& window = windows_[index(t)];
  TileBlock& block = tile(t);
  const std::size_t d = outward[0] != 0 ? 0 : 1;
  const bool high = outward[d] > 0;
  if (high ? window.high[d] <= shape.cells[d] : window.low[d] >= 0) return;
  const std::ptrdiff_t inward = (d == 0 ? 1 : shape.stride) * -outward[d];
  for (int k = window.low[1 - d]; k < window.high[1 - d]; ++k) {
    Index<2> c{};
    c[d] = high ? shape.cells[d] - 1 : 0;
    c[1 - d] = k;
    const std::size_t at = shape.at(c), next = at + static_cast<std::size_t>(inward);
    const double layer = std::max(block.component(3)[at], block.component(3)[next]);
    for (int far = 1; far <= TileShape<2>::ghosts; ++far) {
      const std::size_t ghost = at - static_cast<std::size_t>(far * inward);
      for (int n = 0; n < components; ++n) {
        const double* q = block.component(n);
        block.component(n)[ghost] = layer >= unknown_layer ? nothing[static_cast<std::size_t>(n)]
                                    : n == 3               ? std::max(layer, 1.0)
                                                           : q[at] + far * (q[at] - q[next]);
      }
    }
  }
}

}  // namespace mortise
