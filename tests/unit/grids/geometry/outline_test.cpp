#include "mortise/grids/geometry/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

using std::numbers::pi;

TEST(Outline, CircleHasItsExactMeasures) {
  const Outline circle = Outline::circle(0.5);
  EXPECT_NEAR(circle.area(), pi / 4, 1e-14);
  EXPECT_NEAR(circle.perimeter(), pi, 1e-13);
  EXPECT_NEAR(circle.second_moment(), pi / 32, 1e-15);
  EXPECT_NEAR(circle.mean_radius(), 0.5, 1e-14);
  EXPECT_LT(circle.centroid().norm(), 1e-16);
}

TEST(Outline, EllipseHasItsExactMeasures) {
  const Outline ellipse = Outline::ellipse(0.7, 0.35);
  EXPECT_NEAR(ellipse.area(), 0.7696902, 5e-8);
  EXPECT_NEAR(ellipse.area(), pi * 0.7 * 0.35, 1e-12);
  EXPECT_NEAR(ellipse.second_moment(), 0.1178588, 5e-8);
  EXPECT_NEAR(ellipse.second_moment(), pi * 0.7 * 0.35 * (0.49 + 0.1225) / 4, 1e-12);
}

TEST(Outline, CenteredMovesTheCentroidAndKeepsTheRest) {
  const Outline triangle = Outline::rounded_polygon({{2, 1}, {4, 1}, {2, 3}}, 0.1);
  const Outline moved = triangle.centered();
  EXPECT_EQ(moved.centroid(), Point<2>(0, 0));
  EXPECT_EQ(moved.area(), triangle.area());
  EXPECT_EQ(moved.second_moment(), triangle.second_moment());
  EXPECT_NEAR((moved.at(1.0) + triangle.centroid() - triangle.at(1.0)).norm(), 0, 1e-15);
  EXPECT_LT((moved.bounds().low + triangle.centroid() - triangle.bounds().low).norm(), 1e-15);
  EXPECT_LT((moved.bounds().high + triangle.centroid() - triangle.bounds().high).norm(), 1e-15);
}

TEST(Outline, ArcLengthOnACircleIsTheAngle) {
  const Outline circle = Outline::circle(2);
  for (const double angle : {0.0, 0.1, 1.2345, 3.0, 5.5}) {
    const Point<2> exact(2 * std::cos(angle), 2 * std::sin(angle));
    EXPECT_LT((circle.at(2 * angle) - exact).norm(), 1e-12) << "angle " << angle;
    EXPECT_LT((circle.at(2 * angle - 4 * pi) - exact).norm(), 1e-12) << "a turn earlier";
  }
}

TEST(Outline, StartsOnTheBodysAxis) {
  EXPECT_EQ(Outline::circle(0.5).at(0), Point<2>(0.5, 0));
  EXPECT_EQ(Outline::ellipse(0.7, 0.35).at(0), Point<2>(0.7, 0));
  EXPECT_LT((Outline::rounded_rectangle(0.1, 0.5, 0.038).at(0) - Point<2>(0.05, 0)).norm(), 1e-16);
  const Outline triangle = Outline::rounded_polygon({{0, 0}, {2, 0}, {0, 2}}, 0.1);
  EXPECT_NEAR(triangle.at(0).y(), triangle.centroid().y(), 1e-14) << "a vertex is added";
  EXPECT_NEAR(triangle.at(0).x(), 2 - triangle.centroid().y(), 1e-14);
}

TEST(Outline, ACentroidInABayStartsAtTheLargestX) {
  // A C open to the right: nothing lies to the right of its centroid.
  const Outline c =
      Outline::rounded_polygon({{0, 0}, {3, 0}, {3, .2}, {.2, .2}, {.2, 2.8}, {3, 2.8}, {3, 3}, {0, 3}}, 0.05);
  EXPECT_NEAR(c.at(0).x(), 3, 1e-12);
}

TEST(Outline, PolygonIsDenseAndCounterClockwise) {
  for (const Outline& outline :
       {Outline::circle(1), Outline::ellipse(1, 0.2), Outline::rounded_rectangle(0.1, 0.5, 0.038)}) {
    EXPECT_GE(outline.polygon().size(), 2000u);
    double twice_area = 0;
    for (std::size_t k = 0; k < outline.polygon().size(); ++k)
      twice_area += cross(outline.polygon()[k], outline.polygon()[(k + 1) % outline.polygon().size()]);
    EXPECT_NEAR(twice_area / 2, outline.area(), 1e-5 * outline.area());
  }
}

}  // namespace
}  // namespace mortise
