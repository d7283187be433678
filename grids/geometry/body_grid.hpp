// A body-fitted grid in the body's own frame, and fast answers about points near it. Everything here is fixed
// once a rigid body is built: a moving body is asked in its own frame, X = R(−angle)(x − position).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// How far and how finely to grow a grid from an outline.
struct GrowthOptions {
  double spacing;  // target cell size h, along and across
  int layers;      // number of cell layers outward, at least 3
};

/// Nodes of a grid grown outward from a closed outline. Node (i, j), 0 ≤ i < along (periodic in i), 0 ≤ j ≤ layers;
/// j = 0 lies on the outline, equally spaced in arc length, node (0, 0) at Outline::at(0); i runs *clockwise* around
/// the body, so that cells are right-handed: (x_{i+1} − x_i) × (x_{j+1} − x_j) > 0 for every cell.
struct GrownGrid {
  int along = 0, layers = 0;
  double spacing = 0;
  std::vector<Point<2>> nodes;  // (layers + 1) × along, index j * along + i

  const Point<2>& node(int i, int j) const {
    return nodes[static_cast<std::size_t>(j * along + (i % along + along) % along)];
  }
};

/// Marches outward hyperbolically. `along` is the multiple of 4 nearest to perimeter/spacing, at least 16, so that a
/// symmetric outline gives a grid symmetric to round-off. Every cell is checked.
/// Throws InputError for a spacing that is not positive, for fewer than 3 layers, and when the grid would fold
/// whatever the smoothing.
GrownGrid grow(const Outline& outline, const GrowthOptions& options);

/// Measures of a grid's worst cells.
struct GridQuality {
  double min_corner_ratio;  // smallest corner triangle over a quarter of the four's sum: 1 parallelogram, ≤ 0 folded
  double max_aspect;        // largest ratio of a cell's mean lengths along and across, whichever is longer first
  double min_size;          // smallest ratio of a cell's area to its longest side
};
GridQuality check(const GrownGrid& grid);

/// Where a point is on a grid, relative to the 3 × 3 cell centres its coordinates were found on.
struct StencilPoint {
  Index<2> center{};                   // middle cell (i, j): 0 ≤ i < along, 1 ≤ j ≤ layers − 2
  Point<2> offset = Point<2>::Zero();  // in cells, from the middle: |offset[0]| ≤ ¾, about ½ where cells are not askew
};

/// Distance and location tables of one grown grid. Immutable; may be asked from several threads.
class BodyAtlas {
 public:
  BodyAtlas(const Outline& outline, GrownGrid grid);

  const GrownGrid& grid() const { return grid_; }
  double width() const { return width_; }         // smallest distance of the outermost node layer from the outline
  const Box<2>& reach() const { return reach_; }  // body frame; holds all points closer than width + 6 spacings
  /// Centre of a cell: the mean of its four nodes; −1 ≤ i ≤ along (periodic), 0 ≤ j < layers.
  const Point<2>& center(int i, int j) const {
    return centers_[static_cast<std::size_t>(j * (grid_.along + 2) + i + 1)];
  }

  /// Signed distance from the outline, positive outside, by bilinear look-up in a table (step: half a spacing) filled
  /// with exact distances to the polygon (error ≤ spacing²·curvature/32; where several points of the outline are
  /// nearest, up to spacing/4). Outside the table: a lower bound that is > width.
  double distance(const Point<2>& X) const {
    const double x = (X.x() - table_low_.x()) * table_per_length_, y = (X.y() - table_low_.y()) * table_per_length_;
    if (!(x >= 0 && y >= 0 && x < table_size_[0] - 1 && y < table_size_[1] - 1)) return distance_bound(X);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    const double* low = distance_table_.data() + (static_cast<std::ptrdiff_t>(j) * table_size_[0] + i);
    const double* high = low + table_size_[0];
    const double below = low[0] + u * (low[1] - low[0]), above = high[0] + u * (high[1] - high[0]);
    return below + v * (above - below);
  }

  /// Logical coordinates (ξ, η) of X in cell-centre units: the centre of cell (i, j) is (i, j) exactly, ξ periodic with
  /// period `along` (returned in [−½, along − ½)), η in [−½, layers − ½] inside the grid. They invert the biquadratic
  /// interpolant of the nine nearest cell centres (stencil clamped to rows 0 … layers − 1), so that biquadratic
  /// interpolation on that stencil reproduces X to 1e-12 spacings. Returns false when X is not within the grid
  /// (a tenth of a cell beyond η = −½ and layers − ½ is granted: edges are curved).
  /// The stencil's middle is the cell with the nearest centre; to third order, round(ξ) may name its neighbour.
  bool locate(const Point<2>& X, StencilPoint& where) const;
  bool locate(const Point<2>& X, Point<2>& logical) const;

  /// As locate(); but a point that is beyond the innermost row by at most 3 spacings inside the body is given the
  /// coordinates of the nearest point of the curve η = 0 through the first row's centres. For tight gaps.
  bool locate_clamped(const Point<2>& X, StencilPoint& where) const;
  bool locate_clamped(const Point<2>& X, Point<2>& logical) const;

 private:
  void fill_centers();
  void fill_distances(const Outline& outline);
  void fill_nearest_cells();
  double distance_bound(const Point<2>& X) const;
  int nearest_cell(const Point<2>& X) const;  // −1: none near
  bool solve(const Point<2>& X, StencilPoint& where) const;
  Index<2> nearest_center(const Point<2>& X, Index<2> cell) const;
  Point<2> logical(const StencilPoint& where) const;

  GrownGrid grid_;
  double width_ = 0;
  Box<2> bounds_, reach_;          // of the outline; of the table
  std::vector<Point<2>> centers_;  // layers × (along + 2): each row begins and ends with its neighbour across the seam
  Point<2> table_low_;             // its first node
  Index<2> table_size_{};          // nodes
  double table_per_length_ = 0;    // nodes per unit length
  std::vector<double> distance_table_;  // at table nodes
  std::vector<int> cell_table_;  // at table nodes: index j * along + i of the nearest cell, −1 where none is near
};

}  // namespace mortise
