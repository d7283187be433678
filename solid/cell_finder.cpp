#include "mortise/solid/cell_finder.hpp"

#include <algorithm>
#include <cmath>

namespace mortise {
namespace {

constexpr double on_edge = 1e-12;    // of a cell's size: points on a shared edge are in both cells
constexpr int most_iterations = 30;  // of Newton's method
constexpr double converged = 1e-10;  // cells

/// Weights of the quadratic through −1, 0, 1 at r, and their derivatives.
std::array<double, 3> weights(double r) { return {0.5 * r * (r - 1), (1 - r) * (1 + r), 0.5 * r * (r + 1)}; }
std::array<double, 3> slopes(double r) { return {r - 0.5, -2 * r, r + 0.5}; }

}  // namespace

CellFinder::CellFinder(const GrownGrid& grid) : grid_(grid) {
  for (int j = 0; j <= grid_.layers; ++j)
    for (int i = 0; i <= grid_.along; ++i) bounds_.include(grid_.node(i, j));
  size_ = grid_.spacing;
  const Point<2> extent = bounds_.high - bounds_.low;
  for (std::size_t d = 0; d < 2; ++d) counts_[d] = static_cast<int>(extent[static_cast<int>(d)] / size_) + 1;
  buckets_.resize(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]));
  for (int cell = 0; cell < grid_.along * grid_.layers; ++cell) {
    const int i = cell % grid_.along, j = cell / grid_.along;
    Box<2> box;
    for (const Index<2>& corner : {Index<2>{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
      box.include(grid_.node(corner[0], corner[1]));
    box = box.grown(on_edge * size_);
    const Index<2> low = bucket_of(box.low), high = bucket_of(box.high);
    for (int b = low[1]; b <= high[1]; ++b)
      for (int a = low[0]; a <= high[0]; ++a) buckets_[index_of(a, b)].push_back(cell);
  }
}

Index<2> CellFinder::bucket_of(const Point<2>& X) const {
  Index<2> bucket;
  for (std::size_t d = 0; d < 2; ++d) {
    const int k = static_cast<int>(d);
    bucket[d] = std::clamp(static_cast<int>((X[k] - bounds_.low[k]) / size_), 0, counts_[d] - 1);
  }
  return bucket;
}

Point<2> CellFinder::center_of(int i, int j) const {
  return 0.25 * (grid_.node(i, j) + grid_.node(i + 1, j) + grid_.node(i, j + 1) + grid_.node(i + 1, j + 1));
}

bool CellFinder::holds(int cell, const Point<2>& X) const {
  const int i = cell % grid_.along, j = cell / grid_.along;
  const std::array<Point<2>, 4> corner = {grid_.node(i, j), grid_.node(i + 1, j), grid_.node(i + 1, j + 1),
                                          grid_.node(i, j + 1)};
  for (std::size_t k = 0; k < 4; ++k) {
    const Point<2> edge = corner[(k + 1) % 4] - corner[k];
    if (cross(edge, X - corner[k]) < -on_edge * edge.squaredNorm()) return false;
  }
  return true;
}

bool CellFinder::find(const Point<2>& X, Index<2>& center, std::array<double, 2>& offset) const {
  if (!bounds_.grown(on_edge * size_).contains(X)) return false;
  const Index<2> bucket = bucket_of(X);
  const std::vector<int>& cells = buckets_[index_of(bucket[0], bucket[1])];
  const auto cell = std::find_if(cells.begin(), cells.end(), [&](int c) { return holds(c, X); });
  if (cell == cells.end()) return false;
  const Index<2> at = {*cell % grid_.along, *cell / grid_.along};
  center = {grid_.periodic ? at[0] : std::clamp(at[0], 1, grid_.along - 2), std::clamp(at[1], 1, grid_.layers - 2)};
  Point<2> r(at[0] - center[0], at[1] - center[1]);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const std::array<double, 3> u = weights(r[0]), v = weights(r[1]), du = slopes(r[0]), dv = slopes(r[1]);
    Point<2> residual = X, along = Point<2>::Zero(), across = Point<2>::Zero();
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t k = 0; k < 3; ++k) {
        const Point<2> c = center_of(center[0] + static_cast<int>(k) - 1, center[1] + static_cast<int>(l) - 1);
        residual -= u[k] * v[l] * c;
        along += du[k] * v[l] * c;
        across += u[k] * dv[l] * c;
      }
    const Point<2> step = Point<2>(cross(residual, across), cross(along, residual)) / cross(along, across);
    r += step;
    if (step.cwiseAbs().maxCoeff() < converged) break;
  }
  offset = {r[0], r[1]};
  return r.allFinite();
}

}  // namespace mortise
