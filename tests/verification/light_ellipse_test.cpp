// A light, soft ellipse under the pressure behind a shock: without the tie of the interface's nodes to its deformation wrinkles
// of three to four cells fold the gas's grid at t = 1.8.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

TEST(LightEllipse, KeepsItsSurfaceUnderPressure) {
  testing::CaseRun<2> run("shock_light_ellipse", {"time.end=2.2"});
  run.run();
  EXPECT_TRUE(run.finished()) << run.reason();
  EXPECT_GT(run.simulation.least_j(), 0.8);
}

}  // namespace
}  // namespace mortise
