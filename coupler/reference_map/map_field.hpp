// Where a reference map is kept: on the tiles near its body, of each of them a window around the cells inside.
#pragma once

#include <array>
#include <vector>

#include "mortise/coupler/reference_map/map_extension.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"

namespace mortise {

class MapField {
 public:
  /// ξ_x, ξ_y, φ(ξ), and the layer: 0 inside, 1, 2, … in the band, `unknown_layer` elsewhere.
  static constexpr int components = 4;
  /// What cells without a map hold.
  static constexpr std::array<double, components> nothing = {0, 0, 1e30, unknown_layer};

  /// On no tile. `grid` is not owned.
  explicit MapField(const ComponentGrid<2>& grid);

  Field<2>& tiles() { return field_; }
  const Field<2>& tiles() const { return field_; }
  TileBlock& tile(int t) { return field_.tile(t); }
  const TileBlock& tile(int t) const { return field_.tile(t); }
  /// The part of a local tile that may hold something, ghosts included; and without ghosts.
  const TileWindow& window(int t) const { return windows_[static_cast<std::size_t>(t)]; }
  TileWindow cells(int t) const { return window(t) & tile_cells(grid_.shape); }
  /// Local tiles that hold the map.
  std::vector<int> held() const;
  std::size_t memory_bytes() const;

  /// A tile holds the map from now on, nothing of it yet.
  void hold(int t);
  /// Windows of tiles that hold the map are as large as these.
  void widen();
  /// The same tiles and windows as another one's. Where a window stays, its cells keep what they hold.
  void take_place_of(const MapField& other);
  /// Cells of the windows that are not inside hold nothing from now on.
  void keep_inside();
  /// Tiles within `reach` cells of cells inside hold the map, no others. Collective.
  void follow_inside(int reach);
  /// From neighbours; beyond the sides of the domain linearly from the two cells there, where both hold the map.
  /// Collective.
  void fill_ghosts(GhostExchange<2>& exchange);

  /// visit(offset, lanes that count) for the cells of a window of a tile, a vector at a time.
  template <class Visit>
  void for_packs(const TileWindow& window, Visit visit) const {
    for (int j = window.low[1]; j < window.high[1]; ++j)
      for (int i = window.low[0]; i < window.high[0]; i += simd_width)
        visit(grid_.shape.at(i, j), lanes_below(window.high[0] - i));
  }
  /// Cells of these lanes hold nothing from now on.
  MORTISE_INLINE static void empty(TileBlock& block, std::size_t k, PackMask lanes) {
    for (std::size_t n = 0; n < nothing.size(); ++n) {
      double* const q = block.component(static_cast<int>(n)) + k;
      store(q, select(lanes, broadcast(nothing[n]), load(q)));
    }
  }

 private:
  void clear(int t, const TileWindow& window);
  void copy_ghosts(int t, const Index<2>& offset);
  void fill_ghosts_beyond(int t, const Index<2>& outward);

  const ComponentGrid<2>& grid_;
  Field<2> field_;
  std::vector<TileWindow> windows_;  // by local tile
};

}  // namespace mortise
