#include "mortise/grids/geometry/neighbors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

using std::numbers::pi;

std::vector<Point<2>> sampled(const Outline& outline, const Point<2>& position) {
  std::vector<Point<2>> samples;
  for (int k = 0; k < 100; ++k) samples.push_back(position + outline.at(outline.perimeter() * k / 100));
  return samples;
}

TEST(NeighboringBodies, InARowOnlyTheNextOneIsANeighbor) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  EXPECT_EQ(neighboring_bodies({sampled(stick, {0.6, 0}), sampled(stick, {0, 0}), sampled(stick, {0.3, 0})}),
            (std::vector<std::pair<int, int>>{{0, 2}, {1, 2}}));
}

TEST(NeighboringBodies, AroundACentreEveryoneSeesIt) {
  const Outline disk = Outline::circle(0.3);
  std::vector<std::vector<Point<2>>> samples{sampled(disk, {0, 0})};
  for (int k = 0; k < 6; ++k) samples.push_back(sampled(disk, {std::cos(pi * k / 3), std::sin(pi * k / 3)}));
  const auto pairs = neighboring_bodies(samples);
  for (int k = 1; k <= 6; ++k) EXPECT_NE(std::find(pairs.begin(), pairs.end(), std::pair(0, k)), pairs.end());
  EXPECT_EQ(std::find(pairs.begin(), pairs.end(), std::pair(1, 4)), pairs.end()) << "hidden by the centre";
}

TEST(NeighboringBodies, OneBodyHasNone) {
  EXPECT_TRUE(neighboring_bodies({sampled(Outline::circle(1), {0, 0})}).empty());
  EXPECT_TRUE(neighboring_bodies({}).empty());
}

TEST(OutlineDistance, BetweenTwoCircles) {
  const Outline small = Outline::circle(0.3), large = Outline::circle(0.8);
  Point<2> on_small, on_large;
  const Pose<2> here{.position = {1, 1}, .angle = 0.4}, there{.position = {1 + 1.2, 1 + 0.5}, .angle = -2};
  const double gap = outline_distance(small, here, large, there, &on_small, &on_large);
  EXPECT_NEAR(gap, 0.2, 2e-6);
  EXPECT_NEAR((on_large - on_small).norm(), gap, 1e-14);
  EXPECT_LT((on_small - (here.position + 0.3 * Point<2>(12, 5) / 13)).norm(), 1e-3);
  EXPECT_NEAR(outline_distance(large, there, small, here), gap, 1e-14) << "the other way round";
}

TEST(OutlineDistance, BetweenPosedSticks) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038).centered();
  EXPECT_NEAR(outline_distance(stick, {}, stick, {.position = {0.3, 0.1}, .angle = 0}), 0.2, 1e-14);
  // The second one lies down: its end, at x = 0.4 − 0.25, faces the side of the first at x = 0.05.
  Point<2> on_first, on_second;
  EXPECT_NEAR(outline_distance(stick, {}, stick, {.position = {0.4, 0}, .angle = pi / 2}, &on_first, &on_second), 0.1,
              1e-14);
  EXPECT_NEAR(on_first.x(), 0.05, 1e-14);
  EXPECT_NEAR(on_second.x(), 0.15, 1e-14);
}

TEST(OutlineDistance, OverlapIsMinusItsDepth) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038).centered(), disk = Outline::circle(0.2);
  Point<2> on_stick, on_disk;
  const double depth = outline_distance(stick, {}, disk, {.position = {0.24, 0}, .angle = 1}, &on_stick, &on_disk);
  EXPECT_NEAR(depth, -0.01, 1e-6);
  const Point<2> from_stick_to_disk = (on_disk - on_stick) / depth;
  EXPECT_NEAR(from_stick_to_disk.x(), 1, 1e-3);
}

TEST(OutlineDistance, ABodyInsideAnotherOverlaps) {
  const Outline small = Outline::circle(0.1), large = Outline::circle(1);
  EXPECT_NEAR(outline_distance(small, {}, large, {.position = {0.3, 0}, .angle = 0}), -0.8, 1e-5);
  EXPECT_NEAR(outline_distance(large, {}, small, {.position = {0.3, 0}, .angle = 0}), -0.8, 1e-5);
}

}  // namespace
}  // namespace mortise
