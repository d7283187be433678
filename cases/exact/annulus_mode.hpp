// Radial free vibration of a linear elastic annulus a ≤ r ≤ b whose two faces are held:
//   u_r = A [J1(κr) Y1(κa) − Y1(κr) J1(κa)] / N cos ωt,  ω = κ c_p,  κ the m-th root of u_r(b) = 0,
// N the value of the bracket with the largest magnitude, so that A is the largest displacement at t = 0.
// Source: Love, Mathematical Theory of Elasticity, section 199.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Non-dimensional.
struct AnnulusModeProblem {
  Material material;  // linear
  double inner = 0.5, outer = 1;
  int mode = 1;  // m ≥ 1: number of half waves across
  double amplitude = 0.01;
};

class AnnulusMode : public ExactSolution<2> {
 public:
  explicit AnnulusMode(const AnnulusModeProblem& problem);

  /// Throws std::logic_error: there is no fluid.
  Primitive<2> state(const Point<2>& x, double t) const override;
  bool describes_fluid() const override { return false; }
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;

  double wave_number() const { return wave_number_; }  // κ = ω/c_p

 private:
  AnnulusModeProblem problem_;
  double wave_number_, frequency_;
  double weight_j_, weight_y_;  // u_r = (weight_j J1(κr) + weight_y Y1(κr)) cos ωt
};

}  // namespace mortise
