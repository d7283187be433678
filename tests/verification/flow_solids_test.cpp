// Solids in an incompressible flow by their reference maps, from the case files.
#include <gtest/gtest.h>

#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/scene/flow_scene.hpp"
#include "mortise/coupler/reference_map/flow_grid.hpp"

namespace mortise::testing {
namespace {

/// A case with an incompressible fluid, one rank.
class FlowCase {
 public:
  explicit FlowCase(const std::string& name, const std::vector<std::string>& overrides = {})
      : description(read_case(name, overrides, MORTISE_SOURCE_DIR "/cases")),
        scene(build_flow_scene(description)),
        grid(make_flow_grid(scene.flow, Communicator())),
        solids(scene.solids, grid),
        flow(scene.flow, Communicator(), &solids) {
    solids.follow(flow.velocity());
    flow.initialize();
  }
  void run(double time) {
    while (flow.time() < time) flow.advance(time - flow.time());
  }
  Point<2> velocity(int t, std::size_t k) const { return {flow.velocity().tile(t).component(0)[k], flow.velocity().tile(t).component(1)[k]}; }
  /// ∫ρ x × v over solids and fluid, about the origin.
  double angular_momentum() const {
    double sum = 0;
    for (int t = 0; t < grid.forest.local_count(); ++t)
      for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid.first_cell(t);
        const Point<2> x = grid.center({first[0] + c[0], first[1] + c[1]}), v = velocity(t, grid.shape.at(c));
        sum += flow.density()->tile(t).component(0)[grid.shape.at(c)] * (x.x() * v.y() - x.y() * v.x()) * grid.spacing.prod();
      });
    return sum;
  }
  SolidTotals solid(std::size_t b = 0) const { return totals(mapped_solids(solids, flow)[b]); }

  CaseDescription description;
  FlowScene scene;
  ComponentGrid<2> grid;
  FlowSolids solids;
  IncompressibleSolver flow;
};

TEST(FlowSolids, SpinningDiskKeepsAngularMomentum) {
  FlowCase disk("spinning_disk");
  const double before = disk.angular_momentum(), volume = disk.solid().mass;
  disk.run(0.3);
  EXPECT_NEAR(disk.angular_momentum(), before, 0.01 * before);
  EXPECT_NEAR(disk.solid().mass, volume, 1e-3 * volume);
  EXPECT_EQ(disk.solids.orphans(), 0);
}

/// Without viscosity nothing brakes what is inside: the centre of the disk keeps its spin.
TEST(FlowSolids, RigidRotationIsNotBraked) {
  FlowCase disk("spinning_disk", {"fluid.viscosity=0", "time.end=0.3"});
  disk.run(0.3);
  const std::optional<MappedPoint> point = material_point(mapped_solids(disk.solids, disk.flow)[0], {0.2, 0});
  ASSERT_TRUE(point);
  EXPECT_NEAR(std::atan2(point->x.y(), point->x.x()), 0.6, 0.012);
  EXPECT_NEAR(point->x.norm(), 0.2, 0.002);
}

/// Velocity on a grid against one twice as fine, at the corners of coarse cells (four-point means), L2 over the torus.
double difference(const FlowCase& coarse, const FlowCase& fine) {
  const int n = coarse.grid.cells[0];
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point<2> x = coarse.grid.center({i, j});
      sum += (coarse.flow.sample(x)->velocity - fine.flow.sample(x)->velocity).squaredNorm() * coarse.grid.spacing.prod();
    }
  return std::sqrt(sum);
}

TEST(FlowSolids, ConvergesFasterThanFirstOrder) {
  FlowCase one("rm_convergence", {"grid.factor=3.2"}), two("rm_convergence", {"grid.factor=6.4"}), three("rm_convergence", {"grid.factor=12.8"});
  for (FlowCase* run : {&one, &two, &three}) run->run(0.5);
  const double coarse = difference(one, two), fine = difference(two, three);
  EXPECT_LT(fine, 0.025);
  EXPECT_GT(std::log2(coarse / fine), 1.3);
}

TEST(FlowSolids, RotorFollowsItsHubAndOvershoots) {
  FlowCase rotor("rotor", {"grid.factor=3.2", "time.end=3.3"});
  double largest = 0, turned = 0, last = 0;
  while (rotor.flow.time() < 3.3) {
    rotor.flow.advance(3.3 - rotor.flow.time());
    const Point<2> x = material_point(mapped_solids(rotor.solids, rotor.flow)[0], {0.72, 0})->x;
    const double angle = std::atan2(x.y(), x.x());
    turned += std::remainder(angle - last, 2 * M_PI);
    last = angle;
    largest = std::max(largest, turned);
  }
  EXPECT_NEAR(largest, 6.46, 0.06);
  EXPECT_NEAR(rotor.solid().mass / 3, 0.956, 0.01);
}

TEST(FlowSolids, SwellingMaterialTakesItsStretch) {
  FlowCase disk("spinning_disk", {"solids.0.angular_velocity=0", "solids.0.actuation=1.1", "fluid.viscosity=0.5", "time.end=1"});
  disk.run(1);
  const auto at = [&](double x, double y) { return material_point(mapped_solids(disk.solids, disk.flow)[0], {x, y})->x; };
  EXPECT_NEAR(at(0.3, 0).x(), 0.33, 0.01);
  EXPECT_NEAR(at(0, 0.3).y(), 0.3 / 1.1, 0.01);
}

}  // namespace
}  // namespace mortise::testing
