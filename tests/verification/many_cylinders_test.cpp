// Eleven cylinders, two grids: they meet, none overlaps another, and contacts neither make nor take momentum.
#include <gtest/gtest.h>

#include "mortise/coupler/gaps.hpp"
#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using testing::CaseRun;
using testing::set;

double least_gap(const CaseRun<2>& run) {
  std::vector<GapBody<2>> shapes;
  for (std::size_t b = 0; b < run.simulation.bodies().size(); ++b)
    shapes.push_back({run.scene.setup.fluid.bodies[b].shape.atlas.get(), run.scene.setup.bodies[b].outline.get(),
                      run.simulation.bodies()[b].pose});
  double least = 1e300;
  for (const ContactPoint<2>& gap : find_gaps<2>(shapes, run.scene.setup.fluid.domain, {false, false}, 0.1))
    least = std::min(least, gap.gap);
  return least;
}

Point<2> momentum(const CaseRun<2>& run) {
  Point<2> sum = Point<2>::Zero();
  for (const RigidBody<2>& body : run.simulation.bodies()) sum += body.mass * body.y.head<2>();
  return sum;
}

/// ∫ Σ F dt of the gas on the bodies.
Point<2> impulse(const CaseRun<2>& run) {
  Point<2> sum = Point<2>::Zero();
  for (const auto& history : run.histories)
    for (std::size_t k = 1; k < history.size(); ++k)
      sum += (history[k].time - history[k - 1].time) * history[k].load.force;
  return sum;
}

TEST(ManyCylinders, MeetWithoutOverlap) {
  for (const double factor : {4.0, 8.0}) {
    CaseRun<2> run("many_cylinders", {set("grid.factor", factor)});
    double least = 1e300;
    while (run.simulation.time() < run.description.time_end) {
      run.step(run.description.time_end);
      least = std::min(least, least_gap(run));
    }
    EXPECT_GT(run.simulation.contacts(), 0);
    EXPECT_GE(least, 0.99 * run.scene.setup.contact_gap) << "grid.factor " << factor;
    EXPECT_EQ(run.simulation.fluid().overlap().report().orphans, 0);
    EXPECT_LE((momentum(run) - impulse(run)).norm(), 1e-12);  // contacts act on pairs of bodies
    double mass = 0;
    for (const RigidBody<2>& body : run.simulation.bodies()) mass += body.mass;
    EXPECT_NEAR(momentum(run)[0] / mass, 0.70, 0.02);  // about the velocity of the gas behind the shock, 0.694
  }
}

// Placed in mirror symmetry about the x axis: in pairs, and three on the axis.
TEST(ManyCylinders, StayInMirrorSymmetryThroughAContact) {
  CaseRun<2> run("many_cylinders");
  ASSERT_TRUE(run.run().finished()) << run.reason();
  EXPECT_GT(run.simulation.contacts(), 0);
  const std::pair<std::size_t, std::size_t> images[] = {{0, 0}, {1, 2}, {3, 4}, {5, 5}, {6, 7}, {8, 9}, {10, 10}};
  for (const auto& [upper, lower] : images) {
    const Point<2>&a = run.simulation.bodies()[upper].pose.position, &b = run.simulation.bodies()[lower].pose.position;
    EXPECT_LE((a - Point<2>(b[0], -b[1])).norm(), 1e-10) << "circle_" << upper << ", circle_" << lower;
  }
}

}  // namespace
}  // namespace mortise
