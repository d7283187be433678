#include "mortise/cases/exact/deforming_diffuser.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/prandtl_meyer.hpp"

namespace mortise {
namespace {

/// The wall without load and its slope, functions of X.
std::function<double(double)> wavy_top(const DeformingDiffuserProblem& problem) {
  return [A = problem.amplitude, k = 2 * std::numbers::pi / problem.period](double X) {
    return -A * (1 - std::cos(k * X));
  };
}
std::function<double(double)> wavy_slope(const DeformingDiffuserProblem& problem) {
  return
      [A = problem.amplitude, k = 2 * std::numbers::pi / problem.period](double X) { return -A * k * std::sin(k * X); };
}

}  // namespace

DeformingDiffuser::DeformingDiffuser(const DeformingDiffuserProblem& problem, int harmonics)
    : problem_(problem),
      mach_(problem.speed / std::sqrt(problem.gamma * problem.pressure / problem.density)),
      angle_(prandtl_meyer_angle(mach_, problem.gamma)),
      strip_(problem.material, problem.period, problem.height, wavy_top(problem), wavy_slope(problem), harmonics) {
  equilibrate();
}

/// The deformed wall at the reference abscissa X and the gas on it.
DeformingDiffuser::Wall DeformingDiffuser::wall(double X) const {
  const Point<2> reference(X, strip_.top(X)), along_top(1, strip_.top_slope(X));
  const ExactSolid solid = strip_(reference);
  Wall wall;
  wall.position = reference + solid.displacement;
  wall.tangent = along_top + solid.gradient * along_top;
  wall.angle = std::atan2(wall.tangent[1], wall.tangent[0]);
  wall.mach = mach_at_angle(angle_ - wall.angle, problem_.gamma, mach_);
  return wall;
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
      const double X = strip_.point(i)[0];
      const Wall here = wall(X);
      const double stretch = here.tangent.norm() / Point<2>(1, strip_.top_slope(X)).norm();
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

/// The wall point whose characteristic passes through x, by the Illinois variant of the false position: seen along the
/// wall, characteristics that do not cross arrive at the height of x in order.
Primitive<2> DeformingDiffuser::state(const Point<2>& x, double /*t*/) const {
  const auto overshoot = [&](double X) {
    const Wall from = wall(X);
    const double slope = std::tan(from.angle + std::asin(1 / from.mach));
    return from.position[0] + (x[1] - from.position[1]) / slope - x[0];
  };
  const double reach = 0.1 * problem_.period + 4 * std::max(0.0, x[1] + 2 * problem_.amplitude);
  double low = x[0] - reach, high = x[0] + 0.1 * problem_.period;
  double at_low = overshoot(low), at_high = overshoot(high), X = x[0];
  for (int iteration = 0; iteration < 100; ++iteration) {
    X = (low * at_high - high * at_low) / (at_high - at_low);
    const double here = overshoot(X);
    if (std::abs(here) < 1e-14) break;
    if (here * at_high < 0) {
      low = high;
      at_low = at_high;
    } else {
      at_low *= 0.5;
    }
    high = X;
    at_high = here;
    if (std::abs(high - low) < 1e-15) break;
  }
  const Wall from = wall(X);
  const double p = pressure_at(from.mach),
               density = problem_.density * std::pow(p / problem_.pressure, 1 / problem_.gamma);
  const double speed = from.mach * std::sqrt(problem_.gamma * p / density);
  return {density, {speed * std::cos(from.angle), speed * std::sin(from.angle)}, p};
}

ExactSolid DeformingDiffuser::solid(const Point<2>& X, double /*t*/) const { return strip_(X); }

std::optional<ExactInterface> DeformingDiffuser::interface_at(const Point<2>& X, double /*t*/) const {
  const Wall here = wall(X[0]);
  return ExactInterface{here.position, Point<2>::Zero(), pressure_at(here.mach)};
}

}  // namespace mortise
