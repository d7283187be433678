#include "mortise/coupler/reference_map/level_set.hpp"

#include <algorithm>
#include <cmath>

namespace mortise {

LevelSet::LevelSet(const Outline& outline, double spacing, double margin) : inverse_spacing_(1 / spacing) {
  box_ = outline.bounds().grown(margin);
  for (int d = 0; d < 2; ++d) {
    cells_[static_cast<std::size_t>(d)] =
        std::max(1, static_cast<int>(std::ceil((box_.high[d] - box_.low[d]) / spacing)));
    box_.high[d] = box_.low[d] + cells_[static_cast<std::size_t>(d)] * spacing;
  }
  values_.reserve(static_cast<std::size_t>(cells_[0] + 1) * static_cast<std::size_t>(cells_[1] + 1));
  for (int j = 0; j <= cells_[1]; ++j)
    for (int i = 0; i <= cells_[0]; ++i)
      values_.push_back(outline.tree().nearest(box_.low + spacing * Point<2>(i, j)).distance);
}

namespace {

/// Lowest node of the cell of a table that holds places u ≥ 0, and the place in it.
MORTISE_INLINE double whole(double u, int cells) { return std::min(std::trunc(u), static_cast<double>(cells - 1)); }
MORTISE_INLINE Pack whole(Pack u, int cells) {
  for (int k = 0; k < simd_width; ++k) u[k] = static_cast<double>(static_cast<int>(u[k]));
  return min(u, broadcast(cells - 1));
}

template <class T>
struct Corners {
  T sw, se, nw, ne;
};
template <class T>
MORTISE_INLINE Corners<T> corners(const double* values, std::ptrdiff_t row, T i, T j) {
  Corners<T> c;
  for (int k = 0; k < lanes<T>; ++k) {
    const double* node =
        values + static_cast<std::ptrdiff_t>(lane(j, k)) * row + static_cast<std::ptrdiff_t>(lane(i, k));
    set_lane(c.sw, k, node[0]), set_lane(c.se, k, node[1]);
    set_lane(c.nw, k, node[row]), set_lane(c.ne, k, node[row + 1]);
  }
  return c;
}

/// Bilinear in the table, from the place in units of its spacing.
template <class T>
MORTISE_INLINE T sampled(const double* values, const Index<2>& cells, double spacing, T u, T v) {
  const T zero{}, cu = min(max(u, zero), T(zero + cells[0])), cv = min(max(v, zero), T(zero + cells[1]));
  const T i = whole(cu, cells[0]), j = whole(cv, cells[1]), a = cu - i, b = cv - j;
  const Corners<T> c = corners(values, cells[0] + 1, i, j);
  const T below = c.sw + a * (c.se - c.sw), above = c.nw + a * (c.ne - c.nw);
  return (below + b * (above - below)) + spacing * (abs(T(u - cu)) + abs(T(v - cv)));
}

}  // namespace

double LevelSet::operator()(double x, double y) const {
  return sampled<double>(values_.data(), cells_, 1 / inverse_spacing_, (x - box_.low.x()) * inverse_spacing_,
                         (y - box_.low.y()) * inverse_spacing_);
}

Pack LevelSet::operator()(Pack x, Pack y) const {
  return sampled<Pack>(values_.data(), cells_, 1 / inverse_spacing_, (x - box_.low.x()) * inverse_spacing_,
                       (y - box_.low.y()) * inverse_spacing_);
}

}  // namespace mortise
