#include "mortise/cases/exact/piston_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr int steps_covered = 4096;

const double root6 = std::sqrt(6.0);
const Eigen::Vector3d radau_nodes{(4 - root6) / 10, (4 + root6) / 10, 1};
const Eigen::Matrix3d radau{{(88 - 7 * root6) / 360, (296 - 169 * root6) / 1800, (-2 + 3 * root6) / 225},
                            {(296 + 169 * root6) / 1800, (88 + 7 * root6) / 360, (-2 - 3 * root6) / 225},
                            {(16 - root6) / 36, (16 + root6) / 36, 1.0 / 9}};

/// Coefficients of θ, θ², θ³ of the cubic that is 0 at θ = 0 and has the given values at the nodes.
Eigen::Vector3d cubic_through(const Eigen::Vector3d& values) {
  static const Eigen::Matrix3d inverse = [] {
    Eigen::Matrix3d vandermonde;
    for (int i = 0; i < 3; ++i)
      vandermonde.row(i) << radau_nodes[i], radau_nodes[i] * radau_nodes[i],
          radau_nodes[i] * radau_nodes[i] * radau_nodes[i];
    return Eigen::Matrix3d(vandermonde.inverse());
  }();
  return inverse * values;
}

}  // namespace

PistonMotion::PistonMotion(const PistonProblem& problem)
    : problem_(problem), step_(problem.time_end / steps_covered), difference_(problem.time_end / 500) {
  for (const auto& gas : {problem_.left, problem_.right})
    if (gas) round_off_ = std::max(round_off_, 1e-14 * std::sqrt(problem_.gamma * gas->pressure / gas->density));
  double x = problem_.position, v = problem_.velocity;
  if (problem_.displacement) {
    v = derivative(problem_.displacement, 0, difference_);
  } else if (problem_.mass == 0) {
    v = balanced_velocity(problem_.right ? problem_.right->velocity[0] : problem_.left->velocity[0]);
  }
  for (int k = 0; k < steps_covered; ++k) {
    const double t = k * step_;
    if (problem_.displacement) x = problem_.position + problem_.displacement(t);
    const Eigen::Vector3d stages = problem_.displacement ? prescribed_stages(t) : free_stages(t, v);
    const Eigen::Vector3d slopes = cubic_through(stages.array() - v);
    steps_.push_back({x, v, slopes});
    x += step_ * (v + slopes.dot(Eigen::Vector3d{1.0 / 2, 1.0 / 3, 1.0 / 4}));
    v = stages[2];
  }
}

/// Force on the piston with velocity v (.pressure) and its decrease with v (.impedance).
WallResponse PistonMotion::net_force(double t, double v) const {
  WallResponse force{problem_.force ? problem_.force(t) : 0.0, 0};
  const auto add = [&](const std::optional<Primitive<1>>& gas, double n) {
    if (!gas) return;
    const WallResponse wall =
        isentropic_wall_response(gas->density, gas->pressure, n * (v - gas->velocity[0]), problem_.gamma);
    force.pressure -= n * (wall.pressure - problem_.p_inf);
    force.impedance += wall.impedance;
  };
  add(problem_.left, -1);
  add(problem_.right, 1);
  return force;
}

/// Root of the net force at t = 0.
double PistonMotion::balanced_velocity(double guess) const {
  double v = guess;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const WallResponse force = net_force(0, v);
    const double change = force.pressure / force.impedance;
    v += change;
    if (std::abs(change) <= round_off_ + 1e-14 * std::abs(v)) return v;
  }
  throw NumericalError("no velocity balances the forces on the massless piston at t = 0");
}

/// Velocities at the three stages: m (V_i − v) = Δt Σ_j a_ij F(t_j, V_j), by Newton.
Eigen::Vector3d PistonMotion::free_stages(double t, double v) const {
  Eigen::Vector3d stages = Eigen::Vector3d::Constant(v);
  if (!steps_.empty()) {  // the last cubic, continued
    const Step& last = steps_.back();
    for (int i = 0; i < 3; ++i) {
      const double theta = 1 + radau_nodes[i];
      stages[i] = last.velocity + theta * (last.slopes[0] + theta * (last.slopes[1] + theta * last.slopes[2]));
    }
  }
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Vector3d force, impedance;
    for (int i = 0; i < 3; ++i) {
      const WallResponse response = net_force(t + radau_nodes[i] * step_, stages[i]);
      force[i] = response.pressure;
      impedance[i] = response.impedance;
    }
    const Eigen::Vector3d residual = problem_.mass * (stages.array() - v).matrix() - step_ * radau * force;
    Eigen::Matrix3d jacobian = step_ * radau * impedance.asDiagonal();
    jacobian.diagonal().array() += problem_.mass;
    const Eigen::Vector3d change = jacobian.partialPivLu().solve(residual);
    stages -= change;
    if (change.cwiseAbs().maxCoeff() <= round_off_ + 1e-14 * stages.cwiseAbs().maxCoeff()) return stages;
  }
  throw NumericalError("the velocity of the piston was not found at t = " + std::to_string(t));
}

Eigen::Vector3d PistonMotion::prescribed_stages(double t) const {
  return radau_nodes.unaryExpr([&](double c) { return derivative(problem_.displacement, t + c * step_, difference_); });
}

std::pair<const PistonMotion::Step*, double> PistonMotion::locate(double t) const {
  const int k = std::clamp(static_cast<int>(t / step_), 0, steps_covered - 1);
  return {&steps_[static_cast<std::size_t>(k)], t / step_ - k};
}

double PistonMotion::position(double t) const {
  const auto [s, theta] = locate(t);
  const double change =
      s->velocity + theta * (s->slopes[0] / 2 + theta * (s->slopes[1] / 3 + theta * s->slopes[2] / 4));
  return s->position + step_ * theta * change;
}

double PistonMotion::velocity(double t) const {
  const auto [s, theta] = locate(t);
  return s->velocity + theta * (s->slopes[0] + theta * (s->slopes[1] + theta * s->slopes[2]));
}

double PistonMotion::acceleration(double t) const {
  const auto [s, theta] = locate(t);
  return (s->slopes[0] + theta * (2 * s->slopes[1] + theta * 3 * s->slopes[2])) / step_;
}

double derivative(const std::function<double(double)>& f, double t, double h) {
  if (t >= 3 * h) {
    const double first = f(t + h) - f(t - h), second = f(t + 2 * h) - f(t - 2 * h), third = f(t + 3 * h) - f(t - 3 * h);
    return (45 * first - 9 * second + third) / (60 * h);
  }
  const double forward = -2.45 * f(t) + 6 * f(t + h) - 7.5 * f(t + 2 * h) + 20.0 / 3 * f(t + 3 * h) -
                         3.75 * f(t + 4 * h) + 1.2 * f(t + 5 * h) - f(t + 6 * h) / 6;
  return forward / h;
}

}  // namespace mortise
