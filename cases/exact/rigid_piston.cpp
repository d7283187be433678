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
    : problem_(problem),
      width_(width),
      motion_(std::make_shared<const PistonMotion>(problem)),
      valid_until_(problem.time_end) {
  const WallMotion wall{[motion = motion_](double t) { return motion->position(t); },
                        [motion = motion_](double t) { return motion->velocity(t); },
                        [motion = motion_](double t) { return motion->acceleration(t); }, problem.time_end};
  if (problem_.left) left_.emplace(*problem_.left, problem_.gamma, -1, wall);
  if (problem_.right) right_.emplace(*problem_.right, problem_.gamma, 1, wall);
  for (const auto& wave : {left_, right_})
    if (wave) valid_until_ = std::min(valid_until_, wave->valid_until());
}

Primitive<1> RigidPiston::state(const Point<1>& x, double t) const {
  const double moved = motion_->position(t) - motion_->position(0);
  const double n = !left_ || (right_ && x[0] >= motion_->position(t)) ? 1 : -1;
  const double from_face = n * (x[0] - motion_->position(0)) - 0.5 * width_;
  Primitive<1> W = (n > 0 ? *right_ : *left_).state(std::max(from_face, n * moved), t);
  W.pressure -= problem_.p_inf;
  return W;
}

std::optional<std::vector<ExactMotion<1>>> RigidPiston::bodies(double t) const {
  ExactMotion<1> motion;
  motion.pose.position[0] = motion_->position(t);
  motion.velocity[0] = motion_->velocity(t);
  return std::vector<ExactMotion<1>>{motion};
}

}  // namespace mortise
