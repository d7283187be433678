// Ghosts beyond a side from the three cells next to it. With a₀, a₁, a₂ from the side inwards, b = a₁ − a₀, c = a₂ −
// a₁,
//   a₋₁ = a₀ − d,  d = 2b − c: the parabola,  a₋₂ = a₋₁ − (2d − b).
// With a limiter d is brought between 0 and 2 minmod(b, c) and a₋₂ = a₋₁ − d: the parabola where b and c are alike, the
// cell itself beside jumps.
#include <algorithm>
#include <cmath>

#include "mortise/solid/elastic_step.hpp"

namespace mortise {
namespace {

struct Ghosts {
  double first, second;
};

Ghosts beyond(double a0, double a1, double a2, bool limited) {
  const double b = a1 - a0, c = a2 - a1, parabola = 2 * b - c;
  if (!limited) return {a0 - parabola, a0 - parabola - (2 * parabola - b)};
  const double bound = b * c > 0 ? 2 * std::min(std::fabs(b), std::fabs(c)) : 0.0;
  const double d = std::copysign(std::clamp(std::copysign(1.0, b) * parabola, 0.0, bound), b);
  return {a0 - d, a0 - 2 * d};
}

}  // namespace

void extrapolate_ghosts(const TileShape<2>& shape, TileBlock& block, Side side, int along_low, int along_high,
                        const ElasticOptions& options) {
  const bool high = side == Side::east || side == Side::north, along_x = side == Side::south || side == Side::north;
  const int normal = along_x ? 1 : 0, edge = high ? shape.cells[static_cast<std::size_t>(normal)] - 1 : 0;
  const std::ptrdiff_t inward = (high ? -1 : 1) * (along_x ? shape.stride : 1);
  for (int component = 0; component < elastic_components(options.material.law); ++component)
    for (int k = along_low; k < along_high; ++k) {
      double* const a = block.component(component) + (along_x ? shape.at(k, edge) : shape.at(edge, k));
      const auto [first, second] = beyond(a[0], a[inward], a[2 * inward], options.limiter != ElasticLimiter::none);
      a[-inward] = first;
      a[-2 * inward] = second;
    }
}

}  // namespace mortise
