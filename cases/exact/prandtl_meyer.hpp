// Steady simple waves of supersonic flow (Prandtl-Meyer): turning by dθ away from the stream changes ν(M) by dθ,
//   ν(M) = √((γ+1)/(γ−1)) atan √((γ−1)/(γ+1) (M² − 1)) − atan √(M² − 1),
// at constant entropy and total enthalpy; characteristics lie at the Mach angle asin 1/M to the flow.
// Source: Anderson, Modern Compressible Flow, sections 4.14-4.15.
#pragma once

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {

inline double prandtl_meyer_angle(double mach, double gamma) {
  const double ratio = (gamma + 1) / (gamma - 1), root = std::sqrt(mach * mach - 1);
  return std::sqrt(ratio) * std::atan(root / std::sqrt(ratio)) - std::atan(root);
}

/// The Mach number with that ν, from a guess by Newton: dν/dM = √(M² − 1)/(M (1 + (γ−1)/2 M²)). Throws NumericalError
/// where the flow would become subsonic.
inline double mach_at_angle(double nu, double gamma, double guess) {
  double mach = guess;
  for (int iteration = 0; iteration < 50 && mach > 1; ++iteration) {
    const double slope = std::sqrt(mach * mach - 1) / (mach * (1 + 0.5 * (gamma - 1) * mach * mach));
    const double change = (nu - prandtl_meyer_angle(mach, gamma)) / slope;
    mach += change;
    if (std::abs(change) < 1e-14 * mach) return mach;
  }
  throw NumericalError("no supersonic flow has the Prandtl-Meyer angle " + std::to_string(nu));
}

/// Pressure over stagnation pressure; the density's ratio is its power 1/γ.
inline double isentropic_pressure_ratio(double mach, double gamma) {
  return std::pow(1 + 0.5 * (gamma - 1) * mach * mach, -gamma / (gamma - 1));
}

}  // namespace mortise
