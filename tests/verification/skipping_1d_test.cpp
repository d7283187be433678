// Leaving out tiles in which nothing happens changes nothing, to the bit.
#include <gtest/gtest.h>

#include "verification/piston_overrides.hpp"

namespace mortise {
namespace {

using namespace testing;

void expect_same_bits(const std::string& name, const Overrides& overrides) {
  const Overrides small_tiles = {"grid.tile=[20]"};
  CaseRun<1> with(name, overrides + small_tiles), without(name, overrides + small_tiles, false);
  with.run();
  without.run();
  ASSERT_TRUE(with.finished() && without.finished());
  EXPECT_GT(with.simulation.cells_skipped(), with.simulation.cell_updates() / 20) << name;
  ASSERT_EQ(with.simulation.steps(), without.simulation.steps()) << name;
  for (std::size_t b = 0; b < with.simulation.bodies().size(); ++b) {
    EXPECT_EQ(with.simulation.bodies()[b].pose.position[0], without.simulation.bodies()[b].pose.position[0]);
    EXPECT_EQ(with.simulation.bodies()[b].y[0], without.simulation.bodies()[b].y[0]);
  }
  const auto here = with.cells(), there = without.cells();
  ASSERT_EQ(here.size(), there.size());
  int different = 0;
  for (std::size_t i = 0; i < here.size(); ++i)
    different += here[i].x[0] != there[i].x[0] || here[i].W.density != there[i].W.density ||
                 here[i].W.velocity[0] != there[i].W.velocity[0] || here[i].W.pressure != there[i].W.pressure;
  EXPECT_EQ(different, 0) << name;
}

TEST(Skipping, LeavesTheBitsOfLineCasesAlone) {
  expect_same_bits("sod", {});
  expect_same_bits("riemann_collision", {});
  expect_same_bits("rigid_piston", {});
  expect_same_bits("rigid_piston", pushed_slab(0));
  expect_same_bits("shock_on_massless_body", {});
}

}  // namespace
}  // namespace mortise
