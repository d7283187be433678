// MUSCL-Hancock reconstruction of a cell in primitive variables W = (ρ, u, p̃), second order.
// 1. Slopes: half of the limited undivided slope, h_d = ½δ_d, along each grid direction d (limiters.hpp).
// 2. Positivity: |h_d| ≤ 0.9 q for q = ρ and p̃. As ρ and p̃ are themselves the reconstructed variables this keeps every
//    face value at or above 0.1 q; the slopes of the velocity need no change, they cannot make ρ or p̃ negative.
// 3. Half step (van Leer 1984; Toro, Riemann Solvers, 3rd ed., section 14.4), quasi-linear form in the moving frame:
//      W½ = W − ½ Δt/V Σ_d A_d δ_d,  A δ = (q δρ + ρ S·δu,  q δu + S δp̃/ρ,  q δp̃ + γ p̃ S·δu),  q = (u − w)·S
//    with S and w·S the means over the two opposite faces, at half time. Uniform flow is kept exactly on any grid.
// 4. Face states W½ ± h_d. If one of the 2 Dim states of a cell has ρ or p̃ ≤ 0, all of them are the cell average W.
#pragma once

#include <array>

#include "mortise/grids/core/limiters.hpp"
#include "mortise/fluid/state.hpp"

namespace mortise {

/// Half slopes of a cell along each direction.
template <int Dim, class T>
struct HalfSlopes {
  MORTISE_INLINE Primitive<Dim, T>& operator[](std::size_t d) { return along[d]; }
  MORTISE_INLINE const Primitive<Dim, T>& operator[](std::size_t d) const { return along[d]; }
  std::array<Primitive<Dim, T>, Dim> along;
};

template <int Dim, class T>
MORTISE_INLINE Primitive<Dim, T> operator+(const Primitive<Dim, T>& a, const Primitive<Dim, T>& b) {
  Primitive<Dim, T> sum;
  sum.density = a.density + b.density;
  for (std::size_t d = 0; d < Dim; ++d) sum.velocity[d] = a.velocity[d] + b.velocity[d];
  sum.pressure = a.pressure + b.pressure;
  return sum;
}
template <int Dim, class T>
MORTISE_INLINE Primitive<Dim, T> operator-(const Primitive<Dim, T>& a, const Primitive<Dim, T>& b) {
  Primitive<Dim, T> difference;
  difference.density = a.density - b.density;
  for (std::size_t d = 0; d < Dim; ++d) difference.velocity[d] = a.velocity[d] - b.velocity[d];
  difference.pressure = a.pressure - b.pressure;
  return difference;
}
/// W = fallback where the mask is false.
template <class Mask, int Dim, class T>
MORTISE_INLINE void keep_where(Mask m, Primitive<Dim, T>& W, const Primitive<Dim, T>& fallback) {
  W.density = select(m, W.density, fallback.density);
  for (std::size_t d = 0; d < Dim; ++d) W.velocity[d] = select(m, W.velocity[d], fallback.velocity[d]);
  W.pressure = select(m, W.pressure, fallback.pressure);
}

/// Steps 1 and 2 along one direction. floor: ε² per variable, for Limiter::van_albada.
template <Limiter limiter, int Dim, class T>
MORTISE_INLINE Primitive<Dim, T> limited_half_slopes(const Primitive<Dim, T>& before, const Primitive<Dim, T>& here,
                                                     const Primitive<Dim, T>& after, const Primitive<Dim>& floor) {
  const Primitive<Dim, T> a = here - before, b = after - here;
  Primitive<Dim, T> h;
  h.density = limit_magnitude(half_slope<limiter>(a.density, b.density, floor.density), 0.9 * here.density);
  for (std::size_t d = 0; d < Dim; ++d)
    h.velocity[d] = half_slope<limiter>(a.velocity[d], b.velocity[d], floor.velocity[d]);
  h.pressure = limit_magnitude(half_slope<limiter>(a.pressure, b.pressure, floor.pressure), 0.9 * here.pressure);
  return h;
}

/// The geometry in A_d, times Δt/V (a half slope is half of δ, so the factor ½ is in it).
template <int Dim, class T>
struct HalfStepTerms {
  std::array<T, Dim> speed;  // Δt/V (u − w)·S_d
  T divergence;              // Δt/V Σ_d S_d·h_d(u)
  std::array<T, Dim> force;  // Δt/V Σ_d S_d h_d(p̃)
};

/// Terms of a Cartesian cell at rest; courant[d] = Δt/h_d.
template <int Dim, class T>
MORTISE_INLINE HalfStepTerms<Dim, T> cartesian_terms(const Primitive<Dim, T>& W, const HalfSlopes<Dim, T>& h,
                                                     const double* courant) {
  HalfStepTerms<Dim, T> terms;
  terms.divergence = courant[0] * h[0].velocity[0];
  for (std::size_t d = 0; d < Dim; ++d) {
    terms.speed[d] = courant[d] * W.velocity[d];
    terms.force[d] = courant[d] * h[d].pressure;
    if (d > 0) terms.divergence = terms.divergence + courant[d] * h[d].velocity[d];
  }
  return terms;
}

/// Step 3: W½.
template <int Dim, class T>
MORTISE_INLINE Primitive<Dim, T> half_step(const Primitive<Dim, T>& W, T inverse_density, const HalfSlopes<Dim, T>& h,
                                           const HalfStepTerms<Dim, T>& terms, double gamma) {
  const auto advected = [&](auto component) {
    T sum = terms.speed[0] * component(h[0]);
    for (std::size_t d = 1; d < Dim; ++d) sum = sum + terms.speed[d] * component(h[d]);
    return sum;
  };
  Primitive<Dim, T> half;
  half.density = W.density - (advected([](const auto& s) { return s.density; }) + W.density * terms.divergence);
  for (std::size_t e = 0; e < Dim; ++e)
    half.velocity[e] =
        W.velocity[e] - (advected([e](const auto& s) { return s.velocity[e]; }) + inverse_density * terms.force[e]);
  half.pressure =
      W.pressure - (advected([](const auto& s) { return s.pressure; }) + (gamma * W.pressure) * terms.divergence);
  return half;
}

/// Step 4: where a face state would not be positive, half = W and h = 0. The face states are half ∓ h[d].
template <int Dim, class T>
MORTISE_INLINE void ensure_positive_faces(const Primitive<Dim, T>& W, Primitive<Dim, T>& half, HalfSlopes<Dim, T>& h) {
  T density_drop = abs(h[0].density), pressure_drop = abs(h[0].pressure);
  for (std::size_t d = 1; d < Dim; ++d) {
    density_drop = larger_magnitude(density_drop, h[d].density);
    pressure_drop = larger_magnitude(pressure_drop, h[d].pressure);
  }
  const T lowest = min(half.density - density_drop, half.pressure - pressure_drop);
  if (all_positive(lowest)) return;
  const auto good = lowest > 0;
  keep_where(good, half, W);
  for (std::size_t d = 0; d < Dim; ++d) keep_where(good, h[d], Primitive<Dim, T>{});
}

}  // namespace mortise
