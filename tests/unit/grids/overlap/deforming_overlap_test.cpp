// Bodies that change shape, bodies around the gas, and bodies made of a fitted grid and a Cartesian core.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/grids/overlap/deforming_scene.hpp"

namespace mortise {
namespace {

using testing::atlas_of;
using testing::Curve;
using testing::DeformingScene;
using testing::ellipse;


double linear(const Point<2>& x) { return 1 + 2 * x[0] - 3 * x[1]; }
double quadratic(const Point<2>& x) { return linear(x) + x[0] * x[0] - 2 * x[0] * x[1] + 0.5 * x[1] * x[1]; }

TEST(DeformingOverlap, AnEllipseBreathesAndTurnsBesideADisk) {
  constexpr double h = 0.025;
  const auto shape = [&](int step) {
    const double phase = 2 * std::numbers::pi * step / 200;
    return atlas_of(ellipse(0.3 + 0.05 * std::sin(phase), 0.25 - 0.05 * std::sin(2 * phase), phase, 68, false), h, 8, false);
  };
  Curve disk = ellipse(0.2, 0.2, 0, 52, false);
  for (Point<2>& x : disk) x += Point<2>(0.6, 0.55);
  DeformingScene scene(h, 1, {shape(0), atlas_of(disk, h, 8, false)}, {.clip = false});
  std::int64_t exposed = 0;
  for (int step = 1; step <= 200; ++step) {
    scene.reshape(0, shape(step));
    ASSERT_LT(scene.step(true, 0, linear), 1e-11) << step << ", tight: " << scene.overlap().report().tight;
    exposed += scene.overlap().report().exposed;
  }
  EXPECT_GT(exposed, 100);
  const std::vector<CellState> settled = scene.states();
  DeformingScene fresh(h, 1, {shape(200), atlas_of(disk, h, 8, false)}, {.clip = false});
  EXPECT_EQ(settled, fresh.states());
}

TEST(DeformingOverlap, NothingMovesWithoutReshape) {
  constexpr double h = 0.05;
  const std::shared_ptr<const BodyAtlas> disk = atlas_of(ellipse(0.3, 0.3, 0, 36, false), h, 8, false);
  DeformingScene scene(h, 1.2, {disk}, {});
  EXPECT_TRUE(scene.update()) << "the last motion's exposed cells are donors from now on";
  EXPECT_FALSE(scene.update());
  scene.reshape(0, disk);
  EXPECT_TRUE(scene.update());
}

TEST(DeformingOverlap, GasWithinABreathingBody) {
  constexpr double h = 0.025;
  const auto shape = [&](int step) {
    const double phase = 2 * std::numbers::pi * step / 30;
    return atlas_of(ellipse(0.7 + 0.06 * std::sin(phase), 0.7 - 0.06 * std::sin(phase), 0.5 * phase, 176, true), h, 8, true);
  };
  DeformingScene scene(h, 1, {shape(0)}, {.clip = false});
  for (int step = 1; step <= 30; ++step) {
    const std::shared_ptr<const BodyAtlas> atlas = shape(step);
    scene.reshape(0, atlas);
    ASSERT_LT(scene.step(true, 0, linear), 1e-11) << step;
    ASSERT_LT(scene.step(false, 1, quadratic), 1e-11) << "from the background, " << step;
    if (step % 10 != 7) continue;
    const std::vector<CellState> settled = scene.states();
    DeformingScene fresh(h, 1, {atlas}, {.clip = false});
    ASSERT_EQ(settled, fresh.states()) << step;
  }
  int covered = 0;
  scene.for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double&) {
    if (g > 0 || x.norm() < 0.7) return;
    ++covered;
    EXPECT_EQ(DeformingScene::state(mask, k), CellState::hole) << x.transpose();
  });
  EXPECT_GT(covered, 3000);
}

/// A body of a grid within its outline and a Cartesian core: everything is interpolated, to full order.
void expect_composite(const Outline& outline, double spacing, int layers) {
  const GrownGrid grid = grow(outline, {.spacing = spacing, .layers = layers, .inward = true});
  const auto atlas = std::make_shared<const BodyAtlas>(outline, grid, true);
  const double half_width = outline.bounds().high.maxCoeff() + 4 * spacing;
  DeformingScene scene(spacing, half_width, {atlas}, composite_options<2>({atlas, grid.thickness, layers}, spacing));
  EXPECT_EQ(scene.overlap().report().tight, 0);
  EXPECT_LT(scene.step(false, 0, linear), 1e-11);
  EXPECT_LT(scene.step(false, 1, quadratic), 1e-11);
}

TEST(Composite, Stick) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  for (const int layers : {5, 6}) {
    SCOPED_TRACE(layers);
    expect_composite(stick, 0.0125, layers);
    expect_composite(stick, 0.00625, layers);
  }
}

TEST(Composite, Disk) { expect_composite(Outline::circle(0.4), 0.025, 6); }
TEST(Composite, Ellipse) { expect_composite(Outline::ellipse(0.4, 0.25), 0.02, 6); }

TEST(Composite, PlateWithAHole) {
  constexpr double h = 0.04;
  const Outline hole = Outline::circle(0.3);
  const auto atlas = std::make_shared<const BodyAtlas>(hole, grow(hole, {.spacing = h, .layers = 6}));
  DeformingScene scene(h, 1, {atlas}, composite_options<2>({atlas, h, 6}, h));
  EXPECT_EQ(scene.overlap().report().tight, 0);
  EXPECT_LT(scene.step(false, 0, linear), 1e-11);
  EXPECT_LT(scene.step(false, 1, quadratic), 1e-11);
}

}  // namespace
}  // namespace mortise
