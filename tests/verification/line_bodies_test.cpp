// Bodies on a line that fall, collide and are squeezed.
#include <gtest/gtest.h>

#include "mortise/cases/driver/totals.hpp"
#include "verification/piston_overrides.hpp"

namespace mortise {
namespace {

using namespace testing;

const std::string two_slabs = MORTISE_TEST_DATA "/two_slabs.toml";

TEST(LineBodies, HeavySlabFallsInNearVacuum) {
  const double g = 0.8;
  CaseRun<1> run("rigid_piston", {"bodies.0.shape=slab", "bodies.0.width=0.2", "bodies.0.mass=1", "exact=none",
                                  "initial.kind=uniform", "initial.state=[1e-8,0,1e-8]", "gravity=[-0.8]"});
  run.run();
  ASSERT_TRUE(run.finished()) << run.reason();
  for (const BodySample<1>& now : run.histories[0]) {
    EXPECT_NEAR(now.pose.position[0], -0.5 * g * now.time * now.time, 1e-7) << now.time;
    EXPECT_NEAR(now.velocity[0], -g * now.time, 1e-7) << now.time;
  }
}

struct Momentum {
  double momentum, energy;
};
/// Of both bodies and the gas (its energy does not count here).
Momentum total(const CaseRun<1>& run) {
  Momentum sum{mortise::totals(run.simulation)[1], 0};
  for (const RigidBody<1>& body : run.simulation.bodies()) {
    sum.momentum += body.mass * body.y[0];
    sum.energy += body.kinetic_energy();
  }
  return sum;
}

TEST(LineBodies, CollisionKeepsMomentumAndObeysTheRestitution) {
  for (const double restitution : {1.0, 0.5, 0.0}) {
    CaseRun<1> run(two_slabs, {set("contact.restitution", restitution)});
    const Momentum before = total(run);
    run.run();
    ASSERT_TRUE(run.finished()) << run.reason();
    EXPECT_GE(run.simulation.contacts(), 1);
    const Momentum after = total(run);
    EXPECT_NEAR(after.momentum, before.momentum, 1e-4) << restitution;
    const double relative = run.simulation.bodies()[1].y[0] - run.simulation.bodies()[0].y[0];
    EXPECT_NEAR(relative, restitution * 1.5, 0.01) << restitution;
  }
}

/// What is between bodies that pass through each other cannot be computed: the run ends, with a reason, or gas piles up
/// and turns them round.
TEST(LineBodies, WithoutContactBodiesThatMeetEndTheRunWithAReason) {
  CaseRun<1> run(two_slabs, {"contact.enabled=false"});
  run.run();
  const double gap = run.simulation.bodies()[1].pose.position[0] - run.simulation.bodies()[0].pose.position[0] - 0.4;
  EXPECT_GT(gap, 0);
  if (!run.finished()) {
    EXPECT_NE(run.reason().find("failed at t = "), std::string::npos) << run.reason();
  }
}

/// A Mach-3 shock pushes two massless slabs towards each other and a wall.
TEST(LineBodies, MasslessSlabsAreSqueezedTogether) {
  for (const double width : {0.1, 0.4}) {
    const Overrides squeezed = {"initial.kind=shock",
                                "initial.ahead=[1,0,1]",
                                "initial.mach=3",
                                "initial.position=-1",
                                "boundaries.left=inflow",
                                "boundaries.right=wall",
                                "bodies.0.velocity=[0]",
                                "bodies.1.velocity=[0]",
                                "bodies.0.mass=0",
                                "bodies.1.mass=0",
                                set("bodies.0.width", width),
                                set("bodies.1.width", width),
                                "bodies.0.position=0",
                                set("bodies.1.position", width + 0.5),
                                "time.end=2"};
    CaseRun<1> run(two_slabs, squeezed);
    run.run();
    EXPECT_TRUE(run.finished()) << run.reason();
    const double gap =
        run.simulation.bodies()[1].pose.position[0] - run.simulation.bodies()[0].pose.position[0] - width;
    EXPECT_GT(gap, 0);
  }
}

}  // namespace
}  // namespace mortise
