// Pressure of a gas on a moving wall (the piston relation). The gas (ρ, p̃) next to the wall moves at v_f·n, the wall
// at v·n, n from the solid into the fluid; with d = (v − v_f)·n, c² = γp̃/ρ, z = ρc the wave the wall sends gives
//   d ≥ 0, shock:  P = p̃ + a d² + d √(a² d² + z²),  a = (γ+1)ρ/4
//   d < 0, fan:    P = p̃ k^(2γ/(γ−1)),  k = 1 + (γ−1) d/(2c);  k ≤ 0: vacuum, P = 0
//   linear:        P = p̃ + z d.
// P and dP/dd are continuous at d = 0, where dP/dd = z. Sources: Toro, Riemann Solvers, section 4.2; Banks & Sjögreen,
// Commun. Comput. Phys. 10 (2011) 279, section 3. All pressures are shifted ones, p̃ = p + p∞ (state.hpp).
#pragma once

#include <cmath>

namespace mortise {

struct WallResponse {
  double pressure = 0;   // P, p̃ on the wall
  double impedance = 0;  // dP/dd ≥ 0
};

/// The simple-wave relation P = p̃ k^(2γ/(γ−1)) for either sign of d: exact for fans and for compressions without a
/// shock.
inline WallResponse isentropic_wall_response(double density, double pressure, double velocity_difference,
                                             double gamma) {
  const double c = std::sqrt(gamma * pressure / density);
  const double k = 1 + (gamma - 1) * velocity_difference / (2 * c);
  if (k <= 0) return {0, 0};
  const double power = std::pow(k, (gamma + 1) / (gamma - 1));
  return {pressure * power * k, density * c * power};
}

/// The non-linear relation. density, pressure (p̃) > 0; any d.
inline WallResponse wall_response(double density, double pressure, double velocity_difference, double gamma) {
  const double d = velocity_difference;
  if (d < 0) return isentropic_wall_response(density, pressure, d, gamma);
  const double ad = 0.25 * (gamma + 1) * density * d;
  const double root = std::sqrt(ad * ad + gamma * pressure * density);
  return {pressure + d * (ad + root), 2 * ad + root + ad * ad / root};
}

/// The linear (acoustic) relation. May be negative: d < −c/γ.
inline WallResponse linear_wall_response(double density, double pressure, double velocity_difference, double gamma) {
  const double z = std::sqrt(gamma * pressure * density);
  return {pressure + z * velocity_difference, z};
}

/// Density behind the wave that takes the gas to the pressure P ≥ 0: the shock relation for P > p̃, the isentrope ρ
/// (P/p̃)^(1/γ) otherwise.
inline double wall_density(double density, double pressure, double wall_pressure, double gamma) {
  const double ratio = wall_pressure / pressure, g = (gamma - 1) / (gamma + 1);
  return density * (ratio > 1 ? (ratio + g) / (1 + g * ratio) : std::pow(ratio, 1 / gamma));
}

}  // namespace mortise
