// The main case as shipped, h = 0.0125, against an independent computation on an equal grid.
#include "verification/shock_rigid_sticks_checks.hpp"

namespace mortise {
namespace {

using testing::CaseRun;

void expect_sticks(const CaseRun<2>& run, const testing::Sticks& expected) {
  const testing::Sticks now = sticks(run);
  for (std::size_t b = 0; b < expected.size(); ++b) {
    EXPECT_LE(distance(now[b], expected[b]), 0.008)
        << "stick_" << b << ", t = " << run.simulation.time() << ": (" << now[b].x << ", " << now[b].y << ")";
    EXPECT_NEAR(now[b].turned, expected[b].turned, 3) << "stick_" << b << ", t = " << run.simulation.time();
  }
}

TEST(ShockRigidSticks, FollowsTheIndependentComputation) {
  CaseRun<2> run("shock_rigid_sticks");
  ASSERT_TRUE(run.run(0.5).finished()) << run.reason();
  expect_sticks(run, testing::sticks_at_half);
  for (std::size_t b = 3; b < 5; ++b) {  // not yet reached
    const Pose<2>&start = run.histories[b].front().pose, &now = run.simulation.bodies()[b].pose;
    EXPECT_LE((now.position - start.position).norm(), 1e-14) << "stick_" << b;
    EXPECT_LE(std::abs(now.angle - start.angle), 1e-14) << "stick_" << b;
  }
  ASSERT_TRUE(run.run(1).finished()) << run.reason();
  expect_sticks(run, testing::sticks_at_one);
  ASSERT_TRUE(run.run().finished()) << run.reason();
  EXPECT_EQ(run.simulation.fluid().overlap().report().orphans, 0);
}

TEST(ShockRigidSticks, RunsWithMasslessSticks) {
  testing::Overrides massless = {"grid.factor=4"};
  for (int b = 0; b < 5; ++b) massless.push_back("bodies." + std::to_string(b) + ".density=0");
  CaseRun<2> run("shock_rigid_sticks", massless);
  EXPECT_TRUE(run.run().finished()) << run.reason();
}

}  // namespace
}  // namespace mortise
