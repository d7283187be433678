#include "mortise/grids/geometry/strip_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mortise/grids/geometry/outline.hpp"

namespace mortise {
namespace {

double brute_force(const std::vector<Point<2>>& polygon, const Point<2>& x) {
  double squared = 1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    squared = std::min(squared, squared_distance(x, polygon[k], polygon[(k + 1) % polygon.size()]));
  return std::sqrt(squared);
}

TEST(StripTree, DistanceToAUnitSquare) {
  const StripTree tree({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_DOUBLE_EQ(tree.nearest({0.5, 1.25}).distance, 0.25);
  EXPECT_DOUBLE_EQ(tree.nearest({0.5, 0.9}).distance, -(1 - 0.9));
  EXPECT_DOUBLE_EQ(tree.nearest({-3, -4}).distance, 5) << "nearest to a corner";
  EXPECT_EQ(tree.nearest({2, 0.25}).point, Point<2>(1, 0.25));
}

TEST(StripTree, SignAtAnInwardCorner) {
  const StripTree tree({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  EXPECT_DOUBLE_EQ(tree.nearest({0.9, 0.9}).distance, -std::sqrt(0.02));
  EXPECT_DOUBLE_EQ(tree.nearest({1.5, 1.5}).distance, 0.5);
}

TEST(StripTree, AgreesWithAllEdgesEverywhere) {
  const Outline outline = Outline::rounded_polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-0.5, 1.5);
  for (int k = 0; k < 300; ++k) {
    const Point<2> x(coordinate(random), coordinate(random));
    const double exact = brute_force(outline.polygon(), x);
    const auto found = outline.tree().nearest(x);
    EXPECT_NEAR(std::abs(found.distance), exact, 1e-15);
    EXPECT_NEAR((found.point - x).norm(), exact, 1e-15);
    EXPECT_NEAR(outline.tree().nearest(x, exact + 0.01).distance, found.distance, 1e-15) << "with a bound";
  }
}

}  // namespace
}  // namespace mortise
