#include "mortise/cases/exact/elastic_bar.hpp"

#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/fluid/wall_pressure.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

struct Bar {
  ElasticPistonProblem problem;
  std::function<double(double)> initial_velocity;
  double speed;  // c

  double right_going_slope(double xi) const {
    return xi >= -problem.length ? -initial_velocity(xi) / (2 * speed) : left_going_slope(-2 * problem.length - xi);
  }
  double left_going_slope(double xi) const {
    if (xi <= 0) return initial_velocity(xi) / (2 * speed);
    return interface_velocity(xi / speed) / speed + right_going_slope(-xi);
  }
  double interface_velocity(double t) const {
    const double z = problem.material.density * speed, p = problem.pressure + problem.p_inf;
    const double load = problem.reference_pressure + problem.p_inf - 2 * z * speed * right_going_slope(-speed * t);
    double w = 0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const WallResponse gas = isentropic_wall_response(problem.density, p, w, problem.gamma);
      const double change = (load - gas.pressure - z * w) / (z + gas.impedance);
      w += change;
      if (std::abs(change) <= 1e-15 * speed) return w;
    }
    throw NumericalError("no velocity balances the gas and the elastic bar at t = " + std::to_string(t));
  }
};

}  // namespace

ElasticPistonProblem fixed_bar(ElasticPistonProblem problem, std::function<double(double)> initial_velocity) {
  const double speed = std::sqrt(pressure_modulus(problem.material) / problem.material.density);
  const Bar bar{problem, std::move(initial_velocity), speed};
  problem.velocity = [bar](double t) { return bar.interface_velocity(t); };
  problem.left_going_slope = [bar](double xi) { return bar.left_going_slope(xi); };
  return problem;
}

}  // namespace mortise
