// Velocities (v, ω), forces (f, torque) and matrices of a rigid body as the coupler sees them: plain numbers.
#pragma once

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// (v, ω) or (force, torque): 3 numbers in the plane, 1 on a line.
template <int Dim>
using BodyVector = Eigen::Matrix<double, Dim + rotations<Dim>, 1>;
template <int Dim>
using BodyMatrix = Eigen::Matrix<double, Dim + rotations<Dim>, Dim + rotations<Dim>>;

/// e = (n, r × n): e·y is the velocity along n of the point at r from the centre of mass, e the load of a unit force
/// along n at that point.
template <int Dim>
BodyVector<Dim> generalized_normal(const Point<Dim>& normal, const Point<Dim>& arm) {
  BodyVector<Dim> e;
  e.template head<Dim>() = normal;
  if constexpr (Dim == 2) e[2] = arm[0] * normal[1] - arm[1] * normal[0];
  return e;
}

}  // namespace mortise
