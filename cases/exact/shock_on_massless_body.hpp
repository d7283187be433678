// A shock meets a slab of zero mass between two halves of the same gas. The slab transmits pressure and velocity at
// once, so the shock passes as if it were not there: with the gas to the left moved by the slab's width w the flow is
// that of the shock alone, and the slab's right face is a particle path of it.
//   right of the slab: W(x, t) = W_shock(x, t);  left of it: W(x, t) = W_shock(x + w, t).
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"

namespace mortise {

class ShockOnMasslessBody : public ExactSolution<1> {
 public:
  /// Reads initial.{kind = "shock", left, right, position}, one slab (bodies.0.position, width, mass = 0) that moves
  /// with the gas around it, and the gas. Throws InputError for another scene or states that are not those of one
  /// shock.
  explicit ShockOnMasslessBody(const CaseDescription& description);

  Primitive<1> state(const Point<1>& x, double t) const override;
  std::optional<std::vector<ExactMotion<1>>> bodies(double t) const override;

 private:
  /// The shock alone, at the coordinate of the gas right of the slab.
  Primitive<1> shock_alone(double x, double t) const;

  Primitive<1> left_, right_;  // physical pressure
  double shock_position_;      // at t = 0, in the coordinate of the gas right of the slab
  double shock_speed_;
  double face_;  // right face at t = 0
  double width_;
  double arrival_;  // when the shock meets the slab; infinite if it never does
  double velocity_before_, velocity_after_;
};

}  // namespace mortise
