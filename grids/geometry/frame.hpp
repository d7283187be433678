// A posed body's frame: x = position + R(angle) X.
#pragma once

#include <cmath>

#include "mortise/grids/core/types.hpp"

namespace mortise {

template <int Dim>
class Frame {
 public:
  explicit Frame(const Pose<Dim>& pose)
      : position_(pose.position), cosine_(std::cos(pose.angle)), sine_(std::sin(pose.angle)) {}

  Point<Dim> to_space(const Point<Dim>& X) const { return position_ + turn(X); }
  Point<Dim> to_body(const Point<Dim>& x) const {
    const Point<Dim> r = x - position_;
    if constexpr (Dim == 2)
      return {cosine_ * r[0] + sine_ * r[1], cosine_ * r[1] - sine_ * r[0]};
    else
      return r;
  }
  /// R(angle) X: a direction turned from the body's frame into space.
  Point<Dim> turn(const Point<Dim>& X) const {
    if constexpr (Dim == 2)
      return {cosine_ * X[0] - sine_ * X[1], sine_ * X[0] + cosine_ * X[1]};
    else
      return X;
  }
  /// Bounding box in space of a box in the body's frame.
  Box<Dim> to_space(const Box<Dim>& box) const {
    if constexpr (Dim == 2) {
      Box<2> out;
      for (const double X : {box.low[0], box.high[0]})
        for (const double Y : {box.low[1], box.high[1]}) out.include(to_space(Point<2>(X, Y)));
      return out;
    } else {
      return {box.low + position_, box.high + position_};
    }
  }

 private:
  Point<Dim> position_;
  double cosine_, sine_;
};

}  // namespace mortise
