#include "mortise/grids/core/types.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(Box, StartsEmptyAndGrowsToItsPoints) {
  Box<2> box;
  EXPECT_FALSE(box.contains({0, 0}));
  box.include({1, 2});
  box.include({3, -1});
  EXPECT_EQ(box.low, Point<2>(1, -1));
  EXPECT_EQ(box.high, Point<2>(3, 2));
  EXPECT_TRUE(box.contains({1, 2}));
  EXPECT_TRUE(box.contains({2, 0}));
  EXPECT_FALSE(box.contains({0.9, 0}));
  EXPECT_FALSE(box.contains({2, 2.1}));
}

TEST(Box, MeetsWhatSharesAPoint) {
  const Box<2> box{{0, 0}, {1, 1}};
  EXPECT_TRUE(box.meets({{1, 1}, {2, 2}}));
  EXPECT_TRUE(box.meets({{-1, 0.4}, {2, 0.6}}));
  EXPECT_FALSE(box.meets({{1.1, 0}, {2, 1}}));
  EXPECT_FALSE(box.meets({{0, -2}, {1, -0.1}}));
}

TEST(Box, GrownMovesEverySideOut) {
  const Box<1> box = Box<1>{Point<1>(1.0), Point<1>(2.0)}.grown(0.5);
  EXPECT_EQ(box.low[0], 0.5);
  EXPECT_EQ(box.high[0], 2.5);
}

}  // namespace
}  // namespace mortise
