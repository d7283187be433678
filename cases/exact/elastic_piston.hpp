// A gas and an elastic solid that meet at a plane: the gas on the side of its normal n, the solid on the other, and all
// depends on ξ = n·X only. With the velocity w(t) of the interface,
//   gas: the simple wave of a wall that moves with F = ∫w (simple_wave.hpp), pressure p_I(t) on the wall;
//   solid (linear): u = f(ξ − ct) + g(ξ + ct), c = c_p, M = ρc² = λ + 2μ, and with σ_I = p_e − p_I for all t ≥ 0
//     f'(−ct) = ½(σ_I/M − w/c),  g'(ct) = ½(σ_I/M + w/c)  ⇔  u = F, σ = M u_ξ = σ_I at ξ = 0.
// f brings the motion: it is known from the *future* interface, for ξ ≤ 0 up to the time t + |ξ|/c, and gives the
// solid's initial state and the data at its back. g carries the answer of the gas away; g' for negative arguments is
// that part of the initial state. Source: Banks, Henshaw & Sjögreen, J. Comput. Phys. 230 (2011) 4323, section 5.
#pragma once

#include <functional>
#include <optional>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/running_integral.hpp"
#include "mortise/cases/exact/simple_wave.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Non-dimensional.
struct ElasticPistonProblem {
  double gamma = 1.4, p_inf = 0;
  double density = 1, pressure = 1;    // of the gas at rest; physical pressure
  double reference_pressure = 0;       // p_e, under which the stress-free solid is in equilibrium
  Material material;                   // linear
  double length = 1;                   // of the solid, −length ≤ ξ ≤ 0
  double angle = 0;                    // of n from +x, radians
  Point<2> origin = Point<2>::Zero();  // a point of the interface at t = 0
  double time_end = 1;                 // the time to cover

  std::function<double(double)> velocity;          // w(t) of the interface, 0 ≤ t ≤ time_end + length/c_p
  std::function<double(double)> left_going_slope;  // g'(ξ) for −length ≤ ξ ≤ 0; empty: g'(0), a uniform state
};

/// The problem with w = F', F = α t^q.
ElasticPistonProblem power_of_time(ElasticPistonProblem problem, double amplitude, double exponent);

class ElasticPiston : public ExactSolution<2> {
 public:
  explicit ElasticPiston(const ElasticPistonProblem& problem);

  Primitive<2> state(const Point<2>& x, double t) const override;
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;
  std::optional<ExactInterface> interface_at(const Point<2>& X, double t) const override;
  double valid_until() const override { return gas_.valid_until(); }

  /// Displacement F and stress σ_I of the interface.
  double displacement(double t) const { return moved_(t); }
  double stress(double t) const;

 private:
  double coordinate(const Point<2>& x) const { return normal_.dot(x - problem_.origin); }
  struct Wave {
    double value, slope;
  };
  Wave right_going(double t) const;
  Wave left_going(double t) const;

  ElasticPistonProblem problem_;
  Point<2> normal_;
  double modulus_, speed_;  // M, c
  RunningIntegral moved_;   // F = ∫w
  SimpleWave gas_;
  RunningIntegral impulse_;                            // ∫σ_I
  std::optional<RunningIntegral> initial_left_going_;  // −g(−s) for s ≥ 0
};

}  // namespace mortise
