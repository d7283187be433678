// A body-fitted grid in the body's own frame, and fast answers about points near it. A rigid body's are built once and
// asked in its own frame, X = R(−angle)(x − position); a deforming body's are built anew when it has moved.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// How far and how finely to grow a grid from an outline.
struct GrowthOptions {
  double spacing;       // target cell size h, along and across
  int layers;           // number of cell layers, at least 3
  bool inward = false;  // into the outline instead of away from it
  double thickness = 0;  // of a layer; 0: h, or for inward grids of thin bodies what leaves room for a core
};

/// Nodes of a structured grid that begins at a curve, its layer 0. Node (i, j), 0 ≤ j ≤ layers; cells are right-handed:
/// (x_{i+1} − x_i) × (x_{j+1} − x_j) > 0 for every cell, so the grid lies on the left of layer 0 (a grid grown outward
/// from a closed outline runs clockwise around it, one grown inward counter-clockwise).
struct GrownGrid {
  int along = 0, layers = 0;
  double spacing = 0;
  std::vector<Point<2>> nodes;  // (layers + 1) × row(), index j * row() + i
  bool periodic = true;         // node (i + along, j) is node (i, j) + period; otherwise rows have along + 1 nodes
  Point<2> period = Point<2>::Zero();  // zero: a closed curve
  double smoothing = 0;         // α of the growth; 0: not grown
  double thickness = 0;         // of a layer: as grown, or the mean where stretched

  int row() const { return periodic ? along : along + 1; }
  /// Any i and j: beyond the first and last row or, where the grid is not periodic, column the grid is continued
  /// linearly.
  Point<2> node(int i, int j) const {
    if (i < 0 || i >= row() || j < 0 || j > layers) return continued(i, j);
    return nodes[static_cast<std::size_t>(j) * static_cast<std::size_t>(row()) + static_cast<std::size_t>(i)];
  }

 private:
  Point<2> continued(int i, int j) const;
};

/// Marches outward, or inward, hyperbolically. `along` is the multiple of 4 nearest to perimeter/spacing, at least 16, so that a
/// symmetric outline gives a grid symmetric to round-off. Every cell is checked.
/// Throws InputError for a spacing that is not positive, for fewer than 3 layers, and when the grid would fold
/// whatever the smoothing.
GrownGrid grow(const Outline& outline, const GrowthOptions& options);

/// The same from given nodes of layer 0 (0 ≤ i < along), which are kept: for a curve that has moved. `smoothing` is that
/// of the grid it replaces (GrownGrid::smoothing), so that grids change smoothly in time. Throws NumericalError naming
/// the first folded cell.
GrownGrid grow_from(const std::vector<Point<2>>& curve, const GrowthOptions& options, double smoothing);

/// The grid between two curves with equally many nodes (row() each), linear from one to the other: what small motions of
/// `near` need. Throws NumericalError naming the first folded cell.
GrownGrid stretch_between(const std::vector<Point<2>>& near, const std::vector<Point<2>>& far, int layers, double spacing, bool periodic,
                          const Point<2>& period = Point<2>::Zero());

/// First cell with a corner whose triangle has no positive area, as (i, j); {−1, −1}: none.
Index<2> first_folded_cell(const GrownGrid& grid);

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
  /// `inward`: the body is outside the outline, which the grid lines from within.
  BodyAtlas(const Outline& outline, GrownGrid grid, bool inward = false);
  /// From a closed grid alone, fast: for one that has been grown anew around a curve that moved. Distances are those
  /// along the grid's lines, (η + ½) thickness: continuous, zero on layer 0 and growing away from it, also a few cells
  /// into the body; from there on some negative number, and beyond the grid one > width.
  explicit BodyAtlas(GrownGrid grid, bool inward = false);

  const GrownGrid& grid() const { return grid_; }
  bool inward() const { return inward_; }
  double width() const { return width_; }         // smallest distance of the outermost node layer from the outline
  const Box<2>& reach() const { return reach_; }  // body frame; holds all points closer than width + 6 spacings
  const Box<2>& vicinity() const { return vicinity_; }  // reach(), where that is not boundless: of the tables
  /// Whether a box meets the grid, or is within 8 spacings of doing so. A box that does not is all in the body, or all
  /// out of the grid's reach, or around everything.
  bool near_grid(const Box<2>& box) const;
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
  /// The same for the stencil where.center, which need not be the nearest, beginning at where.offset.
  bool locate_on(const Point<2>& X, StencilPoint& where) const { return solve(X, where); }

  /// As locate(); but a point that is beyond the innermost row by at most 3 spacings inside the body is given the
  /// coordinates of the nearest point of the curve η = 0 through the first row's centres. For tight gaps.
  bool locate_clamped(const Point<2>& X, StencilPoint& where) const;
  bool locate_clamped(const Point<2>& X, Point<2>& logical) const;

 private:
  void place_tables();
  void fill_centers();
  void fill_blocks();
  void fill_distances(const Outline& outline);
  void fill_nearest_cells();
  void rasterize();
  void rasterize_cell(int i, int j, const std::array<Point<2>, 4>& quad);
  std::vector<Point<2>> table_row(int j) const;
  void fill_interior(double from, double to);
  double distance_bound(const Point<2>& X) const;
  int nearest_cell(const Point<2>& X) const;  // −1: none near
  bool solve(const Point<2>& X, StencilPoint& where) const;
  Index<2> nearest_center(const Point<2>& X, Index<2> cell) const;
  Point<2> logical(const StencilPoint& where) const;

  GrownGrid grid_;
  bool inward_ = false;
  double width_ = 0;
  Box<2> bounds_, reach_, vicinity_;  // bounds_: of the outline
  std::vector<Point<2>> centers_;  // layers × (along + 2): each row begins and ends with its neighbour across the seam
  Point<2> table_low_;             // its first node
  Index<2> table_size_{};          // nodes
  double table_per_length_ = 0;    // nodes per unit length
  std::vector<double> distance_table_;  // at table nodes
  std::vector<int> cell_table_;  // at table nodes: index j * along + i of the nearest cell, −1 where none is near
  Index<2> block_count_{};
  std::vector<std::uint8_t> blocks_;  // squares of the table, 1 where the grid has a cell centre
};

}  // namespace mortise
