#include "mortise/cases/exact/radial_gas.hpp"

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

Primitive<1> combine(double a, const Primitive<1>& x, double b, const Primitive<1>& y) {
  return {a * x.density + b * y.density, {a * x.velocity[0] + b * y.velocity[0]}, a * x.pressure + b * y.pressure};
}

/// State on a face between `left` (smaller radius) and `right` that moves with speed w.
Primitive<1> acoustic_state(const Primitive<1>& left, const Primitive<1>& right, double w, double gamma) {
  const double z = std::sqrt(0.25 * gamma * (left.pressure + right.pressure) * (left.density + right.density));
  const double u = 0.5 * (left.velocity[0] + right.velocity[0]) + 0.5 * (left.pressure - right.pressure) / z;
  const double p = 0.5 * (left.pressure + right.pressure) + 0.5 * z * (left.velocity[0] - right.velocity[0]);
  const Primitive<1>& upwind = u > w ? left : right;
  return {upwind.density * (1 + (p - upwind.pressure) / (gamma * upwind.pressure)), {u}, p};
}

}  // namespace

RadialGas::RadialGas(double gamma, const Primitive<1>& rest, double near, double far, int cells)
    : gamma_(gamma),
      rest_(rest),
      near_(near),
      far_(far),
      state_(static_cast<std::size_t>(cells), rest),
      slope_(state_.size()),
      half_(state_.size()) {}

/// What lies beyond `far` for the state `last` on this side of it: its mirror image, or gas at rest.
Primitive<1> RadialGas::behind_the_end(const Primitive<1>& last) const {
  if (far_ > near_) return rest_;
  return {last.density, {-last.velocity[0]}, last.pressure};
}

void RadialGas::predict(double dt, double speed) {
  const std::size_t n = state_.size();
  for (std::size_t i = 1; i < n; ++i) {
    const Primitive<1> after = i + 1 < n ? state_[i + 1] : behind_the_end(state_[i]);
    slope_[i] = combine(0.5, after, -0.5, state_[i - 1]);
  }
  slope_[0] = combine(1, combine(-1.5, state_[0], 2, state_[1]), -0.5, state_[2]);
  const double h = spacing();
  for (std::size_t i = 0; i < n; ++i) {
    const double theta = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double r = near_ + theta * (far_ - near_), w = (1 - theta) * speed;
    const Primitive<1>&W = state_[i], D = combine(1 / h, slope_[i], 0, W);
    const double u = W.velocity[0], divergence = D.velocity[0] + u / r;
    half_[i].density = W.density - dt * ((u - w) * D.density + W.density * divergence);
    half_[i].velocity[0] = u - dt * ((u - w) * D.velocity[0] + D.pressure / W.density);
    half_[i].pressure = W.pressure - dt * ((u - w) * D.pressure + gamma_ * W.pressure * divergence);
  }
}

Primitive<1> RadialGas::trace() const { return combine(1, half_[0], -0.5, slope_[0]); }

void RadialGas::advance(double dt, double near, double pressure) {
  const std::size_t n = state_.size();
  const double sign = far_ > near_ ? 1 : -1, speed = (near - near_) / dt;
  const auto radius = [&](double end, std::size_t face) {
    const double theta = static_cast<double>(face) / static_cast<double>(n);
    return end + theta * (far_ - end);
  };
  const auto volume = [](double a, double b) { return 0.5 * std::abs(b * b - a * a); };
  // Outflow (r F per unit time and radian, F relative to the moving face, along the order of the cells) through the
  // face before cell i.
  const auto flux = [&](std::size_t i, double area) -> Conserved<1> {
    if (i == 0) return {0, {sign * area * pressure}, sign * area * pressure * speed};
    const double w = (1 - static_cast<double>(i) / static_cast<double>(n)) * speed;
    const Primitive<1> before = combine(1, half_[i - 1], 0.5, slope_[i - 1]);
    const Primitive<1> after = i < n ? combine(1, half_[i], -0.5, slope_[i]) : behind_the_end(before);
    const Primitive<1> W =
        sign > 0 ? acoustic_state(before, after, w, gamma_) : acoustic_state(after, before, w, gamma_);
    const Conserved<1> U = to_conserved(W, gamma_);
    const double through = sign * area * (W.velocity[0] - w);
    return {through * U.density,
            {through * U.momentum[0] + sign * area * W.pressure},
            through * U.energy + sign * area * W.pressure * W.velocity[0]};
  };
  double area = 0.5 * (near_ + near);
  Conserved<1> entering = flux(0, area);
  for (std::size_t i = 0; i < n; ++i) {
    const double next_area = 0.5 * (radius(near_, i + 1) + radius(near, i + 1));
    const Conserved<1> leaving = flux(i + 1, next_area);
    const double old_volume = volume(radius(near_, i), radius(near_, i + 1));
    const double inverse = 1 / volume(radius(near, i), radius(near, i + 1));
    const Conserved<1> U = to_conserved(state_[i], gamma_);
    const double source = half_[i].pressure * sign * (next_area - area);
    Conserved<1> V;
    V.density = inverse * (old_volume * U.density + dt * (entering.density - leaving.density));
    V.momentum[0] = inverse * (old_volume * U.momentum[0] + dt * (entering.momentum[0] - leaving.momentum[0] + source));
    V.energy = inverse * (old_volume * U.energy + dt * (entering.energy - leaving.energy));
    state_[i] = to_primitive(V, gamma_);
    if (!(state_[i].density > 0 && state_[i].pressure > 0))
      throw NumericalError("the radial reference solution fails in the gas at r = " + std::to_string(radius(near, i)));
    area = next_area;
    entering = leaving;
  }
  near_ = near;
}

}  // namespace mortise
