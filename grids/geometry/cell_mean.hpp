// Means of smooth functions over cells. What a finite-volume scheme keeps in a cell is a mean; it differs from the
// value at the cell's centre by h²/24 Δf.
#pragma once

#include <array>
#include <cmath>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// Corners of a cell: x runs first.
template <int Dim>
using Corners = std::array<Point<Dim>, std::size_t{1} << Dim>;

/// Mean of f, which returns std::array<double, N>, over the (bilinear) cell by two Gauss points a direction: error
/// O(h⁴). A constant is its own mean to the last bit.
template <int Dim, class Function>
auto cell_mean(const Corners<Dim>& corners, Function&& f) {
  static_assert(Dim == 1 || Dim == 2);
  const double low = 0.5 - 0.5 / std::sqrt(3.0);
  const std::array<double, 2> points{low, 1 - low};
  const auto first = f(corners[0]);
  auto sum = first;
  sum.fill(0);
  double volume = 0;
  const auto add = [&](const Point<Dim>& x, double weight) {
    const auto value = f(x);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * (value[k] - first[k]);
    volume += weight;
  };
  if constexpr (Dim == 1) {
    for (const double s : points) add(corners[0] + s * (corners[1] - corners[0]), 1);
  } else {
    const auto& [a, b, c, d] = corners;
    for (const double t : points)
      for (const double s : points) {
        const Point<2> along = (1 - t) * (b - a) + t * (d - c), across = (1 - s) * (c - a) + s * (d - b);
        add((1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d),
            std::fabs(along.x() * across.y() - along.y() * across.x()));
      }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = first[k] + sum[k] / volume;
  return sum;
}

}  // namespace mortise
