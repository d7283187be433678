// Closest points of bodies, of their images in other periods, and of flat sides.
#include "mortise/coupler/gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

Box<2> square(double half) {
  Box<2> domain;
  domain.low = Point<2>(-half, -half);
  domain.high = Point<2>(half, half);
  return domain;
}

GapBody<2> body(const Outline& outline, double x, double y, double angle = 0) {
  GapBody<2> made;
  made.outline = &outline;
  made.pose.position = Point<2>(x, y);
  made.pose.angle = angle;
  return made;
}

TEST(Gaps, CirclesAreRound) {
  EXPECT_TRUE(is_round(Outline::circle(1e-4)));
  EXPECT_TRUE(is_round(Outline::circle(3).centered()));
  EXPECT_FALSE(is_round(Outline::ellipse(1, 1.0001)));
  EXPECT_FALSE(is_round(Outline::rounded_rectangle(1, 1, 0.49)));
}

TEST(Gaps, AreThereAcrossPeriodicSides) {
  const Outline circle = Outline::circle(0.2);
  const std::vector<GapBody<2>> bodies{body(circle, -0.75, 0), body(circle, 0.78, 0)};
  EXPECT_TRUE(find_gaps<2>(bodies, square(1), {false, false}, 0.02).empty());
  const auto gaps = find_gaps<2>(bodies, square(1), {true, false}, 0.1);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_NEAR(gaps[0].gap, 0.47 - 0.4, 1e-5);
  EXPECT_NEAR(gaps[0].normal[0], -1, 1e-5);
  EXPECT_EQ(gaps[0].shift, (std::array<double, 2>{-2, 0}));
  EXPECT_NEAR(gaps[0].point[0], -0.985, 1e-5);
}

TEST(Gaps, OfNoMoreThanTheNearestImagesHoweverFarOneLooks) {
  const Outline circle = Outline::circle(0.2);
  const std::vector<GapBody<2>> bodies{body(circle, -0.5, 0), body(circle, 0.4, 0)};
  const auto gaps = find_gaps<2>(bodies, square(1), {true, true}, 1e9);
  EXPECT_GE(gaps.size(), 1u);
  EXPECT_LE(gaps.size(), 9u);
}

TEST(Gaps, OfAFlatSideAndTheEdgeAreThereAtBothEnds) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.6, 0.03).centered();
  const auto gaps = find_gaps<2>({body(stick, -0.9, 0, 0.01)}, square(1), {false, false}, 0.1);
  double low = 1, high = -1;
  for (const ContactPoint<2>& gap : gaps) {
    EXPECT_EQ(gap.b, -1);
    EXPECT_EQ(gap.normal, Point<2>(-1, 0));
    low = std::min(low, gap.point[1]);
    high = std::max(high, gap.point[1]);
  }
  EXPECT_LT(low, -0.25);
  EXPECT_GT(high, 0.25);
  EXPECT_EQ(find_gaps<2>({body(Outline::circle(0.3), -0.65, 0)}, square(1), {false, false}, 0.1).size(), 1u);
}

TEST(Gaps, OfFlatSidesAreThereAtBothEnds) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.6, 0.03).centered();
  const auto gaps = find_gaps<2>({body(stick, 0, 0), body(stick, 0.16, 0.1, 0.005)}, square(1), {false, false}, 0.1);
  ASSERT_GE(gaps.size(), 2u);
  double low = 1, high = -1;
  for (const ContactPoint<2>& gap : gaps) {
    EXPECT_NEAR(gap.normal[0], 1, 1e-3);
    EXPECT_NEAR(gap.gap, 0.06, 0.004);
    low = std::min(low, gap.point[1]);
    high = std::max(high, gap.point[1]);
  }
  EXPECT_LT(low, -0.1);  // the sides face each other from −0.17 to 0.27
  EXPECT_GT(high, 0.2);
  EXPECT_EQ(find_gaps<2>({body(stick, 0, 0), body(stick, 0.37, 0, std::numbers::pi / 4)}, square(1), {false, false}, 0.1)
                .size(),
            1u);
}

}  // namespace
}  // namespace mortise
