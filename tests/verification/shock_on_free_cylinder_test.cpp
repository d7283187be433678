// A Mach-2 shock sets a cylinder of density 1 in motion, h = 0.0125, against an independent computation on an equal
// grid.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

struct PlaceAt {
  double time, x;
};
const PlaceAt independent[] = {{0.4, 0.0490}, {0.6, 0.2329}, {1.0, 0.7511}};

TEST(ShockOnFreeCylinder, FollowsTheIndependentComputation) {
  for (const double factor : {4.0, 8.0}) {
    CaseRun<2> run("shock_on_free_cylinder", {set("grid.factor", factor)});
    for (const PlaceAt& expected : independent) {
      ASSERT_TRUE(run.run(expected.time).finished()) << run.reason();
      EXPECT_NEAR(run.simulation.bodies()[0].pose.position[0], expected.x, 0.001) << "t = " << expected.time;
    }
  }
}

TEST(ShockOnFreeCylinder, GoesStraightOnAndDoesNotTurn) {
  CaseRun<2> run("shock_on_free_cylinder", {"grid.factor=4"});
  ASSERT_TRUE(run.run().finished()) << run.reason();
  EXPECT_LE(std::abs(run.simulation.bodies()[0].pose.position[1]), 1e-10);
  EXPECT_LE(std::abs(run.simulation.bodies()[0].pose.angle), 1e-12);
}

// Lighter bodies are faster, and the limit of no mass is approached without a jump.
TEST(ShockOnFreeCylinder, DependsContinuouslyOnItsMass) {
  std::vector<double> x;
  for (const double density : {0.0, 1e-12, 1e-3, 0.1, 1.0, 10.0}) {
    CaseRun<2> run("shock_on_free_cylinder", {"grid.factor=4", set("bodies.0.density", density)});
    ASSERT_TRUE(run.run().finished()) << run.reason();
    x.push_back(run.simulation.bodies()[0].pose.position[0]);
  }
  EXPECT_NEAR(x[1], x[0], 1e-8);
  EXPECT_NEAR(x[2], x[0], 2e-3);
  for (std::size_t k = 2; k < x.size(); ++k) EXPECT_LT(x[k], x[k - 1]);
}

}  // namespace
}  // namespace mortise
