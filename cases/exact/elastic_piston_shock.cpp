#include "mortise/cases/exact/elastic_piston_shock.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/fluid/shock.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Root v of P(v) − load + z v = 0: the left side increases with v.
double interface_velocity_of(const Primitive<1>& gas, double gamma, double load, double z) {
  double v = gas.velocity[0];
  for (int iteration = 0; iteration < 100; ++iteration) {
    const WallResponse wall = wall_response(gas.density, gas.pressure, v - gas.velocity[0], gamma);
    const double change = (load - wall.pressure - z * v) / (z + wall.impedance);
    v += change;
    if (std::abs(change) <= 1e-15 * (std::abs(v) + std::sqrt(gamma * gas.pressure / gas.density))) return v;
  }
  throw NumericalError("no velocity balances the reflected gas and the elastic solid");
}

}  // namespace

ElasticPistonShock::ElasticPistonShock(const ElasticPistonShockProblem& problem)
    : problem_(problem),
      normal_(direction(problem.angle)),
      modulus_(pressure_modulus(problem.material)),
      speed_(std::sqrt(modulus_ / problem.material.density)),
      ahead_{problem.density, {0}, problem.pressure + problem.p_inf},
      behind_(behind_shock(ahead_, problem.mach, problem.gamma, {-1})),
      shock_speed_(shock_speed(ahead_, problem.mach, problem.gamma, {-1})),
      arrival_(problem.distance / shock_speed_) {
  const double z = problem.material.density * speed_;
  const double v = interface_velocity_of(behind_, problem.gamma, ahead_.pressure, z);
  const double pressure =
      wall_response(behind_.density, behind_.pressure, v - behind_.velocity[0], problem.gamma).pressure;
  star_ = {pressure, v, 0, wall_density(behind_.density, behind_.pressure, pressure, problem.gamma), false};
}

Primitive<2> ElasticPistonShock::state(const Point<2>& x, double t) const {
  Primitive<1> W;
  if (t <= arrival_) {
    W = coordinate(x) < problem_.distance - shock_speed_ * t ? ahead_ : behind_;
  } else {
    const double xi = std::max(coordinate(x) / (t - arrival_), star_.velocity);
    W = exact_riemann::sample_right(behind_, star_, problem_.gamma, xi);
  }
  W.pressure -= problem_.p_inf;
  return along(W, normal_);
}

ExactSolid ElasticPistonShock::solid(const Point<2>& X, double t) const {
  const double xi = coordinate(X), v = star_.velocity;
  const double initial_slope = (problem_.reference_pressure - problem_.pressure) / modulus_;
  const double after = std::max(0.0, t - arrival_ + xi / speed_);
  double velocity = after > 0 ? v : 0, displacement = initial_slope * xi + v * after;
  double slope = initial_slope + velocity / speed_;
  if (problem_.back != SolidBack::open) {
    const double sign = problem_.back == SolidBack::fixed ? -1 : 1;
    const double returned = std::max(0.0, t - arrival_ - (xi + 2 * problem_.length) / speed_);
    displacement += sign * v * returned;
    if (returned > 0) {
      velocity += sign * v;
      slope -= sign * v / speed_;
    }
  }
  return plane_motion(problem_.material, normal_, normal_, velocity, displacement, slope);
}

std::optional<ExactInterface> ElasticPistonShock::interface_at(const Point<2>& X, double t) const {
  const bool hit = t > arrival_;
  return ExactInterface{X + moved(t) * normal_, (hit ? star_.velocity : 0.0) * normal_,
                        (hit ? star_.pressure : ahead_.pressure) - problem_.p_inf};
}

double ElasticPistonShock::valid_until() const {
  return problem_.back == SolidBack::open ? std::numeric_limits<double>::infinity()
                                          : arrival_ + 2 * problem_.length / speed_;
}

}  // namespace mortise
