// Undivided slopes of a cell from five values along a line.
//   central:  δ = ⅔(q₊₁ − q₋₁) − (q₊₂ − q₋₂)/12, fourth order;
//   limited:  the fourth-order monotonicity-limited slope of Colella, "A direct Eulerian MUSCL scheme for gas
//   dynamics",
//             SIAM J. Sci. Stat. Comput. 6 (1985): with a = q − q₋₁, b = q₊₁ − q and δ_lim = 2 min(|a|, |b|) if ab > 0,
//             else 0,
//               δ_f = min(½|a + b|, δ_lim) sgn(a + b),  δ = min(|⅔(a + b) − (δ_f,₊₁ + δ_f,₋₁)/6|, δ_lim) sgn(a + b).
// The limited slope vanishes at extrema, where the order falls to that of piecewise constants.
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise {

enum class FlowSlopes { limited, central };

namespace detail {
/// `slope`, of the sign of a and b, but not more than twice the smaller of them, and 0 where their signs differ.
template <class T>
MORTISE_INLINE T bounded_slope(T a, T b, T slope) {
  return select(a * b > 0, smaller_magnitude(slope, 2.0 * smaller_magnitude(a, b)), T{});
}
}  // namespace detail

/// Slope at the middle one of five values in order. T is double or Pack.
template <FlowSlopes slopes, class T>
MORTISE_INLINE T flow_slope(T q_2, T q_1, T q0, T q1, T q2) {
  if constexpr (slopes == FlowSlopes::central) {
    return (2.0 / 3) * (q1 - q_1) - (1.0 / 12) * (q2 - q_2);
  } else {
    const T d_2 = q_1 - q_2, d_1 = q0 - q_1, d1 = q1 - q0, d2 = q2 - q1;
    const T before = detail::bounded_slope<T>(d_2, d_1, 0.5 * (d_2 + d_1));
    const T after = detail::bounded_slope<T>(d1, d2, 0.5 * (d1 + d2));
    return detail::bounded_slope<T>(d_1, d1, (2.0 / 3) * (d_1 + d1) - (1.0 / 6) * (before + after));
  }
}

}  // namespace mortise
