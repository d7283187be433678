#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {
namespace {

BodyAtlas atlas_of(const Outline& outline, double spacing, int layers) {
  return BodyAtlas(outline, grow(outline, {.spacing = spacing, .layers = layers}));
}

/// Random points of the box, always the same ones.
std::vector<Point<2>> points_in(const Box<2>& box, int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point<2>> points;
  for (int k = 0; k < count; ++k)
    points.push_back(box.low + (box.high - box.low).cwiseProduct(Point<2>(part(random), part(random))));
  return points;
}

TEST(BodyAtlas, DistanceToACircleIsWithinItsBound) {
  constexpr double radius = 0.5, spacing = 0.02;
  const BodyAtlas atlas = atlas_of(Outline::circle(radius), spacing, 10);
  for (const Point<2>& x : points_in(atlas.reach(), 5000)) {
    if (x.norm() < spacing) continue;
    const double bound = spacing * spacing / 32 / (x.norm() - spacing) + 2e-6;
    ASSERT_NEAR(atlas.distance(x), x.norm() - radius, bound) << x.transpose();
  }
  EXPECT_NEAR(atlas.distance({0, 0}), -radius, spacing / 4) << "the centre";
}

TEST(BodyAtlas, DistanceIsNegativeInsideAndExactNearStraightSides) {
  const BodyAtlas atlas = atlas_of(Outline::rounded_rectangle(0.1, 0.5, 0.038).centered(), 0.0125, 10);
  EXPECT_NEAR(atlas.distance({0.07, 0.1}), 0.02, 1e-15);
  EXPECT_NEAR(atlas.distance({0.04, -0.1}), -0.01, 1e-15);
  EXPECT_NEAR(atlas.distance({0, 0}), -0.05, 1e-15);
}

TEST(BodyAtlas, ReachHoldsTheGridAndSixSpacings) {
  const BodyAtlas atlas = atlas_of(Outline::ellipse(0.7, 0.35), 0.0125, 10);
  EXPECT_NEAR(atlas.width(), 0.125, 1e-4);
  EXPECT_LE(atlas.reach().low.x(), -0.7 - atlas.width() - 6 * 0.0125);
  EXPECT_GE(atlas.reach().high.y(), 0.35 + atlas.width() + 6 * 0.0125);
}

TEST(BodyAtlas, OutsideTheTableDistanceIsALowerBoundBeyondTheWidth) {
  const BodyAtlas atlas = atlas_of(Outline::circle(0.5), 0.02, 10);
  for (const Point<2>& x : points_in({{-3, -3}, {3, 3}}, 1000)) {
    if (atlas.reach().contains(x)) continue;
    EXPECT_LE(atlas.distance(x), x.norm() - 0.5 + 1e-12);
    EXPECT_GT(atlas.distance(x), atlas.width());
  }
}

TEST(BodyAtlas, DistancesOfASymmetricBodyAreMirrored) {
  const BodyAtlas atlas = atlas_of(Outline::rounded_rectangle(0.1, 0.5, 0.038).centered(), 0.0125, 10);
  for (const Point<2>& x : points_in(atlas.reach(), 2000)) {
    EXPECT_NEAR(atlas.distance({-x.x(), x.y()}), atlas.distance(x), 1e-14);
    EXPECT_NEAR(atlas.distance({x.x(), -x.y()}), atlas.distance(x), 1e-14);
  }
}

TEST(BodyAtlas, CentersAreMeansOfNodesAndWrapAcrossTheSeam) {
  const BodyAtlas atlas = atlas_of(Outline::ellipse(0.7, 0.35), 0.05, 5);
  const GrownGrid& grid = atlas.grid();
  const Point<2> mean = (grid.node(7, 3) + grid.node(8, 3) + grid.node(7, 4) + grid.node(8, 4)) / 4;
  EXPECT_LT((atlas.center(7, 3) - mean).norm(), 1e-15);
  EXPECT_EQ(atlas.center(-1, 2), atlas.center(grid.along - 1, 2));
  EXPECT_EQ(atlas.center(grid.along, 2), atlas.center(0, 2));
}

}  // namespace
}  // namespace mortise
