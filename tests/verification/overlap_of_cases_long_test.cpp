// No cell of any plane case is ever without a donor, as shipped.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;

const char* const plane_cases[] = {"free_stream",
                                   "vortex_over_moving_grid",
                                   "weak_shock_on_free_cylinder",
                                   "shock_on_free_cylinder",
                                   "massless_ellipse",
                                   "shock_rigid_sticks",
                                   "many_cylinders"};

TEST(OverlapOfCasesLong, HasNoOrphansAsShipped) {
  for (const char* name : plane_cases) {
    CaseRun<2> run(name);
    EXPECT_TRUE(run.run().finished()) << name << ": " << run.reason();  // an orphan is an error
    EXPECT_EQ(run.simulation.fluid().overlap().report().orphans, 0) << name;
  }
}

}  // namespace
}  // namespace mortise
