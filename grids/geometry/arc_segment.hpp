// One segment of an outline: the cubic between two points with given unit tangents whose end derivatives have length
//   M = 2 |chord|/(1 + cos ½θ),   θ the turn of the tangent,
// the classical cubic of a circular arc (Goldapp, Computer Aided Geometric Design 8, 1991: sixth order).
#pragma once

#include <cmath>

#include "mortise/grids/geometry/strip_tree.hpp"

namespace mortise {

class ArcSegment {
 public:
  ArcSegment(const Point<2>& a, const Point<2>& tangent_a, const Point<2>& b, const Point<2>& tangent_b)
      : a_(a), b_(b), tangent_a_(tangent_a), tangent_b_(tangent_b) {
    const double half = 0.5 * std::atan2(cross(tangent_a, tangent_b), tangent_a.dot(tangent_b));
    const double chord = (b - a).norm();
    speed_ = 2 * chord / (1 + std::cos(half));
    length_ = std::abs(half) < 1e-8 ? chord : chord * half / std::sin(half);
  }

  double length() const { return length_; }  // of the circular arc with this chord and turn

  /// Position and derivative at the cubic's parameter, 0 ≤ t ≤ 1.
  Point<2> position(double t) const {
    const double s = 1 - t;
    return s * s * (1 + 2 * t) * a_ + t * t * (1 + 2 * s) * b_ + s * t * speed_ * (s * tangent_a_ - t * tangent_b_);
  }
  Point<2> derivative(double t) const {
    const double s = 1 - t;
    return 6 * s * t * (b_ - a_) + speed_ * (s * (1 - 3 * t) * tangent_a_ + t * (1 - 3 * s) * tangent_b_);
  }
  /// Parameter of the point at the fraction `part` of the arc length, to fourth order in the turn.
  double parameter(double part) const { return part - (speed_ / length_ - 1) * part * (1 - part) * (1 - 2 * part); }

 private:
  Point<2> a_, b_, tangent_a_, tangent_b_;
  double speed_, length_;
};

}  // namespace mortise
