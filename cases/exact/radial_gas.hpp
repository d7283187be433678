// The axisymmetric Euler equations without swirl between a fixed radius and a moving one, in conservation form
//   ∂t (r ρ, r ρu, r E) + ∂r (r ρu, r (ρu² + p), r u (E + p)) = (0, p, 0),
// by MUSCL-Hancock without a limiter on equal cells that stretch with the moving end; second order in space and time,
// also at both ends (one-sided parabolic slopes), for smooth flow. Faces see the acoustic Riemann solution. Pressures
// are p̃.
#pragma once

#include <vector>

#include "mortise/fluid/state.hpp"

namespace mortise {

class RadialGas {
 public:
  /// Gas at rest between the fixed radius `far` and the moving one `near`. far < near: a wall or, for far = 0, the
  /// axis; far > near: gas at rest beyond, which must stay undisturbed.
  RadialGas(double gamma, const Primitive<1>& rest, double near, double far, int cells);

  /// Slopes at t and cell states at t + dt, with the moving end at radial speed `speed`.
  void predict(double dt, double speed);
  /// The predicted state at the moving end.
  Primitive<1> trace() const;
  /// Advances by dt: the moving end goes to `near` under the pressure p̃ of the interface. After predict(½dt, ·).
  void advance(double dt, double near, double pressure);

  const std::vector<Primitive<1>>& cells() const { return state_; }  // from `near` to `far`; u radial
  double near() const { return near_; }
  double far() const { return far_; }

 private:
  double spacing() const { return (far_ - near_) / static_cast<double>(state_.size()); }  // signed
  Primitive<1> behind_the_end(const Primitive<1>& last) const;

  double gamma_;
  Primitive<1> rest_;
  double near_, far_;
  std::vector<Primitive<1>> state_, slope_, half_;  // slopes per cell, in the order of the cells
};

}  // namespace mortise
