#include "mortise/cases/exact/isentropic_vortex.hpp"

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {
using std::numbers::pi;

/// 1 − T where e = 1.
double temperature_deficit(double gamma, double strength) {
  return (gamma - 1) * strength * strength / (8 * gamma * pi * pi);
}
}  // namespace

IsentropicVortex::IsentropicVortex(const CaseDescription& description)
    : gamma_(description.gamma),
      strength_(description.initial.strength),
      radius_(description.initial.vortex_radius),
      center_(description.initial.vortex_center.data()),
      velocity_(description.initial.vortex_velocity.data()) {
  if (description.p_inf != 0) throw InputError("the exact solution \"vortex\" needs an ideal gas, gas.p_inf = 0");
  if (temperature_deficit(gamma_, strength_) * std::numbers::e >= 1)
    throw InputError("initial.strength = " + std::to_string(strength_) + " leaves no gas in the centre of the vortex");
}

Primitive<2> IsentropicVortex::state(const Point<2>& x, double t) const {
  const Point<2> X = (x - center_ - t * velocity_) / radius_;
  const double e = std::exp(0.5 * (1 - X.squaredNorm()));
  const double temperature = 1 - temperature_deficit(gamma_, strength_) * e * e;
  const double density = std::pow(temperature, 1 / (gamma_ - 1)), swirl = strength_ * e / (2 * pi);
  return {density, {velocity_[0] - swirl * X[1], velocity_[1] + swirl * X[0]}, density * temperature};
}

}  // namespace mortise
