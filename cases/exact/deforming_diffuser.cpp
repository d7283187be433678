#include "mortise/cases/exact/deforming_diffuser.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/prandtl_meyer.hpp"

namespace mortise {
namespace {

constexpr int surface_harmonics = 40;  // of the shapes of the wall

}  // namespace

std::function<double(double)> cosine_wall(double amplitude, double period) {
  return [=](double X) { return -amplitude * (1 - std::cos(2 * std::numbers::pi * X / period)); };
}

DeformingDiffuser::DeformingDiffuser(const DeformingDiffuserProblem& problem, int harmonics)
    : problem_(problem),
      mach_(problem.speed / std::sqrt(problem.gamma * problem.pressure / problem.density)),
      angle_(prandtl_meyer_angle(mach_, problem.gamma)),
      strip_(problem.material, PeriodicSeries(problem.wall, problem.period, surface_harmonics), problem.height,
             harmonics) {
  equilibrate();
  for (const int component : {0, 1}) displacement_.push_back(surface_displacement(component));
}

/// The wall at the reference abscissa X and the gas on it, for a displacement of the top and its derivative along X.
DeformingDiffuser::Wall DeformingDiffuser::deformed(double X, const Point<2>& displacement,
                                                    const Point<2>& displacement_slope) const {
  Wall wall;
  wall.position = Point<2>(X, strip_.top().value(X)) + displacement;
  wall.tangent = Point<2>(1, strip_.top().slope(X)) + displacement_slope;
  wall.angle = std::atan2(wall.tangent[1], wall.tangent[0]);
  wall.mach = mach_at_angle(angle_ - wall.angle, problem_.gamma, mach_);
  return wall;
}

DeformingDiffuser::Wall DeformingDiffuser::wall(double X) const {
  return deformed(X, {displacement_[0].value(X), displacement_[1].value(X)},
                  {displacement_[0].slope(X), displacement_[1].slope(X)});
}

PeriodicSeries DeformingDiffuser::surface_displacement(int component) const {
  return {[&](double X) {
            return strip_({X, strip_.top().value(X)}).displacement[component];
          },
          problem_.period, surface_harmonics};
}

double DeformingDiffuser::pressure_at(double mach) const {
  return problem_.pressure * isentropic_pressure_ratio(mach, problem_.gamma) /
         isentropic_pressure_ratio(mach_, problem_.gamma);
}

void DeformingDiffuser::equilibrate() {
  std::vector<Point<2>> tractions(static_cast<std::size_t>(strip_.points()), Point<2>::Zero());
  for (int iteration = 0; iteration < 200; ++iteration) {
    double change = 0;
    for (int i = 0; i < strip_.points(); ++i) {
      const Point<2> X = strip_.point(i), along_top(1, strip_.top().slope(X[0]));
      const ExactSolid solid = strip_(X);
      const Wall here = deformed(X[0], solid.displacement, solid.gradient * along_top);
      const double stretch = here.tangent.norm() / along_top.norm();
      const double area = problem_.load == LoadLaw::current_area ? stretch : 1;
      const Point<2> normal = left_of(here.tangent.normalized());
      const Point<2> load = -(pressure_at(here.mach) - problem_.reference_pressure) * area * normal;
      change = std::max(change, (load - tractions[static_cast<std::size_t>(i)]).norm());
      tractions[static_cast<std::size_t>(i)] = load;
    }
    strip_.load(tractions);
    if (change < 1e-14 * problem_.pressure) return;
  }
  throw NumericalError("the gas and the elastic strip of the deforming diffuser find no equilibrium");
}

/// How far right of x, at its height, the characteristic from the wall at X passes.
double DeformingDiffuser::overshoot(double X, const Point<2>& x) const {
  const Wall from = wall(X);
  const double slope = std::tan(from.angle + std::asin(1 / from.mach));
  return from.position[0] + (x[1] - from.position[1]) / slope - x[0];
}

/// Finds the wall point whose characteristic passes through x by the Illinois variant of the false position: below the
/// height where they first cross, characteristics pass in the order of their wall points.
Primitive<2> DeformingDiffuser::state(const Point<2>& x, double /*t*/) const {
  const double run = 1 / std::tan(std::asin(1 / mach_));  // of the undisturbed characteristics, along x per height
  double low = x[0] - 2 * run * std::max(0.0, x[1]) - 0.2 * problem_.period, high = x[0] + 0.2 * problem_.period;
  double at_low = overshoot(low, x), at_high = overshoot(high, x), X = high;
  for (int iteration = 0; iteration < 100 && std::abs(high - low) > 1e-15; ++iteration) {
    X = (low * at_high - high * at_low) / (at_high - at_low);
    const double here = overshoot(X, x);
    if (std::abs(here) < 1e-14 * problem_.period) break;
    if (here * at_high < 0) {
      low = high;
      at_low = at_high;
    } else {
      at_low *= 0.5;
    }
    high = X;
    at_high = here;
  }
  const Wall from = wall(X);
  const double p = pressure_at(from.mach);
  const double density = problem_.density * std::pow(p / problem_.pressure, 1 / problem_.gamma);
  const double speed = from.mach * std::sqrt(problem_.gamma * p / density);
  return {density, {speed * std::cos(from.angle), speed * std::sin(from.angle)}, p};
}

ExactSolid DeformingDiffuser::solid(const Point<2>& X, double /*t*/) const { return strip_(X); }

std::optional<ExactInterface> DeformingDiffuser::interface_at(const Point<2>& X, double /*t*/) const {
  const Wall here = wall(X[0]);
  return ExactInterface{here.position, Point<2>::Zero(), pressure_at(here.mach)};
}

}  // namespace mortise
