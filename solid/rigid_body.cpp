#include "mortise/solid/rigid_body.hpp"

namespace mortise {

template <int Dim>
Velocity<Dim> RigidBody<Dim>::mass_diagonal() const {
  Velocity<Dim> diagonal = Velocity<Dim>::Constant(mass);
  if constexpr (Dim == 2) diagonal[2] = inertia;
  return diagonal;
}

template <int Dim>
Point<Dim> RigidBody<Dim>::velocity_at(const Point<Dim>& x) const {
  Point<Dim> v = y.template head<Dim>();
  if constexpr (Dim == 2) {
    const Point<2> arm = x - pose.position;
    v += y[2] * Point<2>(-arm[1], arm[0]);
  }
  return v;
}

template <int Dim>
double RigidBody<Dim>::kinetic_energy() const {
  return 0.5 * y.dot(mass_diagonal().cwiseProduct(y));
}

template <int Dim>
Pose<Dim> advanced(const Pose<Dim>& pose, const Velocity<Dim>& mean, double dt) {
  Pose<Dim> after = pose;
  after.position += dt * mean.template head<Dim>();
  if constexpr (Dim == 2) after.angle += dt * mean[2];
  return after;
}

template struct RigidBody<1>;
template struct RigidBody<2>;
template Pose<1> advanced<1>(const Pose<1>&, const Velocity<1>&, double);
template Pose<2> advanced<2>(const Pose<2>&, const Velocity<2>&, double);

}  // namespace mortise
