#include "mortise/cases/exact/shock_on_massless_body.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const BodyDescription& massless_slab(const CaseDescription& description) {
  const std::string what = "the exact solution \"shock_on_massless_body\" needs ";
  if (description.initial.kind != "shock") throw InputError(what + "initial.kind = \"shock\"");
  if (description.bodies.size() != 1 || description.bodies[0].shape != "slab")
    throw InputError(what + "exactly one body, of shape \"slab\"");
  const BodyDescription& body = description.bodies[0];
  if (body.mass.value_or(1) != 0 && body.density.value_or(1) != 0) throw InputError(what + "a body of mass 0");
  if (!body.motion_x.empty() || !body.force_x.empty())
    throw InputError(what + "a free body without force or prescribed motion");
  return body;
}

Primitive<1> on_the_line(const std::array<double, 4>& state) { return {state[0], {state[1]}, state[3]}; }

/// Speed of the one shock between the two states; throws if they do not satisfy the Rankine-Hugoniot relations.
double speed_between(const Primitive<1>& left, const Primitive<1>& right, double gamma, double p_inf) {
  const double mass_left = left.density * left.velocity[0], mass_right = right.density * right.velocity[0];
  const double speed = (mass_left - mass_right) / (left.density - right.density);
  const auto energy = [&](const Primitive<1>& W) {
    return (W.pressure + gamma * p_inf) / (gamma - 1) + 0.5 * W.density * W.velocity[0] * W.velocity[0];
  };
  const double momentum_defect = mass_left * left.velocity[0] + left.pressure - mass_right * right.velocity[0] -
                                 right.pressure - speed * (mass_left - mass_right);
  const double energy_defect = left.velocity[0] * (energy(left) + left.pressure) -
                               right.velocity[0] * (energy(right) + right.pressure) -
                               speed * (energy(left) - energy(right));
  const double scale = std::max(std::abs(left.pressure), std::abs(right.pressure)) + p_inf +
                       std::abs(mass_left * left.velocity[0]) + std::abs(mass_right * right.velocity[0]);
  const double speed_scale = std::abs(speed) + std::abs(left.velocity[0]) + std::abs(right.velocity[0]);
  const double tolerance = 1e-5;  // case files give states to six digits and more
  if (!(std::abs(momentum_defect) < tolerance * scale && std::abs(energy_defect) < tolerance * scale * speed_scale))
    throw InputError("the states of the initial shock do not satisfy the Rankine-Hugoniot relations");
  return speed;
}

}  // namespace

ShockOnMasslessBody::ShockOnMasslessBody(const CaseDescription& description) {
  const BodyDescription& body = massless_slab(description);
  const InitialDescription& initial = description.initial;
  left_ = on_the_line(initial.left);
  right_ = on_the_line(initial.right);
  width_ = body.width;
  face_ = body.position[0] + 0.5 * width_;
  const bool from_the_left = initial.position < body.position[0];
  shock_position_ = initial.position + (from_the_left ? width_ : 0);
  shock_speed_ = speed_between(left_, right_, description.gamma, description.p_inf);
  velocity_before_ = (from_the_left ? right_ : left_).velocity[0];
  velocity_after_ = (from_the_left ? left_ : right_).velocity[0];
  arrival_ = (face_ - shock_position_) / (shock_speed_ - velocity_before_);
  if (!(arrival_ >= 0)) arrival_ = std::numeric_limits<double>::infinity();
}

Primitive<1> ShockOnMasslessBody::shock_alone(double x, double t) const {
  return x < shock_position_ + shock_speed_ * t ? left_ : right_;
}

Primitive<1> ShockOnMasslessBody::state(const Point<1>& x, double t) const {
  const double center = (*bodies(t))[0].pose.position[0];
  const double shifted =
      x[0] < center ? std::min(x[0], center - 0.5 * width_) + width_ : std::max(x[0], center + 0.5 * width_);
  return shock_alone(shifted, t);
}

std::optional<std::vector<ExactMotion<1>>> ShockOnMasslessBody::bodies(double t) const {
  const double before = std::min(t, arrival_), after = t - before;
  ExactMotion<1> motion;
  motion.pose.position[0] = face_ - 0.5 * width_ + velocity_before_ * before + velocity_after_ * after;
  motion.velocity[0] = t < arrival_ ? velocity_before_ : velocity_after_;
  return std::vector<ExactMotion<1>>{motion};
}

}  // namespace mortise
