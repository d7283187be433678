#include "mortise/coupler/reference_map/tile_window.hpp"

namespace mortise {

std::vector<TileWindow> windows_around(const ComponentGrid<2>& grid, const std::vector<TileWindow>& boxes, int reach) {
  struct Held {
    std::int64_t tile;
    TileWindow box;
  };
  const Forest<2>& forest = grid.forest;
  std::vector<Held> all;
  for (std::size_t t = 0; t < boxes.size(); ++t)
    if (!boxes[t].empty()) all.push_back({forest.first_global() + static_cast<std::int64_t>(t), boxes[t]});
  all = forest.communicator().gather_all(all);
  std::sort(all.begin(), all.end(), [](const Held& a, const Held& b) { return a.tile < b.tile; });
  const TileWindow whole = tile_cells_and_ghosts(grid.shape);
  std::vector<TileWindow> windows(boxes.size());
  for (int t = 0; t < forest.local_count(); ++t) {
    TileWindow& window = windows[static_cast<std::size_t>(t)];
    for (int side = 0; side < offset_count<2>; ++side) {
      const Index<2> offset = offset_of<2>(side);
      std::int64_t tile = forest.first_global() + t;
      if (offset != Index<2>{0, 0}) {
        const Neighbor& neighbor = forest.neighbor(t, offset);
        if (neighbor.kind == Neighbor::Kind::boundary) continue;
        tile = neighbor.global;
      }
      const auto found =
          std::lower_bound(all.begin(), all.end(), tile, [](const Held& a, std::int64_t b) { return a.tile < b; });
      if (found == all.end() || found->tile != tile) continue;
      const Index<2> shift{offset[0] * grid.shape.cells[0], offset[1] * grid.shape.cells[1]};
      const TileWindow near = found->box.moved(shift).grown(reach) & whole;
      if (!near.empty()) window = window | near;
    }
  }
  return windows;
}

}  // namespace mortise
