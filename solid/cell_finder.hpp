// Which cell of a grown grid holds a point, and where in it: for values between the cells of a grid that overlaps no
// other. Cells are listed in square buckets about as large as they are. Immutable.
#pragma once

#include <array>
#include <vector>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

class CellFinder {
 public:
  explicit CellFinder(const GrownGrid& grid);

  /// The middle of the 3 × 3 cells nearest to the cell that holds X (they stay on the grid), and X's offset from it in
  /// cells, so that biquadratic interpolation of the centres gives X. False: X is not on the grid. A grid that repeats
  /// itself holds one period.
  bool find(const Point<2>& X, Index<2>& center, std::array<double, 2>& offset) const;

 private:
  Index<2> bucket_of(const Point<2>& X) const;
  std::size_t index_of(int i, int j) const { return static_cast<std::size_t>(j * counts_[0] + i); }
  bool holds(int cell, const Point<2>& X) const;
  Point<2> center_of(int i, int j) const;

  GrownGrid grid_;
  Box<2> bounds_;
  double size_ = 0;                        // of a bucket
  Index<2> counts_{};                      // buckets
  std::vector<std::vector<int>> buckets_;  // cells j * along + i that may have points in the bucket
};

}  // namespace mortise
