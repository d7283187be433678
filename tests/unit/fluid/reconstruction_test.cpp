#include "mortise/fluid/reconstruction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "unit/fluid/gas_options.hpp"

namespace mortise {
namespace {

using testing::gamma_air;
using Line = Primitive<1>;

TEST(Reconstruction, SlopesOfALineAreExact) {
  const Line h = limited_half_slopes<Limiter::mc>(Line{1, {2}, 3}, Line{1.5, {1}, 3.25}, Line{2, {0}, 3.5}, {});
  EXPECT_EQ(h.density, 0.25);
  EXPECT_EQ(h.velocity[0], -0.5);
  EXPECT_EQ(h.pressure, 0.125);
}

TEST(Reconstruction, FaceValuesStayPositive) {
  EXPECT_TRUE(rc::check("|h| ≤ 0.9 q for density and pressure", [] {
    const auto number = rc::gen::map(rc::gen::inRange(1, 1000000), [](int n) { return n * 1e-5; });
    const Line a{*number, {0}, *number}, b{*number, {0}, *number}, c{*number, {0}, *number};
    const Line h = limited_half_slopes<Limiter::none>(a, b, c, {});
    RC_ASSERT(std::abs(h.density) <= 0.9 * b.density);
    RC_ASSERT(std::abs(h.pressure) <= 0.9 * b.pressure);
  }));
}

TEST(Reconstruction, UniformFlowPassesTheHalfStepUnchanged) {
  const Line W{1.3, {0.7}, 2.1};
  const HalfSlopes<1, double> none{};
  const Line half = half_step(W, 1 / W.density, none, HalfStepTerms<1, double>{{0.3}, 0, {0}}, gamma_air);
  EXPECT_EQ(half.density, W.density);
  EXPECT_EQ(half.velocity[0], W.velocity[0]);
  EXPECT_EQ(half.pressure, W.pressure);
}

TEST(Reconstruction, HalfStepIsTheQuasiLinearFormInTwoDirections) {
  // W½ = W − ½Δt (A ∂x W + B ∂y W) with slopes δx, δy over cells hx, hy.
  const Primitive<2> W{2, {0.5, -0.3}, 1.5}, dx{0.1, {0.2, -0.1}, 0.05}, dy{-0.2, {0.3, 0.4}, 0.15};
  const double dt = 0.1, hx = 0.5, hy = 0.25;
  HalfSlopes<2, double> h;
  h[0] = {0.05, {0.1, -0.05}, 0.025};
  h[1] = {-0.1, {0.15, 0.2}, 0.075};
  const double courant[2] = {dt / hx, dt / hy};
  const Primitive<2> half = half_step(W, 1 / W.density, h, cartesian_terms(W, h, courant), gamma_air);
  const double div = dx.velocity[0] / hx + dy.velocity[1] / hy;
  const auto advect = [&](double x, double y) { return W.velocity[0] * x / hx + W.velocity[1] * y / hy; };
  EXPECT_NEAR(half.density, W.density - 0.5 * dt * (advect(dx.density, dy.density) + W.density * div), 1e-15);
  EXPECT_NEAR(half.velocity[0],
              W.velocity[0] - 0.5 * dt * (advect(dx.velocity[0], dy.velocity[0]) + dx.pressure / hx / W.density),
              1e-15);
  EXPECT_NEAR(half.velocity[1],
              W.velocity[1] - 0.5 * dt * (advect(dx.velocity[1], dy.velocity[1]) + dy.pressure / hy / W.density),
              1e-15);
  EXPECT_NEAR(half.pressure, W.pressure - 0.5 * dt * (advect(dx.pressure, dy.pressure) + gamma_air * W.pressure * div),
              1e-15);
}

TEST(Reconstruction, CellAverageReplacesInvalidFaces) {
  const Line W{1, {3}, 1};
  Line half{0.2, {2}, 0.5};
  HalfSlopes<1, double> h;
  h[0] = {0.3, {1}, 0.1};  // ρ½ − 0.3 < 0
  ensure_positive_faces(W, half, h);
  EXPECT_EQ(half.density, 1);
  EXPECT_EQ(half.velocity[0], 3);
  EXPECT_EQ(h[0].density, 0);
  EXPECT_EQ(h[0].velocity[0], 0);
}

TEST(Reconstruction, OnlyTheLanesThatNeedItFallBack) {
  using Wide = Primitive<1, Pack>;
  const Wide W{broadcast(1), {broadcast(3)}, broadcast(1)};
  Wide half{broadcast(0.5), {broadcast(2)}, broadcast(0.5)};
  HalfSlopes<1, Pack> h;
  h[0] = {broadcast(0.1), {broadcast(1)}, broadcast(0.1)};
  set_lane(h[0].pressure, 1, -0.6);
  ensure_positive_faces(W, half, h);
  for (int k = 0; k < simd_width; ++k) {
    EXPECT_EQ(half.density[k], k == 1 ? 1 : 0.5);
    EXPECT_EQ(h[0].velocity[0][k], k == 1 ? 0 : 1);
  }
}

}  // namespace
}  // namespace mortise
