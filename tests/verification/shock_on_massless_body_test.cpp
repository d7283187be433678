// A Mach-2 shock passes a body without mass, 400 cells in the tube. Exact: as if the body were not there.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

constexpr double u2 = 1.479019945775, p2 = 4.5, shock_speed = 2.366431913240, arrival = 0.4 / shock_speed;
const Overrides four_hundred_cells = {set("grid.factor", 400 / 30.0)};

struct Passed : CaseRun<1> {
  explicit Passed(const Overrides& overrides) : CaseRun<1>("shock_on_massless_body", four_hundred_cells + overrides) {
    run();
    EXPECT_EQ(simulation.fluid().grids().front().cells[0], 400);
    EXPECT_TRUE(finished()) << reason();
  }
};

TEST(ShockOnMasslessBody, BodyMovesWithTheGasBehindTheShock) {
  for (const std::string limiter : {"mc", "minmod", "van_albada"}) {
    const Passed run({"fluid.limiter=" + limiter});
    const double h = 3.0 / 400, clear = arrival + 10 * h / shock_speed;  // the captured shock has left the body behind
    int steps = 0;
    for (const BodySample<1>& now : run.histories[0])
      if (now.time > clear) {
        EXPECT_NEAR(now.velocity[0], u2, 0.01 * u2) << limiter << ", t = " << now.time;
        EXPECT_NEAR(now.load.force[0], 0, 1e-11 * p2) << limiter << ", t = " << now.time;
        ++steps;
      }
    EXPECT_GT(steps, 150);
    EXPECT_NEAR(run.histories[0].back().pose.position[0], u2 * (0.6 - arrival), 0.5 * h) << limiter;
    EXPECT_NEAR(run.histories[0].back().velocity[0], u2, 1e-3 * u2) << limiter;
  }
}

/// Largest |p − p₂|/p₂ between the left end and the body at the end of a run.
double reflected(const CaseRun<1>& run) {
  double worst = 0;
  for (const ActiveCell<1>& cell : run.cells())
    if (cell.x[0] < run.simulation.bodies()[0].pose.position[0])
      worst = std::max(worst, std::abs(cell.W.pressure / p2 - 1));
  return worst;
}

TEST(ShockOnMasslessBody, ReflectedWaveIsBelowOnePercent) {
  for (const std::string limiter : {"mc", "minmod", "van_albada"})
    EXPECT_LT(reflected(Passed({"fluid.limiter=" + limiter})), 0.01) << limiter;
}

TEST(ShockOnMasslessBody, ReflectedWaveDecaysUnderRefinement) {
  CaseRun<1> fine("shock_on_massless_body", {"grid.factor=80"});
  EXPECT_LT(reflected(fine.run()), 0.006);
}

/// Against a wall of the same kind as a very heavy body: p = 15 and ρ = 6 behind the reflected shock.
TEST(ShockOnMasslessBody, HeavyBodyReflectsTheShock) {
  const Passed run({"bodies.0.mass=1e9", "exact=none"});
  double worst = 0;
  for (const ActiveCell<1>& cell : run.cells())
    if (cell.x[0] > -0.4 && cell.x[0] < -0.2) worst = std::max(worst, std::abs(cell.W.pressure / 15 - 1));
  EXPECT_LT(worst, 0.02);
  EXPECT_LT(std::abs(run.histories[0].back().velocity[0]), 1e-7);
}

}  // namespace
}  // namespace mortise
