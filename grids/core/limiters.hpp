// Slope limiters. With the differences a = q_i − q_{i−1} and b = q_{i+1} − q_i the undivided slope of a cell is
//   none        δ = ½(a + b)                                                             (central, not monotone)
//   minmod      δ = minmod(a, b)
//   mc          δ = minmod(2a, 2b, ½(a + b))                                             (van Leer 1977)
//   van_albada  δ = (a(b² + ε²) + b(a² + ε²))/(a² + b² + 2ε²), ε² = K h³ q_ref²          (van Albada et al. 1982)
//                 = (a + b)(ab + ε²)/((a + b)² + 2(ε² − ab))
//   flat        δ = 0                                                                    (first order: no cell falls short
//                                                                                         of what its Riemann problems leave)
// All but the last return the common difference where a = b, and are odd: δ(−b, −a) = −δ(a, b), to the bit. The constant ε of van
// Albada's keeps smooth extrema, where the other limiters fall to first order in the maximum norm.
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise {

enum class Limiter { none, minmod, mc, van_albada, flat };

/// Half of the undivided slope, ½δ: what takes a cell's value to its faces. T is double or Pack; `floor` is ε² of
/// Limiter::van_albada and unused otherwise.
template <Limiter limiter, class T>
MORTISE_INLINE T half_slope(T a, T b, double floor) {
  if constexpr (limiter == Limiter::none) {
    return 0.25 * (a + b);
  } else if constexpr (limiter == Limiter::minmod) {
    return select(a * b > 0, 0.5 * smaller_magnitude(a, b), T{});
  } else if constexpr (limiter == Limiter::mc) {
    return select(a * b > 0, smaller_magnitude(smaller_magnitude(a, b), 0.25 * (a + b)), T{});
  } else if constexpr (limiter == Limiter::flat) {
    return T{};
  } else {
    constexpr double tiny = 1e-200;  // against 0/0 in uniform flow without a floor
    const T sum = a + b, product = a * b;
    return (sum * (0.5 * (product + floor))) / (sum * sum + (2 * (floor - product) + tiny));
  }
}

}  // namespace mortise
