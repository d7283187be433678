// Euler states. The equation of state is ideal or stiffened gas, p = (γ − 1) ρ e − γ p∞. With the shifted
// pressure p̃ = p + p∞ and the shifted energy Ẽ = E − p∞ a stiffened gas obeys exactly the ideal-gas equations
// (∇p̃ = ∇p, Ẽ + p̃ = E + p, c² = γ p̃/ρ), so every kernel below is written for the ideal gas and works with p̃ and Ẽ;
// p∞ appears only where pressures enter from or leave to the outside (case files, wall forces, output).
#pragma once

#include <array>

#include "mortise/grids/core/simd.hpp"

namespace mortise {

/// Equation of state. Non-dimensional.
struct Gas {
  double gamma = 1.4;  // ratio of specific heats, > 1
  double p_inf = 0;    // p∞ of a stiffened gas, ≥ 0; 0: ideal gas
};

/// Components of the conserved field: ρ, ρu (Dim numbers), Ẽ.
template <int Dim>
inline constexpr int euler_components = Dim + 2;

/// (ρ, u, p̃); T is double or Pack.
template <int Dim, class T = double>
struct Primitive {
  T density{};
  std::array<T, Dim> velocity{};
  T pressure{};  // p̃ = p + p∞
};

/// (ρ, ρu, Ẽ), Ẽ = p̃/(γ − 1) + ½ρ|u|².
template <int Dim, class T = double>
struct Conserved {
  T density{};
  std::array<T, Dim> momentum{};
  T energy{};
};

template <int Dim, class T>
inline Primitive<Dim, T> to_primitive(const Conserved<Dim, T>& U, double gamma) {
  const T inverse = 1.0 / U.density;
  Primitive<Dim, T> W;
  W.density = U.density;
  T twice_kinetic = U.momentum[0] * U.momentum[0];
  for (std::size_t d = 0; d < Dim; ++d) {
    W.velocity[d] = U.momentum[d] * inverse;
    if (d > 0) twice_kinetic = twice_kinetic + U.momentum[d] * U.momentum[d];
  }
  W.pressure = (gamma - 1) * (U.energy - 0.5 * (twice_kinetic * inverse));
  return W;
}

template <int Dim, class T>
inline Conserved<Dim, T> to_conserved(const Primitive<Dim, T>& W, double gamma) {
  Conserved<Dim, T> U;
  U.density = W.density;
  T speed2 = W.velocity[0] * W.velocity[0];
  for (std::size_t d = 0; d < Dim; ++d) {
    U.momentum[d] = W.density * W.velocity[d];
    if (d > 0) speed2 = speed2 + W.velocity[d] * W.velocity[d];
  }
  U.energy = W.pressure / (gamma - 1) + 0.5 * (W.density * speed2);
  return U;
}

}  // namespace mortise
