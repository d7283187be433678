// A Mach-2 shock sweeps away an ellipse of any mass, none included, at h = 1/40. The long test has the finer grids.
#include "verification/massless_ellipse_checks.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::Overrides;
using testing::operator+;

const Overrides coarse_grid = {"grid.factor=4"};

TEST(MasslessEllipse, FollowsThePublishedMotion) {
  CaseRun<2> run("massless_ellipse", coarse_grid);
  for (const testing::EllipseAt& expected : testing::published_ellipse) {
    ASSERT_TRUE(run.run(expected.time).finished()) << run.reason();
    expect_ellipse(run, expected, 0.006, 1);  // the figures ±0.004, the grid ±0.002
  }
}

// Grids from h = 1/20 to 1/160 give (.7355 ± .002, .0440 ± .001), turned by 32.3° ± .1° (both schemes).
TEST(MasslessEllipse, TurnsLessWhenItIsHeavy) {
  CaseRun<2> run("massless_ellipse", coarse_grid + Overrides{"bodies.0.density=1"});
  EXPECT_NEAR(run.simulation.bodies()[0].mass, 0.7697, 1e-4);
  EXPECT_NEAR(run.simulation.bodies()[0].inertia, 0.11786, 1e-5);
  ASSERT_TRUE(run.run().finished()) << run.reason();
  expect_ellipse(run, testing::heavy_ellipse, 0.005, 2);
}

TEST(MasslessEllipse, TraditionalSchemeAgreesWhenItIsHeavy) {
  CaseRun<2> added_mass("massless_ellipse", coarse_grid + Overrides{"bodies.0.density=1"});
  CaseRun<2> traditional("massless_ellipse", coarse_grid + Overrides{"bodies.0.density=1", "scheme=traditional"});
  ASSERT_TRUE(added_mass.run().finished()) << added_mass.reason();
  ASSERT_TRUE(traditional.run().finished()) << traditional.reason();
  expect_ellipse(traditional, ellipse(added_mass), 0.002, 0.2);
}

// The traditional scheme is stable up to (added mass per time) × Δt/mass = 2, here at a density near 0.02; finer grids
// with their smaller Δt move the bound down.
TEST(MasslessEllipse, TraditionalSchemeBlowsUpWhenItIsLight) {
  for (const char* density : {"bodies.0.density=0.01", "bodies.0.density=0.001"}) {
    const Overrides light = coarse_grid + Overrides{density};
    CaseRun<2> added_mass("massless_ellipse", light),
        traditional("massless_ellipse", light + Overrides{"scheme=traditional"});
    ASSERT_TRUE(added_mass.run(1).finished()) << added_mass.reason();
    expect_ellipse(added_mass, testing::published_ellipse[2], 0.015, 2);
    EXPECT_FALSE(traditional.run(1).finished()) << density;
    EXPECT_LT(traditional.simulation.time(), 0.6) << density;
  }
}

TEST(MasslessEllipse, TraditionalSchemeIsRefusedWithoutMass) {
  EXPECT_THROW(CaseRun<2>("massless_ellipse", coarse_grid + Overrides{"scheme=traditional"}), InputError);
}

}  // namespace
}  // namespace mortise
