// Row buffers of the fused kernels: thread-local, reused from call to call, 64-byte aligned where a row's first vector
// starts, filled with ones at the start of a step so that no lane ever computes with an invalid number.
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise {

/// Rows are walked in whole vectors from cell −2 on, the last one holding cell nx + 1 (nx even: the lanes beyond stay
/// inside the slack of a tile's rows, see TileShape).
inline constexpr int row_start = -2;

class RowWorkspace {
 public:
  /// `count` rows for tiles nx cells wide. A workspace invalidates the one made before it on the same thread.
  RowWorkspace(int nx, int count);

  /// Cell 0 of row k; indices row_start − 1 … nx + 2 and whole vectors over them may be read and written.
  double* row(int k) const { return first_ + static_cast<std::size_t>(k) * stride_; }
  std::size_t stride() const { return stride_; }  // doubles from one row to the next

 private:
  double* first_;
  std::size_t stride_;
};

}  // namespace mortise
