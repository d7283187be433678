// Images in a domain that repeats itself.
#include "mortise/grids/overlap/periods.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

Box<2> box(double x0, double x1, double y0, double y1) {
  Box<2> made;
  made.low = Point<2>(x0, y0);
  made.high = Point<2>(x1, y1);
  return made;
}

TEST(Periods, FindTheImagesThatMeetABox) {
  const Periods<2> periods(box(-1, 1, 0, 3), {true, false});
  EXPECT_EQ(periods.shortest(), 2);
  const auto shifts = periods.images(box(0.8, 1.3, 1, 2), box(-1, 1, 0, 3));
  ASSERT_EQ(shifts.size(), 2u);
  EXPECT_EQ(shifts[0], Point<2>(-2, 0));
  EXPECT_EQ(shifts[1], Point<2>(0, 0));
  EXPECT_EQ(periods.images(box(6.2, 6.4, 1, 2), box(0, 1, 0, 3)).front(), Point<2>(-6, 0));
  EXPECT_TRUE(periods.images(box(-0.5, 0.5, 4, 5), box(-1, 1, 0, 3)).empty());
  EXPECT_TRUE(periods.images(Box<2>{}, box(-1, 1, 0, 3)).empty());
}

TEST(Periods, BringPointsNearABox) {
  const Periods<2> periods(box(-1, 1, 0, 3), {true, true});
  EXPECT_LT((periods.near(Point<2>(-0.9, 2.9), box(0.9, 1.3, -0.4, 0.2)) - Point<2>(1.1, -0.1)).norm(), 1e-15);
  EXPECT_EQ(Periods<2>().near(Point<2>(7, 8), box(0, 1, 0, 1)), Point<2>(7, 8));
}

TEST(Periods, LeaveBoxesWithoutBoundsAlone) {
  Box<1> domain, half_line;
  domain.low[0] = -1, domain.high[0] = 1;
  half_line.low[0] = 0.5, half_line.high[0] = std::numeric_limits<double>::infinity();
  const Periods<1> periods(domain, {true});
  EXPECT_EQ(periods.images(half_line, domain).size(), 1u);
  EXPECT_EQ(periods.near(Point<1>(-0.9), half_line)[0], -0.9);
}

}  // namespace
}  // namespace mortise
