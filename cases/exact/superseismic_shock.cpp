#include "mortise/cases/exact/superseismic_shock.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/fluid/shock.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const Point<2> outward(0, 1);  // reference normal of the surface

/// Direction in which a wave of speed c leaves a foot of speed V downwards.
Point<2> wave_normal(double speed, double foot_speed) {
  const double ratio = speed / foot_speed;
  return {ratio, -std::sqrt(1 - ratio * ratio)};
}

}  // namespace

SuperseismicShock::SuperseismicShock(const SuperseismicShockProblem& problem)
    : problem_(problem),
      pressure_speed_(std::sqrt(pressure_modulus(problem.material) / problem.material.density)),
      shear_speed_(std::sqrt(problem.material.mu / problem.material.density)),
      ahead_{problem.density, {0, 0}, problem.pressure + problem.p_inf} {
  if (!(problem.foot_speed > pressure_speed_))
    throw InputError("the shock is not superseismic: its foot moves at " + std::to_string(problem.foot_speed) +
                     ", pressure waves at " + std::to_string(pressure_speed_));
  pressure_normal_ = wave_normal(pressure_speed_, problem.foot_speed);
  shear_normal_ = wave_normal(shear_speed_, problem.foot_speed);
  solve();
  behind_ = behind(angle_);
}

/// The gas behind a shock whose normal is tilted by `angle` towards the solid.
Primitive<2> SuperseismicShock::behind(double angle) const {
  const double c = std::sqrt(problem_.gamma * ahead_.pressure / ahead_.density);
  const std::array<double, 2> n{std::cos(angle), -std::sin(angle)};
  return behind_shock(ahead_, problem_.foot_speed * n[0] / c, problem_.gamma, n);
}

Point<2> SuperseismicShock::surface_velocity(const Point<2>& amplitudes) const {
  return amplitudes[0] * pressure_speed_ * pressure_normal_ + amplitudes[1] * shear_speed_ * left_of(shear_normal_);
}

/// ∇u behind both waves.
Eigen::Matrix2d SuperseismicShock::gradient(const Point<2>& amplitudes) const {
  return -amplitudes[0] * pressure_normal_ * pressure_normal_.transpose() -
         amplitudes[1] * left_of(shear_normal_) * shear_normal_.transpose();
}

/// Velocity through the surface, and traction in excess of the load: all vanish at the foot.
Eigen::Vector3d SuperseismicShock::defect(double angle, const Point<2>& amplitudes) const {
  const Primitive<2> gas = behind(angle);
  const Point<2> U = surface_velocity(amplitudes);
  Point<2> normal(U[1] / problem_.foot_speed, 1 - U[0] / problem_.foot_speed);
  const double stretch = normal.norm();
  normal /= stretch;
  const double area = problem_.load == LoadLaw::current_area ? stretch : 1;
  const double load = gas.pressure - problem_.p_inf - problem_.reference_pressure;
  const Point<2> traction = linear_stress(problem_.material, gradient(amplitudes)) * outward + load * area * normal;
  const Point<2> slip = Point<2>(gas.velocity[0], gas.velocity[1]) - U;
  return {slip.dot(normal), traction[0], traction[1]};
}

/// Newton from a plane shock and a solid at rest, with a Jacobian by central differences.
void SuperseismicShock::solve() {
  Eigen::Vector3d unknowns = Eigen::Vector3d::Zero();
  const auto defect_at = [this](const Eigen::Vector3d& y) { return defect(y[0], {y[1], y[2]}); };
  for (int iteration = 0; iteration < 100; ++iteration) {
    Eigen::Matrix3d jacobian;
    const double h = 1e-6;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
      jacobian.col(k) = (defect_at(unknowns + step) - defect_at(unknowns - step)) / (2 * h);
    }
    const Eigen::Vector3d change = jacobian.partialPivLu().solve(defect_at(unknowns));
    unknowns -= change;
    if (change.cwiseAbs().maxCoeff() <= 1e-15) {
      angle_ = unknowns[0];
      amplitudes_ = unknowns.tail<2>();
      return;
    }
  }
  throw NumericalError("no attached shock satisfies the conditions at the foot of the superseismic shock");
}

Primitive<2> SuperseismicShock::state(const Point<2>& x, double t) const {
  const double distance = std::cos(angle_) * (x[0] - problem_.foot_speed * t) - std::sin(angle_) * x[1];
  Primitive<2> W = distance > 0 ? ahead_ : behind_;
  W.pressure -= problem_.p_inf;
  return W;
}

ExactSolid SuperseismicShock::solid(const Point<2>& X, double t) const {
  const double passed_p = std::max(0.0, pressure_speed_ * t - pressure_normal_.dot(X));
  const double passed_s = std::max(0.0, shear_speed_ * t - shear_normal_.dot(X));
  const auto wave = [&](double amplitude, double speed, const Point<2>& k, const Point<2>& d, double passed) {
    const bool behind_wave = passed > 0;
    return plane_motion(problem_.material, k, d, behind_wave ? amplitude * speed : 0, amplitude * passed,
                        behind_wave ? -amplitude : 0);
  };
  ExactSolid sum = wave(amplitudes_[0], pressure_speed_, pressure_normal_, pressure_normal_, passed_p);
  sum += wave(amplitudes_[1], shear_speed_, shear_normal_, left_of(shear_normal_), passed_s);
  return sum;
}

std::optional<ExactInterface> SuperseismicShock::interface_at(const Point<2>& X, double t) const {
  const ExactSolid surface = solid(X, t);
  const bool passed = X[0] < problem_.foot_speed * t;
  return ExactInterface{X + surface.displacement, surface.velocity,
                        (passed ? behind_ : ahead_).pressure - problem_.p_inf};
}

}  // namespace mortise
