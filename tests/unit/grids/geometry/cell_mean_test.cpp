#include "mortise/grids/geometry/cell_mean.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

const Corners<2> skewed = {Point<2>(0, 0), Point<2>(1, 0.1), Point<2>(0.2, 0.8), Point<2>(1.5, 1.3)};

TEST(CellMean, ConstantIsItsOwnMean) {
  EXPECT_EQ(cell_mean<2>(skewed, [](const Point<2>&) { return std::array{0.1}; })[0], 0.1);
}

TEST(CellMean, CubicOnALine) {
  const Corners<1> cell = {Point<1>(0), Point<1>(2)};
  EXPECT_NEAR(cell_mean<1>(cell, [](const Point<1>& x) { return std::array{x[0] * x[0] * x[0]}; })[0], 2, 1e-14);
}

// ∫x over the two triangles of the quadrilateral (0,0), (1,0.1), (1.5,1.3), (0.2,0.8).
TEST(CellMean, CentroidOfASkewedCell) {
  const Point<2>&a = skewed[0], &b = skewed[1], &c = skewed[3], &d = skewed[2];
  const auto area = [](const Point<2>& p, const Point<2>& q) { return 0.5 * (p.x() * q.y() - p.y() * q.x()); };
  const double first = area(b - a, c - a), second = area(c - a, d - a);
  const Point<2> centroid = (first * (a + b + c) + second * (a + c + d)) / (3 * (first + second));
  const auto mean = cell_mean<2>(skewed, [](const Point<2>& x) { return std::array{x.x(), x.y()}; });
  EXPECT_NEAR(mean[0], centroid.x(), 1e-14);
  EXPECT_NEAR(mean[1], centroid.y(), 1e-14);
}

}  // namespace
}  // namespace mortise
