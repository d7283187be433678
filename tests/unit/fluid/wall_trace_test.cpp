#include <gtest/gtest.h>

#include <limits>

#include "unit/fluid/plane_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(WallTrace, LineAtRestExtrapolatesLinearly) {
  TileShape<1> shape({8});
  TileBlock now(shape.plane, 3);
  for (int i = 0; i < 8; ++i)
    put(now, shape.at(i), to_conserved(Primitive<1>{1 + 0.1 * i, {0}, 2 - 0.05 * i}, gamma_air));
  const MovingLineTile tile{{&shape, now.component(0), nullptr, {0.5}, nullptr}, 0, {}, {}};
  const double dt = 0.1;
  const WallTrace1 left = wall_trace(tile, false, dt, {}), right = wall_trace(tile, true, dt, {});
  EXPECT_NEAR(left.now.density, 0.95, 1e-14);
  EXPECT_NEAR(left.now.pressure, 2.025, 1e-14);
  EXPECT_NEAR(right.now.density, 1.75, 1e-14);
  EXPECT_NEAR(right.now.pressure, 1.625, 1e-14);
  // u = 0: only the velocity changes in the half step, by −½Δt p_x/ρ of the cell.
  EXPECT_NEAR(left.half.velocity[0], -0.5 * dt * (-0.05 / 0.5) / 1.0, 1e-14);
  EXPECT_NEAR(right.half.velocity[0], -0.5 * dt * (-0.05 / 0.5) / 1.7, 1e-14);
  EXPECT_NEAR(left.half.density, 0.95, 1e-14);
}

TEST(WallTrace, LineExtrapolatesWithTheSlopeOfTheParabolaThroughThreeCells) {
  TileShape<1> shape({8});
  TileBlock now(shape.plane, 3);
  for (int i = 0; i < 8; ++i)
    put(now, shape.at(i), to_conserved(Primitive<1>{1 + 0.01 * i * i, {0}, 2 - 0.05 * i}, gamma_air));
  const MovingLineTile tile{{&shape, now.component(0), nullptr, {0.5}, nullptr}, 0, {}, {}};
  StepOptions options;
  options.limiter = Limiter::none;
  EXPECT_NEAR(wall_trace(tile, false, 0.1, options).now.density, 1, 1e-14);         // slope 0 at i = 0
  EXPECT_NEAR(wall_trace(tile, true, 0.1, options).now.density, 1.49 + 0.07, 1e-14);  // slope 0.14 at i = 7
}

TEST(WallTrace, EndsOfAMirroredLineAreMirrorImages) {
  TileShape<1> shape({8});
  TileBlock a(shape.plane, 3), b(shape.plane, 3);
  for (int i = 0; i < 8; ++i) {
    const Primitive<1> W{1 + 0.3 * noise(i, 0), {noise(i, 1)}, 1 + noise(i, 2)};
    put(a, shape.at(i), to_conserved(W, gamma_air));
    put(b, shape.at(7 - i), to_conserved(Primitive<1>{W.density, {-W.velocity[0]}, W.pressure}, gamma_air));
  }
  const MovingLineTile s{{&shape, a.component(0), nullptr, {0.5}, nullptr}, 0.3, {}, {}};
  const MovingLineTile t{{&shape, b.component(0), nullptr, {0.5}, nullptr}, -0.3, {}, {}};
  const WallTrace1 left = wall_trace(s, false, 0.1, {}), right = wall_trace(t, true, 0.1, {});
  EXPECT_EQ(left.now.density, right.now.density);
  EXPECT_EQ(left.half.pressure, right.half.pressure);
  EXPECT_EQ(left.half.velocity[0], -right.half.velocity[0]);
}

TEST(WallTrace, SteepProfileFallsBackToTheCellAverage) {
  TileShape<1> shape({4});
  TileBlock now(shape.plane, 3);
  for (int i = 0; i < 4; ++i)
    put(now, shape.at(i), to_conserved(Primitive<1>{1, {i * 30.0}, i == 0 ? 0.01 : 1}, gamma_air));
  const MovingLineTile tile{{&shape, now.component(0), nullptr, {0.5}, nullptr}, 0, {}, {}};
  const WallTrace1 trace = wall_trace(tile, false, 0.1, {});
  EXPECT_NEAR(trace.now.pressure, 0.001, 1e-15);  // half a slope takes 0.9 of it
  EXPECT_NEAR(trace.half.pressure, 0.01, 1e-15);
  EXPECT_EQ(trace.half.density, 1);
}

TEST(WallTrace, PlaneTracesAreSecondOrderOnAMovingSkewedGrid) {
  // A field linear in space, u = const, p = const: it is advected, q(x, t) = q0 + g·(x − u t), exactly.
  const int nx = 20, ny = 6;
  const double hx = 0.1, hy = 0.05, dt = 0.02;
  const std::array<double, 2> u = {0.4, -0.3};
  PlaneNodes nodes({nx, ny});
  const auto position = [&](int i, int j) -> Point<2> { return {hx * i + 0.4 * hy * j, hy * j + 0.1 * hx * i}; };
  nodes.place(position);
  const Point<2> w{0.25, -0.15};
  nodes.move([&](int, int) { return w; });
  const auto density = [](const Point<2>& x) { return 1 + 0.3 * x[0] - 0.2 * x[1]; };
  const auto centre = [&](int i, int j) -> Point<2> {
    return 0.25 * (position(i, j) + position(i + 1, j) + position(i, j + 1) + position(i + 1, j + 1));
  };
  PlaneTile tile({nx, ny}, [&](int i, int j) { return Primitive<2>{density(centre(i, j)), u, 1}; });
  for (int i = -2; i < nx + 2; ++i)
    tile.now.component(0)[tile.shape.at(i, -1)] = std::numeric_limits<double>::quiet_NaN();
  for (const bool at_rest : {false, true}) {
    CurvilinearTile view = nodes.tile(tile);
    if (at_rest) view.wx = view.wy = nullptr;
    view.south.present = true;
    std::vector<WallTrace2> traces(nx);
    wall_traces(view, dt, {}, traces.data());
    for (int i = 0; i < nx; ++i) {
      const Point<2> face = 0.5 * (position(i, 0) + position(i + 1, 0)), velocity = at_rest ? Point<2>{0, 0} : w;
      const Point<2> upstream = face + 0.5 * dt * (velocity - Point<2>{u[0], u[1]});
      const auto& trace = traces[static_cast<std::size_t>(i)];
      EXPECT_NEAR(trace.now.density, density(face), 1e-13);
      EXPECT_NEAR(trace.half.density, density(upstream), 1e-13);
      EXPECT_NEAR(trace.half.velocity[1], u[1], 1e-14);
      EXPECT_NEAR(trace.half.pressure, 1, 1e-14);
    }
  }
}

}  // namespace
}  // namespace mortise
