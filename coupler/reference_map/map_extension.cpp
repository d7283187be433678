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

/// ξ of the nearest neighbour that holds it, and where that is.
struct Nearest {
  Pack x{}, y{}, i{}, j{}, layer = broadcast(unknown_layer);

  /// Of neighbours in the lowest layer the first one counts.
  MORTISE_INLINE void offer(const double* xi_x, const double* xi_y, const double* layers, std::ptrdiff_t stride, int di,
                            int dj) {
    const std::ptrdiff_t k = dj * stride + di;
    const Pack candidate = load(layers + k);
    const PackMask closer = candidate < layer;
    x = select(closer, load(xi_x + k), x), y = select(closer, load(xi_y + k), y);
    i = select(closer, broadcast(di), i), j = select(closer, broadcast(dj), j);
    layer = select(closer, candidate, layer);
  }
};

/// Which neighbours count: all in lower layers, or those of them that are of the nearest one's part.
struct AllNeighbors {
  MORTISE_INLINE PackMask operator()(int, int, Pack, Pack) const { return ~PackMask{}; }
};
struct NeighborsOfPart {
  Nearest nearest;
  double largest2;

  MORTISE_INLINE PackMask operator()(int i, int j, Pack xi_x, Pack xi_y) const {
    const Pack dx = xi_x - nearest.x, dy = xi_y - nearest.y, di = i - nearest.i, dj = j - nearest.j;
    return dx * dx + dy * dy <= largest2 * (di * di + dj * dj);
  }
};

template <int i, int j, class Which>
MORTISE_INLINE void add_neighbor(Moments& m, const double* x, const double* y, const double* layer,
                                 std::ptrdiff_t stride, double number, const Which& which) {
  if constexpr (i != 0 || j != 0) {
    constexpr double r2 = i * i + j * j;
    const std::ptrdiff_t k = j * stride + i;
    const Pack xi_x = load(x + k), xi_y = load(y + k);
    const PackMask counts = (load(layer + k) < number) & which(i, j, xi_x, xi_y);
    m.add(i, j, select(counts, broadcast(1 / (r2 * r2)), Pack{}), xi_x, xi_y);
  }
}

template <int j, class Which>
MORTISE_INLINE void add_row(Moments& m, const double* x, const double* y, const double* layer, std::ptrdiff_t stride,
                            double number, const Which& which) {
  add_neighbor<-2, j>(m, x, y, layer, stride, number, which);
  add_neighbor<-1, j>(m, x, y, layer, stride, number, which);
  add_neighbor<0, j>(m, x, y, layer, stride, number, which);
  add_neighbor<1, j>(m, x, y, layer, stride, number, which);
  add_neighbor<2, j>(m, x, y, layer, stride, number, which);
}

template <class Which>
MORTISE_INLINE Moments moments(const double* x, const double* y, const double* layer, std::ptrdiff_t stride,
                               double number, const Which& which) {
  Moments m;
  add_row<-2>(m, x, y, layer, stride, number, which);
  add_row<-1>(m, x, y, layer, stride, number, which);
  add_row<0>(m, x, y, layer, stride, number, which);
  add_row<1>(m, x, y, layer, stride, number, which);
  add_row<2>(m, x, y, layer, stride, number, which);
  return m;
}

MORTISE_INLINE Nearest nearest(const double* x, const double* y, const double* layer, std::ptrdiff_t stride) {
  Nearest n;
  for (const int side : {-1, 1}) n.offer(x, y, layer, stride, side, 0), n.offer(x, y, layer, stride, 0, side);
  for (const int i : {-1, 1})
    for (const int j : {-1, 1}) n.offer(x, y, layer, stride, i, j);
  return n;
}

int count(PackMask mask) {
  int sum = 0;
  for (int k = 0; k < simd_width; ++k) sum += mask[k] != 0;
  return sum;
}

}  // namespace

int extend_layer(const TileShape<2>& shape, const TileWindow& window, int number, TileBlock& map, double largest_jump) {
  const std::ptrdiff_t s = shape.stride;
  const double n = number;
  int orphans = 0;
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const std::size_t at = shape.at(i, j);
      double *const x = map.component(0) + at, *const y = map.component(1) + at, *const layer = map.component(3) + at;
      const Pack here = load(layer);
      const PackMask open = (here == unknown_layer) & lanes_below(window.high[0] - i);
      if (!any(open)) continue;
      Pack least = min(min(load(layer - 1), load(layer + 1)), min(load(layer - s), load(layer + s)));
      least =
          min(least, min(min(load(layer - s - 1), load(layer - s + 1)), min(load(layer + s - 1), load(layer + s + 1))));
      const PackMask wanted = open & (least < n);
      if (!any(wanted)) continue;
      const Moments m =
          largest_jump > 0
              ? moments(x, y, layer, s, n, NeighborsOfPart{nearest(x, y, layer, s), largest_jump * largest_jump})
              : moments(x, y, layer, s, n, AllNeighbors{});
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
