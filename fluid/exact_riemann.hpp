// Exact solution of the Riemann problem of the one-dimensional Euler equations,
//   ∂t(ρ, ρu, E) + ∂x(ρu, ρu² + p, u(E + p)) = 0,   (ρ, u, p)(x, 0) = left for x < 0, right for x > 0.
// The star pressure is the root of f_L(p) + f_R(p) + u_R − u_L = 0 with, for K = L, R,
//   f_K = (p − p_K) √(A_K/(p + B_K)), A_K = 2/((γ+1)ρ_K), B_K = (γ−1)/(γ+1) p_K     p > p_K (shock)
//   f_K = 2c_K/(γ−1) [(p/p_K)^((γ−1)/2γ) − 1]                                       p ≤ p_K (fan).
// The sum is increasing and concave, hence Newton stays at or below the root after its first step and needs no
// bracket from above; two fans have a closed form. Source: Toro, Riemann Solvers and Numerical Methods for Fluid
// Dynamics, 3rd ed., sections 4.2-4.6. A stiffened gas is covered by the shifted pressure p̃ (state.hpp).
#pragma once

#include <algorithm>
#include <cmath>

#include "mortise/fluid/state.hpp"
#include "mortise/fluid/wall_pressure.hpp"

namespace mortise {

/// Between the two non-linear waves. With a vacuum: pressure and densities 0, velocity the mean of the two escape
/// speeds.
struct StarState {
  double pressure = 0;       // p̃*
  double velocity = 0;       // u*
  double density_left = 0;   // ρ*L, left of the contact
  double density_right = 0;  // ρ*R, right of the contact
  bool vacuum = false;       // the two fans do not meet
};

namespace exact_riemann {

inline double sound_speed(const Primitive<1>& state, double gamma) {
  return std::sqrt(gamma * state.pressure / state.density);
}

struct WaveCurve {
  double velocity_jump;  // f_K(p)
  double slope;          // f_K'(p)
};

/// f_K and its derivative at pressure p ≥ 0.
inline WaveCurve wave_curve(const Primitive<1>& state, double pressure, double gamma) {
  if (pressure > state.pressure) {
    const double a = 2 / ((gamma + 1) * state.density);
    const double b = (gamma - 1) / (gamma + 1) * state.pressure;
    const double root = std::sqrt(a / (pressure + b));
    const double rise = pressure - state.pressure;
    return {rise * root, root * (1 - 0.5 * rise / (pressure + b))};
  }
  const double c = sound_speed(state, gamma), ratio = pressure / state.pressure;
  const double power = std::pow(ratio, (gamma - 1) / (2 * gamma));
  return {2 * c / (gamma - 1) * (power - 1), power / (ratio * state.density * c)};
}

/// Pressure between two fans; exact where both waves are fans, a guess elsewhere.
inline double two_fan_pressure(const Primitive<1>& left, const Primitive<1>& right, double gamma) {
  const double cl = sound_speed(left, gamma), cr = sound_speed(right, gamma), z = (gamma - 1) / (2 * gamma);
  const double rise = cl + cr - 0.5 * (gamma - 1) * (right.velocity[0] - left.velocity[0]);
  const double scale = std::pow(left.pressure / right.pressure, z);
  return right.pressure * std::pow(std::max(0.0, rise) / (cl / scale + cr), 1 / z);
}

/// Root of f_L + f_R + u_R − u_L, known to exceed the smaller of the two pressures.
inline double newton_pressure(const Primitive<1>& left, const Primitive<1>& right, double gamma) {
  const double low = std::min(left.pressure, right.pressure);
  double pressure = std::max(low, two_fan_pressure(left, right, gamma));
  for (int iteration = 0; iteration < 100; ++iteration) {
    const WaveCurve l = wave_curve(left, pressure, gamma), r = wave_curve(right, pressure, gamma);
    const double excess = l.velocity_jump + r.velocity_jump + (right.velocity[0] - left.velocity[0]);
    const double next = std::max(low, pressure - excess / (l.slope + r.slope));
    const double change = std::abs(next - pressure);
    pressure = next;
    if (change <= 1e-10 * pressure) break;  // quadratic: the error left is of the order of its square
  }
  return pressure;
}

/// Right-going wave between `state` ahead of it and the star state; speeds measured to the right.
inline Primitive<1> sample_right(const Primitive<1>& state, const StarState& star, double gamma, double xi) {
  const double c = sound_speed(state, gamma), u = state.velocity[0], g = (gamma - 1) / (gamma + 1);
  const Primitive<1> behind{star.density_right, {star.velocity}, star.pressure};
  if (star.pressure > state.pressure) {
    const double ratio = star.pressure / state.pressure;
    const double speed = u + c * std::sqrt(((gamma + 1) * ratio + gamma - 1) / (2 * gamma));
    return xi < speed ? behind : state;
  }
  if (xi >= u + c) return state;
  const double escape = u - 2 * c / (gamma - 1);
  if (star.vacuum ? xi <= escape : xi <= star.velocity + sound_speed(behind, gamma))
    return star.vacuum ? Primitive<1>{0, {xi}, 0} : behind;
  const double ratio = 2 / (gamma + 1) - g * (u - xi) / c;
  return {state.density * std::pow(ratio, 2 / (gamma - 1)),
          {2 / (gamma + 1) * (-c + 0.5 * (gamma - 1) * u + xi)},
          state.pressure * std::pow(ratio, 2 * gamma / (gamma - 1))};
}

inline Primitive<1> mirrored(const Primitive<1>& state) {
  return {state.density, {-state.velocity[0]}, state.pressure};
}

}  // namespace exact_riemann

/// Star state of two states with ρ > 0 and p̃ > 0. Relative accuracy a few units of round-off.
inline StarState exact_star_state(const Primitive<1>& left, const Primitive<1>& right, double gamma) {
  using namespace exact_riemann;
  const double cl = sound_speed(left, gamma), cr = sound_speed(right, gamma);
  const double separation = right.velocity[0] - left.velocity[0];
  if (separation >= 2 * (cl + cr) / (gamma - 1)) {
    const double escape = 0.5 * (left.velocity[0] + right.velocity[0]) + (cl - cr) / (gamma - 1);
    return {0, escape, 0, 0, true};
  }
  const double low = std::min(left.pressure, right.pressure);
  const bool two_fans =
      wave_curve(left, low, gamma).velocity_jump + wave_curve(right, low, gamma).velocity_jump + separation >= 0;
  const double pressure = two_fans ? two_fan_pressure(left, right, gamma) : newton_pressure(left, right, gamma);
  const double jump =
      wave_curve(right, pressure, gamma).velocity_jump - wave_curve(left, pressure, gamma).velocity_jump;
  return {pressure, 0.5 * (left.velocity[0] + right.velocity[0]) + 0.5 * jump,
          wall_density(left.density, left.pressure, pressure, gamma),
          wall_density(right.density, right.pressure, pressure, gamma), false};
}

/// State on the ray x/t = ξ, its star state known. In a vacuum ρ = p̃ = 0 and u = ξ.
inline Primitive<1> sample(const StarState& star, const Primitive<1>& left, const Primitive<1>& right, double gamma,
                           double xi) {
  using namespace exact_riemann;
  const bool right_side = star.vacuum ? xi > star.velocity : xi >= star.velocity;
  if (right_side) return sample_right(right, star, gamma, xi);
  const StarState flipped{star.pressure, -star.velocity, star.density_right, star.density_left, star.vacuum};
  return mirrored(sample_right(mirrored(left), flipped, gamma, -xi));
}

/// State on the ray x/t = ξ.
inline Primitive<1> sample(const Primitive<1>& left, const Primitive<1>& right, double gamma, double xi) {
  return sample(exact_star_state(left, right, gamma), left, right, gamma, xi);
}

}  // namespace mortise
