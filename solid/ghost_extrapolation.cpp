// Ghosts beyond a side from the three cells next to it. With a₀, a₁, a₂ from the side inwards, b = a₁ − a₀, c = a₂ −
// a₁,
//   a₋₁ = a₀ − d,  d = 2b − c: the parabola,  a₋₂ = a₋₁ − (2d − b).
// With a limiter d is brought between 0 and 2 minmod(b, c) and a₋₂ = a₋₁ − d: the parabola where b and c are alike, the
// cell itself beside jumps.
#include "mortise/grids/core/simd.hpp"
#include "mortise/solid/elastic_step.hpp"

namespace mortise {
namespace {

/// A number, or a vector of consecutive ones.
template <class T>
MORTISE_INLINE T read(const double* p) {
  if constexpr (lanes<T> == 1)
    return *p;
  else
    return load(p);
}
MORTISE_INLINE void write(double* p, double a) { *p = a; }
MORTISE_INLINE void write(double* p, Pack a) { store(p, a); }

/// The ghosts beyond a, from it and its neighbours inwards.
template <class T>
MORTISE_INLINE void extrapolate(double* a, std::ptrdiff_t inward, bool limited) {
  const T a0 = read<T>(a), b = read<T>(a + inward) - a0, c = read<T>(a + 2 * inward) - read<T>(a + inward);
  const T parabola = 2.0 * b - c;
  if (!limited) {
    write(a - inward, a0 - parabola);
    write(a - 2 * inward, a0 - parabola - (2.0 * parabola - b));
    return;
  }
  const T bound = select(b * c > 0, 2.0 * min(abs(b), abs(c)), T{});
  const T size = min(max(select(b < 0, -parabola, parabola), T{}), bound), d = select(b < 0, -size, size);
  write(a - inward, a0 - d);
  write(a - 2 * inward, a0 - 2.0 * d);
}

}  // namespace

void extrapolate_ghosts(const TileShape<2>& shape, TileBlock& block, Side side, int along_low, int along_high,
                        const ElasticOptions& options) {
  const bool high = side == Side::east || side == Side::north, along_x = side == Side::south || side == Side::north;
  const int normal = along_x ? 1 : 0, edge = high ? shape.cells[static_cast<std::size_t>(normal)] - 1 : 0;
  const std::ptrdiff_t inward = (high ? -1 : 1) * (along_x ? shape.stride : 1);
  const bool limited = options.limiter != ElasticLimiter::none;
  for (int component = 0; component < elastic_components(options.material.law); ++component) {
    double* const plane = block.component(component);
    int k = along_low;
    for (; along_x && k + simd_width <= along_high; k += simd_width)
      extrapolate<Pack>(plane + shape.at(k, edge), inward, limited);
    for (; k < along_high; ++k)
      extrapolate<double>(plane + (along_x ? shape.at(k, edge) : shape.at(edge, k)), inward, limited);
  }
}

}  // namespace mortise
