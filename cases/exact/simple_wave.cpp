#include "mortise/cases/exact/simple_wave.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/fluid/wall_pressure.hpp"

namespace mortise {
namespace {

constexpr int samples = 4096;  // of the motion, where the end of the simple wave is looked for

}  // namespace

SimpleWave::SimpleWave(const Primitive<1>& gas, double gamma, double n, WallMotion wall)
    : gas_(gas),
      gamma_(gamma),
      n_(n),
      wall_(std::move(wall)),
      c0_(std::sqrt(gamma * gas.pressure / gas.density)),
      valid_until_(end()) {}

double SimpleWave::wall_sound_speed(double tau) const {
  return c0_ + 0.5 * (gamma_ - 1) * n_ * (wall_.velocity(tau) - gas_.velocity[0]);
}

double SimpleWave::wall_pressure(double t) const {
  const double difference = n_ * (wall_.velocity(t) - gas_.velocity[0]);
  return isentropic_wall_response(gas_.density, gas_.pressure, difference, gamma_).pressure;
}

double SimpleWave::end() const {
  if (n_ * (wall_.velocity(0) - gas_.velocity[0]) > 1e-10 * c0_) return 0;
  double end = wall_.time_end;
  const double step = wall_.time_end / samples;
  for (double tau = 0; tau < end; tau += step) {
    const double c = wall_sound_speed(tau), acceleration = n_ * wall_.acceleration(tau);
    if (c <= 0) return tau;
    if (acceleration > 0) end = std::min(end, tau + 2 * c / ((gamma_ + 1) * acceleration));
  }
  return end;
}

/// Root τ of X(τ) + (v + c)(t − τ) = x on [0, t], where the left side decreases with τ; Newton, kept inside a bracket.
double SimpleWave::emission_time(double distance, double t) const {
  const double x0 = wall_.position(0);
  double low = 0, high = t;
  double tau = t * std::clamp(1 - distance / (t * (n_ * wall_.velocity(0) + wall_sound_speed(0))), 0.0, 1.0);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double c = wall_sound_speed(tau);
    const double excess = n_ * (wall_.position(tau) - x0) + (n_ * wall_.velocity(tau) + c) * (t - tau) - distance;
    (excess > 0 ? low : high) = tau;
    const double slope = 0.5 * (gamma_ + 1) * n_ * wall_.acceleration(tau) * (t - tau) - c;
    double next = tau - excess / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - tau);
    tau = next;
    if (change <= 1e-13 * t) break;
  }
  return tau;
}

/// The gas with velocity u along n in the simple wave.
Primitive<1> SimpleWave::isentropic(double u) const {
  const double k = std::max(0.0, 1 + 0.5 * (gamma_ - 1) * (u - n_ * gas_.velocity[0]) / c0_);
  return {
      gas_.density * std::pow(k, 2 / (gamma_ - 1)), {n_ * u}, gas_.pressure * std::pow(k, 2 * gamma_ / (gamma_ - 1))};
}

Primitive<1> SimpleWave::state(double distance, double t) const {
  const double u0 = n_ * gas_.velocity[0], first = n_ * wall_.velocity(0) + wall_sound_speed(0);
  if (t <= 0 || distance >= std::max(u0 + c0_, first) * t) return gas_;
  if (distance > first * t) return isentropic((2 * (distance / t - c0_) + (gamma_ - 1) * u0) / (gamma_ + 1));
  return isentropic(n_ * wall_.velocity(emission_time(distance, t)));
}

}  // namespace mortise
