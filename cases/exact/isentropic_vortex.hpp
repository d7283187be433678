// Isentropic vortex carried by a uniform stream (U, V), an exact solution of the Euler equations in the plane:
//   X = (x − x0 − U t)/R, Y = (y − y0 − V t)/R, e = exp(½(1 − X² − Y²)),
//   T = 1 − (γ−1) β² e²/(8γπ²), ρ = T^(1/(γ−1)), p = ρT, u = U − β Y e/2π, v = V + β X e/2π.
// Source: Shu, ICASE report 97-65 (1997), section 5.1.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"

namespace mortise {

class IsentropicVortex : public ExactSolution<2> {
 public:
  /// Reads initial.{strength, vortex_radius, vortex_center, vortex_velocity} and gas.gamma.
  /// Throws InputError for a stiffened gas, or a vortex so strong that T ≤ 0 in its centre.
  explicit IsentropicVortex(const CaseDescription& description);
  Primitive<2> state(const Point<2>& x, double t) const override;

 private:
  double gamma_, strength_, radius_;
  Point<2> center_, velocity_;
};

}  // namespace mortise
