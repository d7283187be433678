#include "mortise/cases/exact/weak_shock_on_cylinder.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mortise/cases/exact/acoustic_cylinder.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

const BodyDescription& free_cylinder(const CaseDescription& description) {
  const std::string what = "the exact solution \"weak_shock_on_free_cylinder\" needs ";
  if (description.initial.kind != "shock") throw InputError(what + "initial.kind = \"shock\"");
  if (description.bodies.size() != 1 || description.bodies[0].shape != "circle")
    throw InputError(what + "exactly one body, of shape \"circle\"");
  const BodyDescription& body = description.bodies[0];
  if (!body.mass && !body.density) throw InputError(what + "the density or the mass of the body");
  if (!body.motion_x.empty() || !body.motion_y.empty() || !body.force_x.empty() || !body.force_y.empty() ||
      !body.fixed.empty() || description.gravity != std::array<double, 2>{})
    throw InputError(what + "a free body without gravity");
  return body;
}

}  // namespace

WeakShockOnCylinder::WeakShockOnCylinder(const CaseDescription& description) {
  const BodyDescription& body = free_cylinder(description);
  const auto &behind = description.initial.left, &ahead = description.initial.right;
  const double angle = description.initial.angle * std::numbers::pi / 180;
  normal_ = {std::cos(angle), std::sin(angle)};
  start_ = {{body.position[0], body.position[1]}, body.angle * std::numbers::pi / 180};
  start_velocity_ = {body.velocity[0], body.velocity[1]};
  radius_ = body.radius;
  const double density = ahead[0];
  density_ratio_ = body.mass ? *body.mass / (std::numbers::pi * radius_ * radius_ * density) : *body.density / density;
  sound_speed_ = std::sqrt(description.gamma * (ahead[3] + description.p_inf) / density);
  const double u_behind = normal_.dot(Point<2>(behind[1], behind[2])),
               u_ahead = normal_.dot(Point<2>(ahead[1], ahead[2]));
  if (std::abs(normal_.dot(start_velocity_) - u_ahead) > 1e-12 * sound_speed_)
    throw InputError(
        "the exact solution \"weak_shock_on_free_cylinder\" needs a body that moves with the gas ahead of the shock");
  velocity_unit_ = (behind[3] - ahead[3]) / (density * sound_speed_);
  const double shock_speed = (behind[0] * u_behind - density * u_ahead) / (behind[0] - density);
  const double gap = normal_.dot(start_.position) - description.initial.position - radius_;
  first_touch_ = gap / (shock_speed - u_ahead);
  if (!(first_touch_ >= 0))
    throw InputError(
        "the exact solution \"weak_shock_on_free_cylinder\" needs a shock that starts behind the body and moves "
        "towards it");
}

Primitive<2> WeakShockOnCylinder::state(const Point<2>&, double) const {
  throw std::logic_error("the acoustic solution for a free cylinder describes the body, not the fluid");
}

std::optional<std::vector<ExactMotion<2>>> WeakShockOnCylinder::bodies(double t) const {
  const double time = sound_speed_ * (t - first_touch_) / radius_;
  const double displacement =
      radius_ * velocity_unit_ / sound_speed_ * acoustic_cylinder_displacement(time, density_ratio_);
  ExactMotion<2> motion;
  motion.pose = start_;
  motion.pose.position += start_velocity_ * t + normal_ * displacement;
  motion.velocity = start_velocity_ + normal_ * (velocity_unit_ * acoustic_cylinder_velocity(time, density_ratio_));
  return std::vector<ExactMotion<2>>{motion};
}

}  // namespace mortise
