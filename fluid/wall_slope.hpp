// Slope of the cell next to a wall along the normal, made by a state W₋₁ in the place of the ghost behind the wall, for
// the limiter to work on as anywhere else. With W₀, W₁, W₂ from the wall into the gas, b = W₁ − W₀, c = W₂ − W₁,
//   W₋₁ = W₀ − φ (2b − c).
// φ = 1 continues the parabola through the three cells: the slope of W₀ is then of second order, as in all other cells;
// the difference b alone is of first. Beside a shock the parabola overshoots, so with a limiter φ falls there:
//   φ = max(0, (2 b_p c_p + ε)/(b_p² + c_p² + ε)),  ε = (½ p̃₁)²,  b_p, c_p: b and c of p̃,
// van Albada's ratio of the pressure differences, which knows shocks from contacts. Differences well below half the
// pressure are no shock, so that φ − 1 = −(b_p − c_p)²/(…) is O(h⁴) in smooth flow and round-off does not set it.
#pragma once

#include "mortise/fluid/reconstruction.hpp"

namespace mortise {

/// φ from the pressures p̃ > 0 of the three cells next to a wall; T is double or Pack. In [0, 1]; 1 where p̃ is linear.
template <class T>
MORTISE_INLINE T smoothness_at_wall(T wall, T inner, T far) {
  const T b = inner - wall, c = far - inner, floor = 0.25 * (inner * inner);
  return max((2.0 * (b * c) + floor) / (b * b + c * c + floor), T{});
}

/// W₋₁ from W₀ (wall), W₁ (inner) and W₂ (far). Need not be a valid state.
template <Limiter limiter, int Dim, class T>
MORTISE_INLINE Primitive<Dim, T> beyond_wall(const Primitive<Dim, T>& wall, const Primitive<Dim, T>& inner,
                                             const Primitive<Dim, T>& far) {
  T smooth = T{} + 1.0;
  if constexpr (limiter != Limiter::none) smooth = smoothness_at_wall(wall.pressure, inner.pressure, far.pressure);
  const auto continued = [smooth](T w0, T w1, T w2) { return w0 - smooth * (2.0 * (w1 - w0) - (w2 - w1)); };
  Primitive<Dim, T> ghost;
  ghost.density = continued(wall.density, inner.density, far.density);
  for (std::size_t d = 0; d < Dim; ++d)
    ghost.velocity[d] = continued(wall.velocity[d], inner.velocity[d], far.velocity[d]);
  ghost.pressure = continued(wall.pressure, inner.pressure, far.pressure);
  return ghost;
}

}  // namespace mortise
