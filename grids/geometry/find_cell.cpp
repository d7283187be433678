#include "mortise/grids/geometry/find_cell.hpp"

#include <array>

namespace mortise {
namespace {

/// Corners of a cell, counter-clockwise from (i, j).
using Corners = std::array<Point<2>, 4>;

bool holds(const Corners& corner, const Point<2>& X) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Point<2> edge = corner[(k + 1) % 4] - corner[k], to = X - corner[k];
    if (edge[0] * to[1] - edge[1] * to[0] < 0) return false;
  }
  return true;
}

/// X = (1 − v) ((1 − u) a + u b) + v ((1 − u) d + u c), by Newton's method from the middle.
Point<2> bilinear_coordinates(const Corners& corner, const Point<2>& X) {
  const auto& [a, b, c, d] = corner;
  Point<2> w(0.5, 0.5);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double u = w[0], v = w[1];
    const Point<2> along = (1 - v) * (b - a) + v * (c - d), across = (1 - u) * (d - a) + u * (c - b);
    const Point<2> rest = X - ((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * d + u * c));
    const double area = along[0] * across[1] - along[1] * across[0];
    const Point<2> change(rest[0] * across[1] - rest[1] * across[0], along[0] * rest[1] - along[1] * rest[0]);
    if (!(area > 0)) break;
    w += change / area;
    if (change.norm() <= 1e-14 * area) break;
  }
  return w.cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace

bool find_cell(const GrownGrid& grid, const Point<2>& X, CellPoint& found) {
  for (int j = 0; j < grid.layers; ++j) {
    Point<2> west_low = grid.node(0, j), west_high = grid.node(0, j + 1);
    for (int i = 0; i < grid.along; ++i) {
      const Point<2> east_low = grid.node(i + 1, j), east_high = grid.node(i + 1, j + 1);
      const Corners corner = {west_low, east_low, east_high, west_high};
      if (holds(corner, X)) {
        found = {{i, j}, bilinear_coordinates(corner, X)};
        return true;
      }
      west_low = east_low;
      west_high = east_high;
    }
  }
  return false;
}

}  // namespace mortise
