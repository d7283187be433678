// A shock hits the face of an elastic solid: until waves come back, interface velocity and pressure are those of the
// nonlinear fluid-structure Riemann problem.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

struct Hit {
  double mach, scale;
};

class ElasticPistonShock : public ::testing::TestWithParam<Hit> {};

TEST_P(ElasticPistonShock, PlateauIsTheRiemannSolution) {
  const auto [mach, scale] = GetParam();
  CaseRun<2> run("elastic_piston_shock", {"grid.factor=8", set("initial.mach", mach), set("solid.scale", scale)});
  EXPECT_TRUE(run.run().finished()) << run.reason();
  const InterfaceState state = run.simulation.interfaces().at(0);
  const ExactInterface exact = run.scene.exact->interface_at(Point<2>::Zero(), state.half_time).value();
  EXPECT_LT(exact.velocity.x(), 0.0);
  for (const Point<2>& velocity : state.node_velocities)
    EXPECT_NEAR(velocity.x(), exact.velocity.x(), 0.01 * std::abs(exact.velocity.x()));
  for (const double pressure : state.pressure) EXPECT_NEAR(pressure, exact.pressure, 0.01 * exact.pressure);
}

INSTANTIATE_TEST_SUITE_P(Case, ElasticPistonShock, ::testing::Values(Hit{2, 0.01}, Hit{2, 1}, Hit{2, 10}, Hit{10, 1}));

}  // namespace
}  // namespace mortise
