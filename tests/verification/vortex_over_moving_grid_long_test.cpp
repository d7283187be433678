// The vortex under a moving annulus where the order has settled: h = 0.01 and 0.005.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

TEST(VortexOverMovingGridLong, IsSecondOrderInTheMeanAndInTheMaximumNorm) {
  CaseRun<2> coarse("vortex_over_moving_grid", {set("grid.factor", 10)});
  CaseRun<2> fine("vortex_over_moving_grid", {set("grid.factor", 20)});
  ASSERT_TRUE(coarse.run().finished()) << coarse.reason();
  ASSERT_TRUE(fine.run().finished()) << fine.reason();
  const auto before = coarse.errors(), after = fine.errors();
  double sum = 0;
  for (const char* name : {"fluid.density", "fluid.velocity_x", "fluid.velocity_y", "fluid.pressure"}) {
    EXPECT_GE(testing::order(before.at(name).l1, after.at(name).l1), 2.0) << name;
    EXPECT_GE(testing::order(before.at(name).max, after.at(name).max), 2.0) << name;
    sum += after.at(name).l1;
  }
  EXPECT_LE(sum, 8e-6);
}

}  // namespace
}  // namespace mortise
