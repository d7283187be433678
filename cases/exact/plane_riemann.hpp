// Plane Riemann problem of the Euler equations in Dim dimensions: two uniform states apart by the plane
// n·x = position with unit normal n = (cos α, sin α), left where n·x < position. Along n it is the one-dimensional
// problem (exact_riemann.hpp); the tangential velocity jumps at the contact only. A travelling
// (oblique) shock is the case of two states that satisfy the Rankine-Hugoniot relations. Stiffened gas: p̃ = p + p∞.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/fluid/exact_riemann.hpp"

namespace mortise {

template <int Dim>
class PlaneRiemann : public ExactSolution<Dim> {
 public:
  /// Reads initial.{left, right, position, angle} (for initial.kind "riemann" and "shock") and the gas.
  /// Throws InputError for another kind and for ρ or p + p∞ ≤ 0.
  explicit PlaneRiemann(const CaseDescription& description);

  Primitive<Dim> state(const Point<Dim>& x, double t) const override;

 private:
  double gamma_, p_inf_;
  double position_;
  Point<Dim> normal_;
  Primitive<1> left_, right_;                      // normal velocity, p̃
  Point<Dim> tangential_left_, tangential_right_;  // velocity without its normal part
  StarState star_;
};

}  // namespace mortise
