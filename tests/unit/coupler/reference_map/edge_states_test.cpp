// Slopes, half-step states and Godunov's choice against exact numbers.
#include "mortise/coupler/reference_map/edge_states.hpp"

#include <gtest/gtest.h>

#include "mortise/coupler/reference_map/slopes.hpp"

namespace mortise {
namespace {

TEST(FlowSlope, CentralIsExactForQuartics) {
  const auto q = [](double x) { return 3 + 2 * x - x * x + 0.5 * x * x * x + x * x * x * x; };
  EXPECT_NEAR((flow_slope<FlowSlopes::central>(q(-2), q(-1), q(0), q(1), q(2))), 2, 1e-14);
}

TEST(FlowSlope, LimitedIsThatOfLinesAndVanishesAtExtrema) {
  EXPECT_NEAR((flow_slope<FlowSlopes::limited>(1.0, 3.0, 5.0, 7.0, 9.0)), 2, 1e-15);
  EXPECT_EQ((flow_slope<FlowSlopes::limited>(1.0, 2.0, 3.0, 2.0, 1.0)), 0);
}

TEST(FlowSlope, LimitedIsNotMoreThanTwiceTheSmallerDifference) {
  EXPECT_DOUBLE_EQ((flow_slope<FlowSlopes::limited>(0.0, 0.0, 0.1, 1.1, 2.1)), 0.2);
  EXPECT_DOUBLE_EQ((flow_slope<FlowSlopes::limited>(-2.1, -1.1, -0.1, 0.0, 0.0)), 0.2);
}

TEST(EdgeState, FollowsTheCharacteristic) {
  EXPECT_DOUBLE_EQ(ahead(1.0, 0.4, 0.5), 1.1);
  EXPECT_DOUBLE_EQ(behind(1.0, 0.4, 0.5), 0.7);
  EXPECT_DOUBLE_EQ(ahead(1.0, 0.4, 1.0), 1.0);
}

void expect_state(const EdgeState<double>& found, double normal, double tangential) {
  EXPECT_EQ(found.normal, normal);
  EXPECT_EQ(found.tangential, tangential);
}

TEST(EdgeState, ComesFromTheSideOfTheFlow) {
  expect_state(upwind<double>({2, 10}, {1, 20}), 2, 10);
  expect_state(upwind<double>({-1, 10}, {-2, 20}), -2, 20);
  expect_state(upwind<double>({2, 10}, {-1, 20}), 2, 10);
  expect_state(upwind<double>({1, 10}, {-2, 20}), -2, 20);
  expect_state(upwind<double>({-1, 10}, {1, 20}), 0, 15);
  expect_state(upwind<double>({1, 10}, {-1, 20}), 0, 15);
}

}  // namespace
}  // namespace mortise
