#include "mortise/fluid/wall_areas.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

GrownGrid strip(double lift) {
  return {.along = 3, .layers = 1, .spacing = 1, .nodes = {{0, 0}, {1, lift}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}, .periodic = true, .period = {3, 0}};
}

TEST(WallAreas, AreTheMeansOfStartAndEndPointingIntoTheFluid) {
  const std::vector<Point<2>> areas = wall_areas(strip(0), strip(0.5));
  ASSERT_EQ(areas.size(), 3u);
  EXPECT_EQ(areas[0], Point<2>(-0.25, 1));
  EXPECT_EQ(areas[1], Point<2>(0.25, 1));
  EXPECT_EQ(areas[2], Point<2>(0, 1));  // across the seam
}

}  // namespace
}  // namespace mortise
