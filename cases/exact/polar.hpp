// Vectors and tensors given in the polar basis (e_r, e_θ) of a point.
#pragma once

#include "mortise/cases/exact/linear_elasticity.hpp"

namespace mortise {

struct PolarBasis {
  /// At the origin, where no direction is radial: (e_x, e_y).
  explicit PolarBasis(const Point<2>& x) : radius(x.norm()) {
    radial = radius > 0 ? Point<2>(x / radius) : Point<2>(1, 0);
    angular = left_of(radial);
  }
  Point<2> vector(double r, double theta) const { return r * radial + theta * angular; }
  Eigen::Matrix2d tensor(double rr, double rt, double tr, double tt) const {
    return rr * radial * radial.transpose() + rt * radial * angular.transpose() + tr * angular * radial.transpose() +
           tt * angular * angular.transpose();
  }

  double radius;
  Point<2> radial, angular;  // e_r, e_θ
};

}  // namespace mortise
