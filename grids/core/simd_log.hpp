// Natural logarithm of positive numbers, lane by lane, with an error below one unit in the last place, near 1 too
// (the algorithm and coefficients of Sun's fdlibm, e_log.c): x = 2^k (1 + f) with √½ ≤ 1 + f < √2, s = f/(2 + f),
//   ln x = k ln 2 + ln(1 + f),   ln(1 + f) = f − (½f² − s(½f² + R(s²))),
// R a polynomial. Around 1 k is 0 and f = x − 1 is exact, so that no digits are lost.
#pragma once

#include <bit>
#include <limits>

#include "mortise/grids/core/simd.hpp"

namespace mortise {

namespace detail {

using PackBits = std::uint64_t __attribute__((vector_size(simd_width * sizeof(double))));

MORTISE_INLINE std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }
MORTISE_INLINE PackBits bits_of(Pack x) { return (PackBits)x; }
MORTISE_INLINE double from_bits(std::uint64_t u) { return std::bit_cast<double>(u); }
MORTISE_INLINE Pack from_bits(PackBits u) { return (Pack)u; }

/// ln(1 + f), √½ ≤ 1 + f < √2.
template <class T>
MORTISE_INLINE T log_of_mantissa(T f) {
  const T s = f / (2.0 + f), z = s * s, w = z * z;
  const T even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const T odd = z * (6.666666666666735130e-01 +
                     w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const T half = 0.5 * (f * f);
  return f - (half - s * (half + (even + odd)));
}

}  // namespace detail

/// ln x for normal finite x > 0; NaN for x ≤ 0 and NaN. T is double or Pack.
template <class T>
MORTISE_INLINE T natural_log(T x) {
  constexpr std::uint64_t one = 0x3ff0000000000000, root_half = 0x3fe6a09e00000000;
  constexpr std::uint64_t mantissa = 0x000fffffffffffff, two_52 = 0x4330000000000000;
  const auto u = detail::bits_of(x) + (one - root_half);
  const T k = detail::from_bits((u >> 52) | two_52) - (0x1p52 + 1023);
  const T f = detail::from_bits((u & mantissa) + root_half) - 1.0;
  const T ln = k * 6.93147180369123816490e-01 + (detail::log_of_mantissa(f) + k * 1.90821492927058770002e-10);
  return select(x > 0, ln, T{} + std::numeric_limits<double>::quiet_NaN());
}

}  // namespace mortise
