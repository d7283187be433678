// The sticks on three grids, h = 0.025, 0.0125, 0.00625. Differences fall as the grid is refined, at first order, as
// long as the flow converges: the wakes of stick_2 roll up into vortices that no grid resolves in an inviscid gas, and
// differ by t = 1.
#include "verification/shock_rigid_sticks_checks.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

TEST(ShockRigidSticksLong, Converges) {
  std::vector<testing::Sticks> at_half, at_one;
  for (const double factor : {4.0, 8.0, 16.0}) {
    CaseRun<2> run("shock_rigid_sticks", {set("grid.factor", factor)});
    ASSERT_TRUE(run.run(0.5).finished()) << run.reason();
    at_half.push_back(sticks(run));
    ASSERT_TRUE(run.run(1).finished()) << run.reason();
    at_one.push_back(sticks(run));
    ASSERT_TRUE(run.run().finished()) << run.reason();
  }
  for (const std::size_t b : {0, 1, 2}) {
    EXPECT_LE(distance(at_half[2][b], at_half[1][b]), 0.65 * distance(at_half[1][b], at_half[0][b])) << "stick_" << b;
    EXPECT_LE(std::abs(at_half[2][b].turned - at_half[1][b].turned), 0.2) << "stick_" << b;
    EXPECT_LE(distance(at_half[2][b], testing::sticks_at_half[b]), 0.003) << "stick_" << b;
  }
  for (const std::size_t b : {0, 1, 3, 4}) {
    EXPECT_LE(distance(at_one[2][b], at_one[1][b]), 0.65 * distance(at_one[1][b], at_one[0][b])) << "stick_" << b;
    EXPECT_LE(distance(at_one[2][b], testing::sticks_at_one[b]), 0.008) << "stick_" << b;
    EXPECT_NEAR(at_one[2][b].turned, testing::sticks_at_one[b].turned, 3) << "stick_" << b;
  }
}

}  // namespace
}  // namespace mortise
