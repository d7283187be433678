#include "mortise/cases/exact/elastic_piston.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/piston_motion.hpp"

namespace mortise {
namespace {

constexpr int panels_per_crossing = 256;  // of the integrals, in the time a wave takes through the solid

double crossing_time(const ElasticPistonProblem& problem) {
  return problem.length * std::sqrt(problem.material.density / pressure_modulus(problem.material));
}

/// Interface times that the solution refers to: time_end and the time a wave takes through the solid, in whole
/// crossings, so that reflections at the back of a bar fall on the ends of panels.
int crossings(const ElasticPistonProblem& problem) {
  return static_cast<int>(std::ceil(problem.time_end / crossing_time(problem))) + 1;
}

double covered(const ElasticPistonProblem& problem) { return crossings(problem) * crossing_time(problem); }

SimpleWave gas_of(const ElasticPistonProblem& problem, const RunningIntegral& moved) {
  const Primitive<1> gas{problem.density, {0}, problem.pressure + problem.p_inf};
  const auto acceleration = [w = problem.velocity, h = problem.time_end / 500](double t) {
    return derivative(w, t, h);
  };
  return {gas, problem.gamma, 1, {moved, problem.velocity, acceleration, problem.time_end}};
}

}  // namespace

ElasticPistonProblem power_of_time(ElasticPistonProblem problem, double amplitude, double exponent) {
  problem.velocity = [amplitude, exponent](double t) { return amplitude * exponent * std::pow(t, exponent - 1); };
  return problem;
}

ElasticPiston::ElasticPiston(const ElasticPistonProblem& problem)
    : problem_(problem),
      normal_(direction(problem.angle)),
      modulus_(pressure_modulus(problem.material)),
      speed_(std::sqrt(modulus_ / problem.material.density)),
      moved_(problem.velocity, covered(problem), panels_per_crossing * crossings(problem)),
      gas_(gas_of(problem, moved_)),
      impulse_([gas = gas_,
                total = problem.reference_pressure + problem.p_inf](double t) { return total - gas.wall_pressure(t); },
               covered(problem), panels_per_crossing * crossings(problem)) {
  if (problem.left_going_slope)
    initial_left_going_.emplace([slope = problem.left_going_slope](double s) { return slope(-s); }, problem.length,
                                panels_per_crossing);
}

double ElasticPiston::stress(double t) const {
  return problem_.reference_pressure + problem_.p_inf - gas_.wall_pressure(t);
}

/// (f, f') at −c t.
ElasticPiston::Wave ElasticPiston::right_going(double t) const {
  return {0.5 * (moved_(t) - speed_ / modulus_ * impulse_(t)),
          0.5 * (stress(t) / modulus_ - problem_.velocity(t) / speed_)};
}

/// (g, g') at c t.
ElasticPiston::Wave ElasticPiston::left_going(double t) const {
  if (t < 0 && initial_left_going_)
    return {-(*initial_left_going_)(-speed_ * t), problem_.left_going_slope(speed_ * t)};
  const double from = std::max(0.0, t);
  const double slope = 0.5 * (stress(from) / modulus_ + problem_.velocity(from) / speed_);
  return {t < 0 ? speed_ * t * slope : 0.5 * (moved_(t) + speed_ / modulus_ * impulse_(t)), slope};
}

ExactSolid ElasticPiston::solid(const Point<2>& X, double t) const {
  const double delay = coordinate(X) / speed_;
  const Wave f = right_going(t - delay), g = left_going(t + delay);
  return plane_motion(problem_.material, normal_, normal_, speed_ * (g.slope - f.slope), f.value + g.value,
                      f.slope + g.slope);
}

Primitive<2> ElasticPiston::state(const Point<2>& x, double t) const {
  Primitive<1> W = gas_.state(std::max(coordinate(x), moved_(t)), t);
  W.pressure -= problem_.p_inf;
  return along(W, normal_);
}

std::optional<ExactInterface> ElasticPiston::interface_at(const Point<2>& X, double t) const {
  return ExactInterface{X + moved_(t) * normal_, problem_.velocity(t) * normal_,
                        gas_.wall_pressure(t) - problem_.p_inf};
}

}  // namespace mortise
