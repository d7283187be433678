#include "mortise/coupler/reference_map/map_extension.hpp"

#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

/// Sums over neighbours (i, j) that hold ξ, weights 1/(i² + j²)², for the normal equations of ξ ≈ a + b · (i, j).
struct Moments {
  Pack w{}, wi{}, wj{}, wii{}, wij{}, wjj{};
  struct Right {
    Pack f{}, fi{}, fj{};
  };
  Right x, y;

  MORTISE_INLINE void add(int i, int j, Pack weight, Pack xi_x, Pack xi_y) {
    const Pack a = weight * xi_x, b = weight * xi_y;
    const double di = i, dj = j;
    w = w + weight, x.f = x.f + a, y.f = y.f + b;
    if (i != 0) wi = wi + di * weight, wii = wii + (di * di) * weight, x.fi = x.fi + di * a, y.fi = y.fi + di * b;
    if (j != 0) wj = wj + dj * weight, wjj = wjj + (dj * dj) * weight, x.fj = x.fj + dj * a, y.fj = y.fj + dj * b;
    if (i != 0 && j != 0) wij = wij + (di * dj) * weight;
  }
};

template <int i, int j>
MORTISE_INLINE void add_neighbor(Moments& m, const double* x, const double* y, const double* layer,
                                 std::ptrdiff_t stride, double number) {
  if constexpr (i != 0 || j != 0) {
    constexpr double r2 = i * i + j * j;
    const std::ptrdiff_t k = j * stride + i;
    m.add(i, j, select(load(layer + k) < number, broadcast(1 / (r2 * r2)), Pack{}), load(x + k), load(y + k));
  }
}

template <int j>
MORTISE_INLINE void add_row(Moments& m, const double* x, const double* y, const double* layer, std::ptrdiff_t stride,
                            double number) {
  add_neighbor<-2, j>(m, x, y, layer, stride, number);
  add_neighbor<-1, j>(m, x, y, layer, stride, number);
  add_neighbor<0, j>(m, x, y, layer, stride, number);
  add_neighbor<1, j>(m, x, y, layer, stride, number);
  add_neighbor<2, j>(m, x, y, layer, stride, number);
}

int count(PackMask mask) {
  int sum = 0;
  for (int k = 0; k < simd_width; ++k) sum += mask[k] != 0;
  return sum;
}

}  // namespace

int extend_layer(const TileShape<2>& shape, const TileWindow& window, int number, TileBlock& map) {
  const std::ptrdiff_t s = shape.stride;
  const double n = number;
  int orphans = 0;
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const std::size_t at = shape.at(i, j);
      double *const x = map.component(0) + at, *const y = map.component(1) + at, *const layer = map.component(3) + at;
      const Pack here = load(layer);
      Pack least = min(min(load(layer - 1), load(layer + 1)), min(load(layer - s), load(layer + s)));
      least =
          min(least, min(min(load(layer - s - 1), load(layer - s + 1)), min(load(layer + s - 1), load(layer + s + 1))));
      const PackMask wanted = (here == unknown_layer) & (least < n) & lanes_below(window.high[0] - i);
      if (!any(wanted)) continue;
      Moments m;
      add_row<-2>(m, x, y, layer, s, n);
      add_row<-1>(m, x, y, layer, s, n);
      add_row<0>(m, x, y, layer, s, n);
      add_row<1>(m, x, y, layer, s, n);
      add_row<2>(m, x, y, layer, s, n);
      // Moments about the mean; the value at (0, 0) is mean − slope · mean position.
      const Pack inverse = 1.0 / max(m.w, broadcast(1e-300)), mi = inverse * m.wi, mj = inverse * m.wj;
      const Pack cii = m.wii - m.wi * mi, cij = m.wij - m.wi * mj, cjj = m.wjj - m.wj * mj;
      const Pack det = cii * cjj - cij * cij;
      const PackMask good = wanted & (det > 1e-3 * (m.w * m.w));
      const Pack scale = 1.0 / select(good, det, broadcast(1.0));
      const auto value = [&](const Moments::Right& q) {
        const Pack mean = inverse * q.f, ri = q.fi - q.f * mi, rj = q.fj - q.f * mj;
        return mean - scale * ((cjj * ri - cij * rj) * mi + (cii * rj - cij * ri) * mj);
      };
      store(x, select(good, value(m.x), load(x)));
      store(y, select(good, value(m.y), load(y)));
      store(layer, select(good, broadcast(n), here));
      orphans += count(wanted & ~good);
    }
  return orphans;
}

}  // namespace mortise
