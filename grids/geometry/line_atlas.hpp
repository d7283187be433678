// The one-dimensional counterpart of BodyAtlas: a slab or half-space on a line, with uniform cells on its open sides.
#pragma once

#include <limits>

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

class LineAtlas {
 public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Solid fills [left, right] of the body's frame (either may be infinite); `layers` cells of size `spacing` on each
  /// finite side.
  LineAtlas(double left, double right, double spacing, int layers)
      : left_(left), right_(right), spacing_(spacing), layers_(layers) {
    const double margin = width() + 6 * spacing;
    reach_.low[0] = left_ - margin;
    reach_.high[0] = right_ + margin;
  }

  double left() const { return left_; }
  double right() const { return right_; }
  double spacing() const { return spacing_; }
  int layers() const { return layers_; }
  double width() const { return layers_ * spacing_; }
  const Box<1>& reach() const { return reach_; }

  /// Signed distance from the nearer face, positive outside the solid.
  double distance(const Point<1>& X) const { return std::max(left_ - X[0], X[0] - right_); }

  /// Position of node i of the grid on `side` (−1: left, cells counted left to right, wall at node `layers`;
  /// +1: right, wall at node 0).
  double node(int side, int i) const { return side < 0 ? left_ + (i - layers_) * spacing_ : right_ + i * spacing_; }

  /// Logical coordinate (cell i centred at i) of X in the grid on `side`; false when X is outside that grid.
  bool locate(const Point<1>& X, int side, Point<1>& logical) const {
    logical[0] = (X[0] - node(side, 0)) / spacing_ - 0.5;
    return logical[0] >= -0.5 && logical[0] <= layers_ - 0.5;
  }

 private:
  double left_, right_, spacing_;
  int layers_;
  Box<1> reach_;
};

namespace detail {
template <int Dim>
struct AtlasOf;
template <>
struct AtlasOf<1> {
  using type = LineAtlas;
};
template <>
struct AtlasOf<2> {
  using type = BodyAtlas;
};
}  // namespace detail

/// What a rigid body's surroundings look like in its own frame.
template <int Dim>
using Atlas = typename detail::AtlasOf<Dim>::type;

}  // namespace mortise
