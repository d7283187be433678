// Rankine-Hugoniot relations of a plane shock moving along the unit normal n into a gas (ρ1, u1, p̃1) with Mach number
// M = (S − u1·n)/c1 ≥ 1, S the shock speed in the frame of the coordinates:
//   p̃2/p̃1 = 1 + 2γ/(γ+1) (M² − 1),  ρ2/ρ1 = (γ+1)M²/((γ−1)M² + 2),  (u2 − u1)·n = 2c1/(γ+1) (M − 1/M).
// Source: Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, section 3.1.3. p̃ is the shifted pressure.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "mortise/fluid/state.hpp"

namespace mortise {

/// Unit vector along the first coordinate.
template <int Dim>
constexpr std::array<double, Dim> along_x() {
  std::array<double, Dim> n{};
  n[0] = 1;
  return n;
}

/// State behind a shock of Mach number `mach` ≥ 1 that moves along `normal` (unit vector) into `ahead`.
template <int Dim>
inline Primitive<Dim> behind_shock(const Primitive<Dim>& ahead, double mach, double gamma,
                                   const std::type_identity_t<std::array<double, Dim>>& normal = along_x<Dim>()) {
  const double c = std::sqrt(gamma * ahead.pressure / ahead.density), square = mach * mach;
  const double jump = 2 * c / (gamma + 1) * (mach - 1 / mach);
  Primitive<Dim> behind;
  behind.density = ahead.density * (gamma + 1) * square / ((gamma - 1) * square + 2);
  for (std::size_t d = 0; d < Dim; ++d) behind.velocity[d] = ahead.velocity[d] + jump * normal[d];
  behind.pressure = ahead.pressure * (1 + 2 * gamma / (gamma + 1) * (square - 1));
  return behind;
}

/// Speed of that shock along `normal`: S = u1·n + M c1.
template <int Dim>
inline double shock_speed(const Primitive<Dim>& ahead, double mach, double gamma,
                          const std::type_identity_t<std::array<double, Dim>>& normal = along_x<Dim>()) {
  double speed = mach * std::sqrt(gamma * ahead.pressure / ahead.density);
  for (std::size_t d = 0; d < Dim; ++d) speed += ahead.velocity[d] * normal[d];
  return speed;
}

}  // namespace mortise
