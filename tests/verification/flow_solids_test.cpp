// Solids in an incompressible flow by their reference maps, from the case files.
#include "verification/flow_case.hpp"

namespace mortise::testing {
namespace {

TEST(FlowSolids, SpinningDiskKeepsAngularMomentum) {
  FlowCase disk("spinning_disk");
  const double before = disk.angular_momentum(), volume = disk.solid().mass;
  disk.run(0.3);
  EXPECT_NEAR(disk.angular_momentum(), before, 0.01 * before);
  EXPECT_NEAR(disk.solid().mass, volume, 1e-3 * volume);
  EXPECT_EQ(disk.solids.orphans(), 0);
}

TEST(FlowSolids, CoarseRotorFollowsItsHubAndOvershoots) {
  FlowCase rotor("rotor", {"grid.factor=3.2", "time.end=3.3"});
  const double largest = largest_angle(rotor, 3.3);
  EXPECT_NEAR(largest, 6.46, 0.03);  // published: 6.4636, on 128² cells
  EXPECT_NEAR(rotor.solid().mass / 3, 0.956, 0.01);
}

TEST(FlowSolids, SwellingMaterialTakesItsStretch) {
  FlowCase disk("spinning_disk",
                {"solids.0.angular_velocity=0", "solids.0.actuation=1.1", "fluid.viscosity=0.2", "time.end=2"});
  disk.run(2);
  const auto at = [&](double x, double y) {
    return material_point(mapped_solids(disk.solids, disk.flow)[0], {x, y})->x;
  };
  EXPECT_NEAR(at(0.3, 0).x(), 0.33, 0.01);
  EXPECT_NEAR(at(0, 0.3).y(), 0.3 / 1.1, 0.01);
}

}  // namespace
}  // namespace mortise::testing
