#include "mortise/fluid/plane_metrics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mortise {
namespace {

using Cell = MovingCell<double>;

const Cell unit{{0, 0, 0, 0}, {2, 0, 0, 0}, {0, 3, 0, 0}, {2, 3, 0, 0}};

TEST(PlaneMetrics, AreaVectorsPointTowardsIncreasingIndex) {
  EXPECT_EQ(unit.west().sx, 3);
  EXPECT_EQ(unit.west().sy, 0);
  EXPECT_EQ(unit.east().sx, 3);
  EXPECT_EQ(unit.south().sx, 0);
  EXPECT_EQ(unit.south().sy, 2);
  EXPECT_EQ(unit.north().sy, 2);
  EXPECT_EQ(unit.area(0), 6);
}

TEST(PlaneMetrics, SweptAreaIsTheMeanNodeVelocityTimesTheFace) {
  Cell cell = unit;
  cell.ne.wx = 1;
  cell.se.wx = 0.5;
  EXPECT_EQ(cell.east().swept, 0.75 * 3);
  EXPECT_EQ(cell.west().swept, 0);
}

TEST(PlaneMetrics, GeometricConservationLaw) {
  EXPECT_TRUE(rc::check("V(t + Δt) − V(t) = Δt Σ w·S", [] {
    const auto number = rc::gen::map(rc::gen::inRange(-1000, 1000), [](int n) { return n * 1e-3; });
    const auto node = [&](double x, double y) {
      return MovingNode<double>{x + 0.3 * *number, y + 0.3 * *number, *number, *number};
    };
    const Cell cell{node(0, 0), node(1, 0), node(0, 1), node(1, 1)};
    const double dt = 0.2 + 0.1 * *number;
    const double growth = cell.east().swept - cell.west().swept + cell.north().swept - cell.south().swept;
    RC_ASSERT(std::abs(cell.area(0.5 * dt) - cell.area(-0.5 * dt) - dt * growth) < 2e-15);
    RC_ASSERT(std::abs(cell.after(0.5 * dt).area(0) - cell.area(0.5 * dt)) < 2e-15);
  }));
}

TEST(PlaneMetrics, HalfStepTermsOfARectangleAreTheCartesianOnes) {
  const Primitive<2> W{1, {0.4, -0.6}, 1};
  HalfSlopes<2, double> h;
  h[0] = {0.1, {0.2, 0.3}, 0.4};
  h[1] = {-0.1, {0.5, -0.3}, 0.2};
  const double dt = 0.1, courant[2] = {dt / 2, dt / 3};
  const auto expected = cartesian_terms(W, h, courant);
  const auto terms =
      curvilinear_terms(W, h, unit.west() + unit.east(), unit.south() + unit.north(), 0.5 * dt / unit.area(0));
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_NEAR(terms.speed[d], expected.speed[d], 1e-16);
    EXPECT_NEAR(terms.force[d], expected.force[d], 1e-16);
  }
  EXPECT_NEAR(terms.divergence, expected.divergence, 1e-16);
}

}  // namespace
}  // namespace mortise
