// Soft solids under the pressure behind a shock: their surfaces stay smooth.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

// Without the tie of the interface's nodes to the deformation wrinkles of three to four cells fold the gas's grid at t = 1.8.
TEST(LightEllipse, KeepsItsSurfaceUnderPressure) {
  testing::CaseRun<2> run("shock_light_ellipse", {"time.end=2.2"});
  run.run();
  EXPECT_TRUE(run.finished()) << run.reason();
  EXPECT_GT(run.simulation.least_j(), 0.8);
}

// Density 1 in gas of density 1 to 8, λ = μ = 4 under pressures of 2 to 15: bent and compressed, not crumpled.
TEST(SoftSticks, KeepTheirSurfacesBehindTheShock) {
  testing::CaseRun<2> run("shock_deformable_sticks", {"solid.scale=0.1"});
  run.run();
  EXPECT_TRUE(run.finished()) << run.reason();
  EXPECT_GT(run.simulation.least_j(), 0.6);
}

}  // namespace
}  // namespace mortise
