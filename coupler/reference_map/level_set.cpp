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
      values_.push_back(static_cast<float>(outline.tree().nearest(box_.low + spacing * Point<2>(i, j)).distance));
}

namespace {

template <class T>
struct Corners {
  T sw, se, nw, ne;
};

/// Values at the corners of the cells whose lowest nodes are these.
MORTISE_INLINE Corners<double> corners(const float* values, std::ptrdiff_t row, double i, double j) {
  const float* const node = values + static_cast<std::ptrdiff_t>(j) * row + static_cast<std::ptrdiff_t>(i);
  return {node[0], node[1], node[row], node[row + 1]};
}
MORTISE_INLINE Corners<Pack> corners(const float* values, std::ptrdiff_t row, Pack i, Pack j) {
  const LaneIntegers at = integers(j * static_cast<double>(row) + i);
  using Singles = float __attribute__((vector_size(simd_width * sizeof(float))));
  Corners<Singles> c;
  for (int k = 0; k < simd_width; ++k) {
    const float* const node = values + at[k];
    c.sw[k] = node[0], c.se[k] = node[1], c.nw[k] = node[row], c.ne[k] = node[row + 1];
  }
  return {__builtin_convertvector(c.sw, Pack), __builtin_convertvector(c.se, Pack), __builtin_convertvector(c.nw, Pack),
          __builtin_convertvector(c.ne, Pack)};
}

/// Bilinear in the table, from the place in units of its spacing.
template <class T>
MORTISE_INLINE T sampled(const float* values, const Index<2>& cells, double spacing, T u, T v) {
  const T zero{}, cu = min(max(u, zero), T(zero + cells[0])), cv = min(max(v, zero), T(zero + cells[1]));
  const T i = min(whole(cu), T(zero + (cells[0] - 1))), j = min(whole(cv), T(zero + (cells[1] - 1)));
  const T a = cu - i, b = cv - j;
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
