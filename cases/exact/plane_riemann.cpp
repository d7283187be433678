#include "mortise/cases/exact/plane_riemann.hpp"

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

template <int Dim>
Point<Dim> velocity_of(const std::array<double, 4>& state) {
  Point<Dim> velocity;
  for (int d = 0; d < Dim; ++d) velocity[d] = state[static_cast<std::size_t>(d) + 1];
  return velocity;
}

Primitive<1> admissible(const char* side, const std::array<double, 4>& state, double normal_velocity, double p_inf) {
  if (!(state[0] > 0) || !(state[3] + p_inf > 0))
    throw InputError(std::string("the ") + side +
                     " state of the Riemann problem needs density > 0 and pressure + p_inf > 0, seen density " +
                     std::to_string(state[0]) + " and pressure " + std::to_string(state[3]));
  return {state[0], {normal_velocity}, state[3] + p_inf};
}

}  // namespace

template <int Dim>
PlaneRiemann<Dim>::PlaneRiemann(const CaseDescription& description)
    : gamma_(description.gamma),
      p_inf_(description.p_inf),
      position_(description.initial.position),
      normal_(Point<Dim>::Zero()) {
  const InitialDescription& initial = description.initial;
  if (initial.kind != "riemann" && initial.kind != "shock")
    throw InputError("the exact solution \"riemann\" needs initial.kind = \"riemann\" or \"shock\", seen \"" +
                     initial.kind + "\"");
  normal_[0] = 1;
  if constexpr (Dim > 1) {
    const double angle = initial.angle * std::numbers::pi / 180;
    normal_[0] = std::cos(angle);
    normal_[1] = std::sin(angle);
  }
  const Point<Dim> ul = velocity_of<Dim>(initial.left), ur = velocity_of<Dim>(initial.right);
  left_ = admissible("left", initial.left, normal_.dot(ul), p_inf_);
  right_ = admissible("right", initial.right, normal_.dot(ur), p_inf_);
  tangential_left_ = ul - normal_ * normal_.dot(ul);
  tangential_right_ = ur - normal_ * normal_.dot(ur);
  star_ = exact_star_state(left_, right_, gamma_);
}

template <int Dim>
Primitive<Dim> PlaneRiemann<Dim>::state(const Point<Dim>& x, double t) const {
  const double s = normal_.dot(x) - position_;
  Primitive<1> line;
  bool left_of_contact;
  if (t > 0) {
    line = sample(star_, left_, right_, gamma_, s / t);
    left_of_contact = s < star_.velocity * t;
  } else {
    left_of_contact = s < 0;
    line = left_of_contact ? left_ : right_;
  }
  const Point<Dim> u = line.velocity[0] * normal_ + (left_of_contact ? tangential_left_ : tangential_right_);
  Primitive<Dim> W;
  W.density = line.density;
  for (std::size_t d = 0; d < Dim; ++d) W.velocity[d] = u[static_cast<Eigen::Index>(d)];
  W.pressure = line.pressure - p_inf_;
  return W;
}

template class PlaneRiemann<1>;
template class PlaneRiemann<2>;

}  // namespace mortise
