// A shock that stands oblique to the grid: it stays where it is, and away from it the flow is uniform.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

TEST(ObliqueShock, IsFirstOrderInTheMean) {
  std::vector<std::map<std::string, ErrorNorms>> errors;
  for (const double factor : {4.0, 8.0, 16.0}) {
    CaseRun<2> run("oblique_shock", {set("grid.factor", factor)});
    ASSERT_TRUE(run.run().finished()) << run.reason();
    errors.push_back(run.errors());
    EXPECT_LE(factor * errors.back().at("fluid.pressure").l1, 0.085);  // 1.2 cells of the jump, 2.5, over the area
  }
  for (std::size_t level = 1; level < errors.size(); ++level)
    for (const auto& [name, norms] : errors[level]) {
      EXPECT_NEAR(testing::order(errors[level - 1].at(name).l1, norms.l1), 1, 0.05) << name << ", level " << level;
      EXPECT_NEAR(testing::order(errors[level - 1].at(name).l2, norms.l2), 0.5, 0.06) << name << ", level " << level;
    }
}

TEST(ObliqueShock, DoesNotMove) {
  CaseRun<2> run("oblique_shock", {"time.end=3"});
  ASSERT_TRUE(run.run(2).finished()) << run.reason();  // what the shock shed while it took its shape has left by then
  const double before = run.errors().at("fluid.density").l1;
  ASSERT_TRUE(run.run(3).finished()) << run.reason();
  EXPECT_NEAR(run.errors().at("fluid.density").l1, before, 0.01 * before);
}

TEST(ObliqueShock, LeavesTheFlowUniform) {
  CaseRun<2> run("oblique_shock", {"time.end=3"});
  ASSERT_TRUE(run.run().finished()) << run.reason();
  const double angle = run.description.initial.angle * std::acos(-1) / 180, h = run.description.spacing();
  double ahead = 0, behind = 0;
  for (const testing::ActiveCell<2>& cell : run.cells()) {
    const double distance =
        cell.x[0] * std::cos(angle) + cell.x[1] * std::sin(angle) - run.description.initial.position;
    const Primitive<2> exact = run.scene.exact->state(cell.x, run.simulation.time());
    const double error = std::abs(cell.W.pressure - exact.pressure) / exact.pressure;
    if (distance > 10 * h) ahead = std::max(ahead, error);
    if (distance < -10 * h) behind = std::max(behind, error);
  }
  EXPECT_LE(ahead, 1e-10);  // supersonic: nothing travels upstream
  EXPECT_LE(behind, 0.02);  // noise of a captured shock, and of where it enters the domain
}

}  // namespace
}  // namespace mortise
