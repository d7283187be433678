// A shock of Mach number M in a gas at rest meets the plane face of an elastic solid at rest. ξ = n·X, gas in ξ > 0,
// solid (linear) in −L ≤ ξ ≤ 0 with the stress σ0 = p_e − p1 in equilibrium. The shock starts at ξ = d and arrives at
// t_h = d/(M c1). From then on, until a wave comes back from the solid's back, the interface moves with the constant
// velocity v that solves the fluid-structure Riemann problem
//   P(v; state behind the shock) − p_e + σ0 + ρc v = 0                                          (wall_pressure.hpp)
// The reflected wave in the gas is a shock (p_I above the pressure behind the shock, as off a rigid wall) or a centred
// fan (the solid yields); the solid carries the step ξ = −c (t − t_h) to σ0 + ρc v, reflected at its back with a change
// of sign of v (fixed), of σ − σ0 (free), or not at all (open: exact data there). Source: Banks & Sjögreen, Commun.
// Comput. Phys. 10 (2011) 279, section 3.
#pragma once

#include <algorithm>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

enum class SolidBack { open, fixed, free };

/// Non-dimensional.
struct ElasticPistonShockProblem {
  double gamma = 1.4, p_inf = 0;
  double density = 1, pressure = 1;    // of the gas ahead of the shock, at rest; physical pressure
  double mach = 2;                     // of the shock, > 1
  double distance = 0.25;              // of the shock from the interface at t = 0
  double reference_pressure = 1;       // p_e
  Material material;                   // linear
  double length = 1;                   // L
  SolidBack back = SolidBack::open;    // what happens at ξ = −L
  double angle = 0;                    // of n from +x, radians
  Point<2> origin = Point<2>::Zero();  // a point of the interface at t = 0
};

class ElasticPistonShock : public ExactSolution<2> {
 public:
  explicit ElasticPistonShock(const ElasticPistonShockProblem& problem);

  Primitive<2> state(const Point<2>& x, double t) const override;
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;
  std::optional<ExactInterface> interface_at(const Point<2>& X, double t) const override;
  /// Until the step returns from the back; without end for an open one.
  double valid_until() const override;

  double arrival() const { return arrival_; }                   // t_h
  double interface_velocity() const { return star_.velocity; }  // after t_h, along n
  double interface_pressure() const { return star_.pressure - problem_.p_inf; }

 private:
  double coordinate(const Point<2>& x) const { return normal_.dot(x - problem_.origin); }
  double moved(double t) const { return star_.velocity * std::max(0.0, t - arrival_); }

  ElasticPistonShockProblem problem_;
  Point<2> normal_;
  double modulus_, speed_;        // M = λ + 2μ, c of the solid
  Primitive<1> ahead_, behind_;   // of the shock; p̃, velocities along n
  double shock_speed_, arrival_;  // into the gas ahead; t_h
  StarState star_;                // of the gas between the interface and the reflected wave
};

}  // namespace mortise
