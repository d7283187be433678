#include "mortise/cases/exact/radial_coupling.hpp"

#include <cmath>

#include "mortise/fluid/wall_pressure.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

RadialCoupling::RadialCoupling(const RadialProblem& problem, double gas_end, int solid_cells, int gas_cells)
    : problem_(problem),
      side_(problem.gas_end > problem.interface_radius ? 1 : -1),
      gas_(problem.gamma, {problem.density, {0}, problem.pressure + problem.p_inf}, problem.interface_radius, gas_end,
           gas_cells),
      solid_(problem.material, problem.interface_radius, problem.solid_end, solid_cells, problem.angular_velocity,
             problem.far_stress),
      position_(problem.interface_radius, 0),
      velocity_(0, problem.angular_velocity * problem.interface_radius) {}

/// The fluid-structure Riemann problem between the predicted states, the interface at `position`.
RadialInterface RadialCoupling::project(const Eigen::Vector2d& position) const {
  const Primitive<1> gas = gas_.trace();
  const RadialElastic solid = solid_.trace();
  const double radius = position.norm();
  const double area = problem_.load == LoadLaw::current_area ? radius / problem_.interface_radius : 1;
  const Eigen::Vector2d normal = side_ * position / radius, admittance = solid_.impedance().cwiseInverse();
  const Eigen::Vector2d traction = side_ * solid.stress;
  const double z = 1 / (area * normal.dot(admittance.cwiseProduct(normal)));
  const double v_solid = normal.dot(solid.velocity - admittance.cwiseProduct(traction));
  const double v_gas = side_ * gas.velocity[0], p_e = problem_.pressure + problem_.p_inf;
  double v = v_gas;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const WallResponse wall = wall_response(gas.density, gas.pressure, v - v_gas, problem_.gamma);
    const double change = (p_e - wall.pressure - z * (v - v_solid)) / (z + wall.impedance);
    v += change;
    if (std::abs(change) <= 1e-15 * std::sqrt(problem_.gamma * gas.pressure / gas.density)) break;
  }
  RadialInterface answer;
  answer.position = position;
  answer.pressure = wall_response(gas.density, gas.pressure, v - v_gas, problem_.gamma).pressure;
  answer.traction = -(answer.pressure - p_e) * area * normal;
  answer.velocity = solid.velocity + admittance.cwiseProduct(answer.traction - traction);
  return answer;
}

RadialInterface RadialCoupling::interface_now() {
  gas_.predict(0, 0);
  solid_.predict(0);
  return project(position_);
}

void RadialCoupling::advance_to(double t, int steps) {
  const double dt = (t - time_) / steps;
  for (int k = 0; k < steps; ++k) {
    gas_.predict(0.5 * dt, velocity_.dot(position_) / position_.norm());
    solid_.predict(0.5 * dt);
    const RadialInterface face = project(position_ + 0.5 * dt * velocity_);
    const Eigen::Vector2d next = position_ + dt * face.velocity;
    gas_.advance(dt, next.norm(), face.pressure);
    solid_.advance(time_ + k * dt, dt, {face.velocity, side_ * face.traction, 0});
    position_ = next;
    velocity_ = face.velocity;
  }
  time_ = t;
}

}  // namespace mortise
