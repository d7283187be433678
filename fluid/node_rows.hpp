// Nodes of a curvilinear tile, a vector of cells at a time.
#pragma once

#include "mortise/fluid/godunov_step.hpp"
#include "mortise/fluid/plane_metrics.hpp"

namespace mortise::rows {

/// Nodes of a curvilinear tile. Where the tile has no velocities, `zeros` (a row of the workspace) serves for all rows.
class NodeRows {
 public:
  NodeRows(const CurvilinearTile& tile, const double* zeros)
      : x_(tile.x + tile.nodes->at(0, 0)),
        y_(tile.y + tile.nodes->at(0, 0)),
        pitch_(tile.nodes->stride),
        wx_(tile.wx ? tile.wx + tile.nodes->at(0, 0) : zeros),
        wy_(tile.wy ? tile.wy + tile.nodes->at(0, 0) : zeros),
        velocity_pitch_(tile.wx ? tile.nodes->stride : 0) {}

  /// Nodes of the vector of cells that starts with cell (i, r).
  MORTISE_INLINE MovingCell<Pack> cell(int i, int r) const {
    return {at(i, r), at(i + 1, r), at(i, r + 1), at(i + 1, r + 1)};
  }
  MORTISE_INLINE void prefetch(int i, int r) const {
    prefetch_read(x_ + r * pitch_ + i);
    prefetch_read(y_ + r * pitch_ + i);
    prefetch_read(wx_ + r * velocity_pitch_ + i);
    prefetch_read(wy_ + r * velocity_pitch_ + i);
  }

 private:
  MORTISE_INLINE MovingNode<Pack> at(int i, int r) const {
    const std::ptrdiff_t position = r * pitch_ + i, velocity = r * velocity_pitch_ + i;
    return {load(x_ + position), load(y_ + position), load(wx_ + velocity), load(wy_ + velocity)};
  }
  const double *x_, *y_;
  std::ptrdiff_t pitch_;
  const double *wx_, *wy_;
  std::ptrdiff_t velocity_pitch_;
};

}  // namespace mortise::rows
