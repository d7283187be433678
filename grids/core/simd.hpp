// A vector of doubles as wide as the processor's registers, on the compiler's vector extension: 8 lanes with
// AVX-512, 4 with AVX2, 2 otherwise. Kernels are templates over the number type and run on double or on Pack.
// Every operation works lane by lane, so a result does not depend on the lane or on its neighbours in the vector.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__AVX512F__) || defined(__AVX__) || defined(__SSE2__)
#include <immintrin.h>
#endif

/// For the small pure functions a fused kernel is made of: their arguments and results must stay in registers.
#define MORTISE_INLINE inline __attribute__((always_inline))

namespace mortise {

#if defined(__AVX512F__)
inline constexpr int simd_width = 8;
#elif defined(__AVX__)
inline constexpr int simd_width = 4;
#else
inline constexpr int simd_width = 2;
#endif

using Pack = double __attribute__((vector_size(simd_width * sizeof(double))));
using PackMask = std::int64_t __attribute__((vector_size(simd_width * sizeof(double))));  // lanes −1: true, 0: false

namespace detail {
// A vector may lie anywhere in an array of doubles, and aliases its elements (GCC and Clang).
using UnalignedPack = double __attribute__((vector_size(simd_width * sizeof(double)), aligned(sizeof(double))));
}  // namespace detail

MORTISE_INLINE Pack load(const double* p) { return *reinterpret_cast<const detail::UnalignedPack*>(p); }
MORTISE_INLINE void store(double* p, Pack v) { *reinterpret_cast<detail::UnalignedPack*>(p) = v; }
MORTISE_INLINE Pack broadcast(double x) { return x - Pack{}; }

MORTISE_INLINE Pack sqrt(Pack x) {
#if defined(__AVX512F__)
  return (Pack)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif defined(__AVX__)
  return (Pack)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__)
  return (Pack)_mm_sqrt_pd((__m128d)x);
#else
  for (int k = 0; k < simd_width; ++k) x[k] = std::sqrt(x[k]);
  return x;
#endif
}
MORTISE_INLINE Pack min(Pack a, Pack b) { return a < b ? a : b; }
MORTISE_INLINE Pack max(Pack a, Pack b) { return a > b ? a : b; }
MORTISE_INLINE Pack abs(Pack a) { return (Pack)((PackMask)a & std::int64_t{0x7fffffffffffffff}); }
MORTISE_INLINE Pack select(PackMask m, Pack a, Pack b) { return m ? a : b; }

MORTISE_INLINE double sqrt(double x) { return std::sqrt(x); }
MORTISE_INLINE double min(double a, double b) { return a < b ? a : b; }
MORTISE_INLINE double max(double a, double b) { return a > b ? a : b; }
MORTISE_INLINE double abs(double a) { return std::fabs(a); }
MORTISE_INLINE double select(bool m, double a, double b) { return m ? a : b; }

/// 1/√x to round-off, x > 0. Where the processor has an approximation y with relative error ≤ 2⁻¹⁴ it is improved by
/// the series of (1 − h)^(−1/2), h = 1 − x y², to third order (error 35/128 h⁴ < 2⁻⁵³): a quarter of the time of a root
/// and a division, and on other execution units than the divisions of a kernel.
MORTISE_INLINE double inverse_sqrt(double x) { return 1.0 / std::sqrt(x); }
MORTISE_INLINE Pack inverse_sqrt(Pack x) {
#if defined(__AVX512F__)
  const Pack y = (Pack)_mm512_maskz_rsqrt14_pd(0xff, (__m512d)x);
  const Pack h = 1.0 - (x * y) * y;
  return y + (y * h) * (0.5 + h * (0.375 + h * 0.3125));
#else
  return 1.0 / sqrt(x);
#endif
}

/// Of a and b the one with the smaller magnitude.
MORTISE_INLINE double smaller_magnitude(double a, double b) { return std::fabs(a) < std::fabs(b) ? a : b; }
MORTISE_INLINE Pack smaller_magnitude(Pack a, Pack b) {
#if defined(__AVX512DQ__)
  return (Pack)_mm512_range_pd((__m512d)a, (__m512d)b, 0b0110);  // minimum of magnitudes, with its own sign
#else
  return abs(a) < abs(b) ? a : b;
#endif
}

/// x brought into [−bound, bound], bound > 0.
MORTISE_INLINE double limit_magnitude(double x, double bound) { return std::copysign(min(std::fabs(x), bound), x); }
MORTISE_INLINE Pack limit_magnitude(Pack x, Pack bound) {
#if defined(__AVX512DQ__)
  return (Pack)_mm512_range_pd((__m512d)x, (__m512d)bound, 0b0010);  // minimum of magnitudes, with the sign of x
#else
  return max(min(x, bound), -bound);
#endif
}

/// max(|a|, |b|)
MORTISE_INLINE double larger_magnitude(double a, double b) { return max(std::fabs(a), std::fabs(b)); }
MORTISE_INLINE Pack larger_magnitude(Pack a, Pack b) {
#if defined(__AVX512DQ__)
  return (Pack)_mm512_range_pd((__m512d)a, (__m512d)b, 0b1011);  // maximum of magnitudes, sign bit cleared
#else
  return max(abs(a), abs(b));
#endif
}

/// All lanes > 0; false if a lane is NaN.
MORTISE_INLINE bool all_positive(double x) { return x > 0; }
MORTISE_INLINE bool all_positive(Pack x) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask((__m512d)x, _mm512_setzero_pd(), _CMP_GT_OQ) == 0xff;
#elif defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd((__m256d)x, _mm256_setzero_pd(), _CMP_GT_OQ)) == 0xf;
#else
  for (int k = 0; k < simd_width; ++k)
    if (!(x[k] > 0)) return false;
  return true;
#endif
}

/// Any lane is true.
MORTISE_INLINE bool any(PackMask mask) {
#if defined(__AVX512F__)
  return _mm512_test_epi64_mask((__m512i)mask, (__m512i)mask) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd((__m256d)mask) != 0;
#else
  std::int64_t all = 0;
  for (int k = 0; k < simd_width; ++k) all |= mask[k];
  return all != 0;
#endif
}

/// Lanes one by one, for what has no vector form.
template <class T>
inline constexpr int lanes = static_cast<int>(sizeof(T) / sizeof(double));
MORTISE_INLINE double lane(double x, int) { return x; }
MORTISE_INLINE double lane(Pack x, int k) { return x[k]; }
MORTISE_INLINE void set_lane(double& x, int, double value) { x = value; }
MORTISE_INLINE void set_lane(Pack& x, int k, double value) { x[k] = value; }

/// Integers from doubles |x| < 2³¹, towards zero; and that as doubles.
using LaneIntegers = std::int32_t __attribute__((vector_size(simd_width * sizeof(std::int32_t))));
MORTISE_INLINE LaneIntegers integers(Pack x) { return __builtin_convertvector(x, LaneIntegers); }
MORTISE_INLINE Pack whole(Pack x) { return __builtin_convertvector(integers(x), Pack); }
MORTISE_INLINE double whole(double x) { return static_cast<double>(static_cast<std::int32_t>(x)); }

/// Lane k is true if k < count.
MORTISE_INLINE PackMask lanes_below(int count) {
  PackMask index{};
  for (int k = 0; k < simd_width; ++k) index[k] = k;
  return index < std::int64_t{count};
}

MORTISE_INLINE double horizontal_max(Pack v) {
  double m = v[0];
  for (int k = 1; k < simd_width; ++k) m = v[k] > m ? v[k] : m;
  return m;
}

/// Asks for the cache line at p: to be read, or to be written.
MORTISE_INLINE void prefetch_read(const double* p) { __builtin_prefetch(p, 0, 3); }
MORTISE_INLINE void prefetch_write(double* p) { __builtin_prefetch(p, 1, 3); }

}  // namespace mortise
