#include "mortise/cases/exact/rigid_piston.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/initial_state.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const BodyDescription& piston_body(const CaseDescription& description) {
  const std::string what = "the exact solution \"rigid_piston\" needs ";
  if (description.bodies.size() != 1) throw InputError(what + "exactly one body");
  const BodyDescription& body = description.bodies[0];
  if (body.shape != "slab" && body.shape != "half_space")
    throw InputError(what + "a body of shape \"slab\" or \"half_space\", seen \"" + body.shape + "\"");
  if (body.shape == "half_space" && body.side != "left" && body.side != "right")
    throw InputError(what + "side = \"left\" or \"right\" for a half_space, seen \"" + body.side + "\"");
  if (body.motion_x.empty() && !body.mass && !(body.density && body.shape == "slab"))
    throw InputError(what + "the mass of the body, or its motion_x");
  if (!body.fixed.empty()) throw InputError(what + "a body without fixed directions");
  return body;
}

/// The formula of t; an empty one is no function.
std::function<double(double)> function_of_time(const std::string& formula) {
  if (formula.empty()) return {};
  return [expression = Expression(formula, {"t"})](double t) { return expression(t); };
}

double width_of(const BodyDescription& body) { return body.shape == "slab" ? body.width : 0.0; }

PistonProblem problem_of(const CaseDescription& description) {
  const BodyDescription& body = piston_body(description);
  PistonProblem problem;
  problem.gamma = description.gamma;
  problem.p_inf = description.p_inf;
  problem.mass = body.mass ? *body.mass : body.density.value_or(0) * width_of(body);
  problem.position = body.position[0];
  problem.velocity = body.velocity[0];
  problem.force = [force = function_of_time(body.force_x), weight = problem.mass * description.gravity[0]](double t) {
    return weight + (force ? force(t) : 0.0);
  };
  problem.displacement = function_of_time(body.motion_x);
  problem.time_end = description.time_end;
  const InitialState<1> initial(description);
  const auto gas_at = [&](double n) {
    const double beside = n * (0.5 * width_of(body) + 1e-9 * (description.domain_high[0] - description.domain_low[0]));
    Primitive<1> gas = initial(Point<1>(body.position[0] + beside));
    gas.pressure += description.p_inf;
    return gas;
  };
  const bool half_space = body.shape == "half_space";
  if (!half_space || body.side == "right") problem.left = gas_at(-1);
  if (!half_space || body.side == "left") problem.right = gas_at(1);
  return problem;
}

}  // namespace

RigidPiston::RigidPiston(const CaseDescription& description)
    : RigidPiston(problem_of(description), width_of(description.bodies[0])) {}

RigidPiston::RigidPiston(const PistonProblem& problem, double width)
    : problem_(problem), width_(width), motion_(problem), valid_until_(problem.time_end) {
  if (problem_.left) valid_until_ = std::min(valid_until_, end_of_simple_wave(*problem_.left, -1));
  if (problem_.right) valid_until_ = std::min(valid_until_, end_of_simple_wave(*problem_.right, 1));
}

double RigidPiston::wall_sound_speed(const Primitive<1>& gas, double n, double tau) const {
  const double c0 = std::sqrt(problem_.gamma * gas.pressure / gas.density);
  return c0 + 0.5 * (problem_.gamma - 1) * n * (motion_.velocity(tau) - gas.velocity[0]);
}

double RigidPiston::end_of_simple_wave(const Primitive<1>& gas, double n) const {
  const double c0 = std::sqrt(problem_.gamma * gas.pressure / gas.density);
  if (n * (motion_.velocity(0) - gas.velocity[0]) > 1e-10 * c0) return 0;
  double end = problem_.time_end;
  for (double tau = 0; tau < end; tau += motion_.step()) {
    const double c = wall_sound_speed(gas, n, tau), acceleration = n * motion_.acceleration(tau);
    if (c <= 0) return tau;
    if (acceleration > 0) end = std::min(end, tau + 2 * c / ((problem_.gamma + 1) * acceleration));
  }
  return end;
}

/// Root τ of X(τ) + (v + c)(t − τ) = x on [0, t], where the left side decreases with τ; Newton, kept inside a bracket.
double RigidPiston::emission_time(const Primitive<1>& gas, double n, double distance, double t) const {
  const double x0 = motion_.position(0);
  double low = 0, high = t;
  double tau = t * std::clamp(1 - distance / (t * (n * motion_.velocity(0) + wall_sound_speed(gas, n, 0))), 0.0, 1.0);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double c = wall_sound_speed(gas, n, tau);
    const double excess = n * (motion_.position(tau) - x0) + (n * motion_.velocity(tau) + c) * (t - tau) - distance;
    (excess > 0 ? low : high) = tau;
    const double slope = 0.5 * (problem_.gamma + 1) * n * motion_.acceleration(tau) * (t - tau) - c;
    double next = tau - excess / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - tau);
    tau = next;
    if (change <= 1e-13 * t) break;
  }
  return tau;
}

/// State at a distance from the wall's place at t = 0, measured along n (from the wall into the gas).
Primitive<1> RigidPiston::simple_wave(const Primitive<1>& gas, double n, double distance, double t) const {
  const double gamma = problem_.gamma, u0 = n * gas.velocity[0], c0 = std::sqrt(gamma * gas.pressure / gas.density);
  const double first = n * motion_.velocity(0) + wall_sound_speed(gas, n, 0);  // speed of the first characteristic
  if (t <= 0 || distance >= std::max(u0 + c0, first) * t) return gas;
  double u;
  if (distance > first * t) {
    u = (2 * (distance / t - c0) + (gamma - 1) * u0) / (gamma + 1);
  } else {
    u = n * motion_.velocity(emission_time(gas, n, distance, t));
  }
  const double k = std::max(0.0, 1 + 0.5 * (gamma - 1) * (u - u0) / c0);
  return {gas.density * std::pow(k, 2 / (gamma - 1)), {n * u}, gas.pressure * std::pow(k, 2 * gamma / (gamma - 1))};
}

Primitive<1> RigidPiston::state(const Point<1>& x, double t) const {
  const double moved = motion_.position(t) - motion_.position(0);
  const double n = !problem_.left || (problem_.right && x[0] >= motion_.position(t)) ? 1 : -1;
  const double from_face = n * (x[0] - motion_.position(0)) - 0.5 * width_;
  Primitive<1> W = simple_wave(n > 0 ? *problem_.right : *problem_.left, n, std::max(from_face, n * moved), t);
  W.pressure -= problem_.p_inf;
  return W;
}

std::optional<std::vector<ExactMotion<1>>> RigidPiston::bodies(double t) const {
  ExactMotion<1> motion;
  motion.pose.position[0] = motion_.position(t);
  motion.velocity[0] = motion_.velocity(t);
  return std::vector<ExactMotion<1>>{motion};
}

}  // namespace mortise
