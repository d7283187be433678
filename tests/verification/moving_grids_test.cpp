// Body-fitted grids that move and turn through the gas without touching it: the exact answer knows nothing of them.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

double largest_error(const CaseRun<2>& run) {
  double largest = 0;
  for (const auto& [name, norms] : run.errors()) largest = std::max(largest, norms.max);
  return largest;
}

TEST(FreeStream, StaysUniformToRoundOff) {
  for (const double factor : {1.25, 2.5})
    for (const char* riemann : {"hllc", "exact", "hlle"}) {
      CaseRun<2> run("free_stream", {set("grid.factor", factor), std::string("fluid.riemann=") + riemann});
      ASSERT_TRUE(run.run().finished()) << run.reason();
      EXPECT_GT(run.simulation.fluid().overlap().grids().size(), 2u);
      EXPECT_LE(largest_error(run), 1e-13) << riemann << ", grid.factor " << factor;
    }
}

TEST(FreeStream, StaysUniformWithLimiters) {
  for (const char* limiter : {"minmod", "mc", "van_albada"}) {
    CaseRun<2> run("free_stream", {std::string("fluid.limiter=") + limiter});
    ASSERT_TRUE(run.run().finished()) << run.reason();
    EXPECT_LE(largest_error(run), 1e-13) << limiter;
  }
}

const std::vector<std::string> quantities = {"fluid.density", "fluid.velocity_x", "fluid.velocity_y", "fluid.pressure"};

TEST(VortexOverMovingGrid, IsSecondOrder) {
  std::vector<std::map<std::string, ErrorNorms>> errors;
  for (const double factor : {2.5, 5.0, 10.0}) {
    CaseRun<2> run("vortex_over_moving_grid", {set("grid.factor", factor)});
    ASSERT_TRUE(run.run().finished()) << run.reason();
    errors.push_back(run.errors());
  }
  double sum = 0;
  for (const std::string& name : quantities) {
    for (std::size_t level = 1; level < errors.size(); ++level) {
      const ErrorNorms &coarse = errors[level - 1].at(name), &fine = errors[level].at(name);
      EXPECT_GE(testing::order(coarse.l1, fine.l1), 2.0) << name << ", level " << level;
      EXPECT_GE(testing::order(coarse.max, fine.max), 2.0) << name << ", level " << level;
    }
    sum += errors.back().at(name).l1;
  }
  EXPECT_LE(sum, 4.0e-5);
}

}  // namespace
}  // namespace mortise
