#include "mortise/fluid/wall_slope.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mortise {
namespace {

/// q0 + q1 s + q2 s² at the centre of cell k, s = k.
Primitive<2> parabola(int k, double curvature) {
  return {1.2 + 0.02 * k + 3 * curvature * k * k,
          {0.3 - 0.05 * k - curvature * k * k, 0.1 * k + 2 * curvature * k * k},
          2.5 - 0.04 * k + curvature * k * k};
}

template <Limiter limiter>
Primitive<2> ghost_of(double curvature) {
  return beyond_wall<limiter>(parabola(0, curvature), parabola(1, curvature), parabola(2, curvature));
}

void expect_near(const Primitive<2>& a, const Primitive<2>& b, double tolerance) {
  EXPECT_NEAR(a.density, b.density, tolerance);
  EXPECT_NEAR(a.velocity[0], b.velocity[0], tolerance);
  EXPECT_NEAR(a.velocity[1], b.velocity[1], tolerance);
  EXPECT_NEAR(a.pressure, b.pressure, tolerance);
}

TEST(WallSlope, ParabolaIsContinuedWithoutLimiter) {
  expect_near(ghost_of<Limiter::none>(0.01), parabola(-1, 0.01), 1e-15);
}

TEST(WallSlope, LinearFlowIsContinuedWithEveryLimiter) {
  expect_near(ghost_of<Limiter::minmod>(0), parabola(-1, 0), 1e-15);
  expect_near(ghost_of<Limiter::mc>(0), parabola(-1, 0), 1e-15);
  expect_near(ghost_of<Limiter::van_albada>(0), parabola(-1, 0), 1e-15);
}

/// A contact is no shock: 1 to the last bit where p is uniform.
TEST(WallSlope, UniformPressureIsSmooth) { EXPECT_EQ(smoothness_at_wall(0.7, 0.7, 0.7), 1); }

TEST(WallSlope, DepartsFromOneWithTheFourthPowerOfTheSpacing) {
  const auto departure = [](double h) {
    const auto pressure = [h](int k) { return 1 + 0.3 * std::cos(1.5 * (k + 0.5) * h); };
    return 1 - smoothness_at_wall(pressure(0), pressure(1), pressure(2));
  };
  EXPECT_NEAR(std::log2(departure(0.02) / departure(0.01)), 4, 0.05);
}

TEST(WallSlope, VanishesAtStrongShocks) {
  EXPECT_LT(smoothness_at_wall(1.0, 1.0, 100.0), 1e-4);   // between cells 1 and 2, arriving
  EXPECT_LT(smoothness_at_wall(100.0, 1.0, 1.0), 1e-4);   // between cells 0 and 1, reflected
  EXPECT_EQ(smoothness_at_wall(1.0, 3.0, 1.0), 0);        // not monotone
  EXPECT_GT(smoothness_at_wall(1.0, 1.02, 1.01), 0.99);  // not monotone, but no shock
}

TEST(WallSlope, PackAgreesWithDoubleAndMirroredFlowGivesTheMirroredState) {
  const Primitive<1> W[3] = {{1.1, {0.31}, 0.9}, {1.35, {-0.17}, 1.3}, {1.21, {0.05}, 1.55}};
  Primitive<1, Pack> packs[3];
  Primitive<1> mirrored[3];
  for (int k = 0; k < 3; ++k) {
    packs[k] = {broadcast(W[k].density), {broadcast(W[k].velocity[0])}, broadcast(W[k].pressure)};
    mirrored[k] = {W[k].density, {-W[k].velocity[0]}, W[k].pressure};
  }
  const Primitive<1> ghost = beyond_wall<Limiter::mc>(W[0], W[1], W[2]);
  const Primitive<1, Pack> lanes = beyond_wall<Limiter::mc>(packs[0], packs[1], packs[2]);
  const Primitive<1> image = beyond_wall<Limiter::mc>(mirrored[0], mirrored[1], mirrored[2]);
  for (int k = 0; k < simd_width; ++k) EXPECT_NEAR(lane(lanes.pressure, k), ghost.pressure, 1e-15);
  EXPECT_NEAR(image.density, ghost.density, 1e-15);  // the kernels test the bits
  EXPECT_NEAR(image.velocity[0], -ghost.velocity[0], 1e-15);
  EXPECT_NEAR(image.pressure, ghost.pressure, 1e-15);
}

}  // namespace
}  // namespace mortise
