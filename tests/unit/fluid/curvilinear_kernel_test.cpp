#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "unit/fluid/plane_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;
using std::numbers::pi;

constexpr double spacing = 0.1;

Point<2> square(int i, int j) { return {spacing * i, spacing * j}; }
/// Smoothly deforming nodes.
[[gnu::noinline]] Point<2> wavy(int i, int j, double t) {
  const double x = spacing * i, y = spacing * j;
  return {x + 0.03 * std::sin(2 * pi * (x - 0.7 * y) + 3 * t) + 0.2 * t,
          y + 0.03 * std::cos(2 * pi * (0.6 * x + y) - 2 * t) - 0.1 * t};
}
[[gnu::noinline]] Point<2> shear_velocity(int i, int j) {
  return {0.3 * std::sin(0.4 * j) + 0.1 * i * spacing, 0.2 * std::cos(0.3 * i)};
}

struct Scene {
  explicit Scene(Index<2> cells, const PlaneTile::StateOf& state = noisy_state) : tile(cells, state), nodes(cells) {
    nodes.place([](int i, int j) { return wavy(i, j, 0.1); });
    nodes.move(shear_velocity);
  }
  CurvilinearTile view() { return nodes.tile(tile); }
  PlaneTile tile;
  PlaneNodes nodes;
};

TEST(CurvilinearKernel, SquaresAtRestGiveTheCartesianAnswer) {
  for (const Limiter limiter : {Limiter::none, Limiter::mc})
    for (const RiemannSolver solver : {RiemannSolver::hllc, RiemannSolver::hlle, RiemannSolver::exact}) {
      Scene scene({14, 8});
      scene.nodes.place(square);
      scene.nodes.move([](int, int) { return Point<2>{0, 0}; });
      PlaneTile cartesian({14, 8}, noisy_state);
      const StepResult a = godunov_step(scene.view(), 0.005, gas_options(limiter, solver));
      const StepResult b = godunov_step(cartesian.cartesian(spacing, spacing), 0.005, gas_options(limiter, solver));
      EXPECT_NEAR(a.rate, b.rate, 1e-12 * b.rate);
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 14; ++i) EXPECT_LT(distance(scene.tile.after(i, j), cartesian.after(i, j)), 2e-14);
    }
}

TEST(CurvilinearKernel, NoVelocitiesMeanAGridAtRest) {
  Scene scene({14, 8}), rest({14, 8});
  scene.nodes.move([](int, int) { return Point<2>{0, 0}; });
  godunov_step(scene.view(), 0.005, gas_options());
  CurvilinearTile view = rest.view();
  view.wx = view.wy = nullptr;
  godunov_step(view, 0.005, gas_options());
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 14; ++i) EXPECT_TRUE(same_bits(scene.tile.after(i, j), rest.tile.after(i, j)));
}

TEST(CurvilinearKernel, FreeStreamIsKeptOnDeformingNodes) {
  const Primitive<2> W{1.2, {0.8, -0.5}, 0.7};
  const Conserved<2> U = to_conserved(W, gamma_air);
  for (const RiemannSolver solver : {RiemannSolver::hllc, RiemannSolver::hlle, RiemannSolver::exact}) {
    Scene scene({20, 12}, [&](int, int) { return W; });
    const double dt = 0.01;
    double worst_step = 0, worst = 0;
    for (int step = 0; step < 200; ++step) {
      const double t = step * dt;
      scene.nodes.place([&](int i, int j) -> Point<2> { return 0.5 * (wavy(i, j, t) + wavy(i, j, t + dt)); });
      scene.nodes.move([&](int i, int j) -> Point<2> { return (wavy(i, j, t + dt) - wavy(i, j, t)) / dt; });
      scene.tile.fill([&](int i, int j) {
        return step == 0 || i < 0 || j < 0 || i >= 20 || j >= 12 ? W : scene.tile.primitive(i, j);
      });
      EXPECT_TRUE(godunov_step(scene.view(), dt, gas_options(Limiter::mc, solver)).admissible);
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 20; ++i) {
          worst_step = std::max(worst_step, distance(scene.tile.before(i, j), scene.tile.after(i, j)));
          worst = std::max(worst, distance(U, scene.tile.after(i, j)));
        }
      scene.tile.accept();
    }
    EXPECT_LT(worst_step, 2e-14);
    EXPECT_LT(worst, 1e-13);
  }
}

TEST(CurvilinearKernel, GridMovingWithTheFrameSeesTheSameFlow) {
  const Point<2> w{0.6, -0.9};
  Scene rest({14, 8}), moving({14, 8}, [&](int i, int j) {
    Primitive<2> W = noisy_state(i, j);
    for (std::size_t d = 0; d < 2; ++d) W.velocity[d] += w[static_cast<int>(d)];
    return W;
  });
  rest.nodes.move([](int, int) { return Point<2>{0, 0}; });
  moving.nodes.move([&](int, int) { return w; });
  const StepResult a = godunov_step(rest.view(), 0.005, gas_options()),
                   b = godunov_step(moving.view(), 0.005, gas_options());
  EXPECT_NEAR(a.rate, b.rate, 1e-12 * a.rate);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 14; ++i) {
      Primitive<2> W = to_primitive(moving.tile.after(i, j), gamma_air);
      for (std::size_t d = 0; d < 2; ++d) W.velocity[d] -= w[static_cast<int>(d)];
      EXPECT_LT(distance(rest.tile.after(i, j), to_conserved(W, gamma_air)), 3e-14);
    }
}

TEST(CurvilinearKernel, TileSizeDoesNotChangeABit) {
  Scene whole({32, 16});
  const StepResult all = godunov_step(whole.view(), 0.003, gas_options());
  double rate = 0;
  for (const int first : {0, 16}) {
    Scene part({16, 16}, [first](int i, int j) { return noisy_state(i + first, j); });
    part.nodes.place([first](int i, int j) { return wavy(i + first, j, 0.1); });
    part.nodes.move([first](int i, int j) { return shear_velocity(i + first, j); });
    rate = std::max(rate, godunov_step(part.view(), 0.003, gas_options()).rate);
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 16; ++i) EXPECT_TRUE(same_bits(part.tile.after(i, j), whole.tile.after(i + first, j)));
  }
  EXPECT_EQ(rate, all.rate);
}

TEST(CurvilinearKernel, DependsOnCellsWithinTwoStepsAndNoOthers) {
  const int n = 12, ic = 6, jc = 5;
  const auto smooth = [](int i, int j) { return wavy_state(0.3 * i, 0.3 * j); };
  Scene scene({n, n}, smooth), changed({n, n}, [&](int i, int j) {
    Primitive<2> W = smooth(i, j);
    if (i == ic && j == jc) W.density *= 1.01, W.pressure *= 1.02;
    return W;
  });
  godunov_step(scene.view(), 0.005, gas_options());
  godunov_step(changed.view(), 0.005, gas_options());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      EXPECT_EQ(same_bits(scene.tile.after(i, j), changed.tile.after(i, j)), std::abs(i - ic) + std::abs(j - jc) > 2);
}

TEST(CurvilinearKernel, InactiveCellsKeepTheirValueAndNaNIsReported) {
  Scene scene({16, 8}), full({16, 8});
  CurvilinearTile view = scene.view();
  view.active = scene.tile.active.data();
  scene.tile.active[scene.tile.shape.at(5, 3)] = 0;
  EXPECT_TRUE(godunov_step(view, 0.003, gas_options()).admissible);
  godunov_step(full.view(), 0.003, gas_options());
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 16; ++i)
      EXPECT_TRUE(
          same_bits(scene.tile.after(i, j), i == 5 && j == 3 ? scene.tile.before(i, j) : full.tile.after(i, j)));
  scene.tile.now.component(1)[scene.tile.shape.at(9, 3)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(godunov_step(view, 0.003, gas_options()).admissible);
  EXPECT_FALSE(wave_rate(view, gas_options()).admissible);
}

TEST(CurvilinearKernel, RateOfTheNewStateOnTheMovedGrid) {
  Scene scene({16, 8});
  const double dt = 1e-9;
  const StepResult step = godunov_step(scene.view(), dt, gas_options());
  EXPECT_NEAR(step.rate, wave_rate(scene.view(), gas_options()).rate, 1e-6 * step.rate);
}

/// A scene whose ghost cells below the wall must not be read: they are NaN.
Scene walled(const PlaneTile::StateOf& state, std::vector<double>& pressure, Index<2> cells = {16, 8}) {
  Scene scene(cells, state);
  for (int j = -2; j < 0; ++j)
    for (int i = -2; i < cells[0] + 2; ++i)
      scene.tile.now.component(0)[scene.tile.shape.at(i, j)] = std::numeric_limits<double>::quiet_NaN();
  pressure.resize(static_cast<std::size_t>(cells[0]));
  return scene;
}

TEST(CurvilinearKernel, GasMovingWithAWallFeelsNothing) {
  std::vector<double> pressure;
  const Point<2> w{0.3, 0.2};
  Scene scene = walled([&](int, int) { return Primitive<2>{1.1, {w[0], w[1]}, 0.8}; }, pressure);
  pressure.assign(16, 0.8);
  scene.nodes.move([&](int, int) { return w; });
  CurvilinearTile view = scene.view();
  view.south = {true, pressure.data()};
  EXPECT_TRUE(godunov_step(view, 0.01, gas_options()).admissible);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 16; ++i) EXPECT_LT(distance(scene.tile.before(i, j), scene.tile.after(i, j)), 1e-14);
}

TEST(CurvilinearKernel, WallPressurePushesAndWorksOnTheCellsAtTheWall) {
  std::vector<double> pressure;
  const Point<2> w{0.3, 0.2};
  const double dt = 0.01, excess = 0.25;
  Scene scene = walled([&](int, int) { return Primitive<2>{1.1, {w[0], w[1]}, 0.8}; }, pressure);
  pressure.assign(16, 0.8 + excess);
  scene.nodes.place(square);
  scene.nodes.move([&](int, int) { return w; });
  CurvilinearTile view = scene.view();
  view.south = {true, pressure.data()};
  godunov_step(view, dt, gas_options());
  for (int i = 0; i < 16; ++i) {
    const Conserved<2> a = scene.tile.after(i, 0), b = scene.tile.before(i, 0);
    EXPECT_NEAR(a.density, b.density, 1e-15);
    EXPECT_NEAR(a.momentum[0], b.momentum[0], 1e-15);
    EXPECT_NEAR(a.momentum[1] - b.momentum[1], dt / spacing * excess, 1e-14);
    EXPECT_NEAR(a.energy - b.energy, dt / spacing * excess * w[1], 1e-14);
  }
}

TEST(CurvilinearKernel, SlopeAtAWallIsThatOfTheParabolaThroughThreeCells) {
  // With the central slope of Limiter::none and the parabola in the ghosts too, the answer next to a wall is the same.
  const auto parabola = [](int, int j) {
    return Primitive<2>{1 + 0.01 * j + 0.002 * j * j, {0.2 + 0.001 * j * j, 0}, 1 - 0.005 * j + 0.001 * j * j};
  };
  std::vector<double> pressure;
  Scene scene = walled(parabola, pressure), open({16, 8}, parabola);
  scene.nodes.place(square), open.nodes.place(square);
  for (Scene* s : {&scene, &open}) s->nodes.move([](int, int) { return Point<2>{0, 0}; });
  pressure.assign(16, 1 + 0.0025);
  CurvilinearTile view = scene.view();
  view.south = {true, pressure.data()};
  godunov_step(view, 0.01, gas_options(Limiter::none));
  godunov_step(open.view(), 0.01, gas_options(Limiter::none));
  for (int i = 0; i < 16; ++i) EXPECT_LT(distance(scene.tile.after(i, 1), open.tile.after(i, 1)), 1e-14);
}

}  // namespace
}  // namespace mortise
