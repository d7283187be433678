// Rayleigh's surface wave on the linear elastic half-space Y ≤ 0 (or, rotated, n·X ≤ 0 with n = (−sin α, cos α)),
// running along the surface direction t = (cos α, sin α) with the speed c, X = t·X, Y = n·X, κ = 2π/length:
//   u_t = A (e^{κqY} − ½(1+s²) e^{κsY}) sin κ(X − ct),  u_n = −A q (e^{κqY} − 2/(1+s²) e^{κsY}) cos κ(X − ct),
//   q² = 1 − c²/c_p²,  s² = 1 − c²/c_s²,  (1 + s²)² = 4qs  (the surface is free of traction).
// Source: Achenbach, Wave Propagation in Elastic Solids, section 5.11.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Speed of Rayleigh waves over c_s; λ + μ > 0, μ > 0.
double rayleigh_speed_ratio(double lambda, double mu);

/// Non-dimensional.
struct RayleighWaveProblem {
  Material material;  // linear
  double length = 1;  // of the wave
  double amplitude = 0.01;
  double angle = 0;                    // of the direction of travel from +x, radians
  Point<2> origin = Point<2>::Zero();  // a point of the surface
};

class RayleighWave : public ExactSolution<2> {
 public:
  explicit RayleighWave(const RayleighWaveProblem& problem);

  /// Throws std::logic_error: there is no fluid.
  Primitive<2> state(const Point<2>& x, double t) const override;
  bool describes_fluid() const override { return false; }
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;

  double speed() const { return speed_; }

 private:
  RayleighWaveProblem problem_;
  double speed_, q_, s_;
};

}  // namespace mortise
