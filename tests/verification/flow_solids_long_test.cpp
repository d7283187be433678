// Solids in an incompressible flow on the grids of the published runs.
#include "verification/flow_case.hpp"

namespace mortise::testing {
namespace {

/// Velocity at cell centres on a torus, rows of n.
std::vector<Point<2>> velocities(const FlowCase& run) {
  std::vector<Point<2>> all;
  for (int j = 0; j < run.grid.cells[1]; ++j)
    for (int i = 0; i < run.grid.cells[0]; ++i) all.push_back(run.flow.sample(run.grid.center({i, j}))->velocity);
  return all;
}

/// Root mean square of the difference to a grid twice as fine, which is interpolated to fourth order: as published.
double difference(const FlowCase& coarse, const FlowCase& fine) {
  const std::vector<Point<2>> a = velocities(coarse), b = velocities(fine);
  const int n = coarse.grid.cells[0], m = 2 * n;
  const double weights[] = {-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16};
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      Point<2> v(0, 0);
      for (int l = 0; l < 4; ++l)
        for (int k = 0; k < 4; ++k) {
          const int x = (2 * i - 1 + k + m) % m, y = (2 * j - 1 + l + m) % m;
          v += weights[k] * weights[l] * b[static_cast<std::size_t>(y * m + x)];
        }
      sum += (a[static_cast<std::size_t>(j * n + i)] - v).squaredNorm();
    }
  return std::sqrt(sum / (n * n));
}

TEST(FlowSolids, VelocityConvergesAndIsBetterThanPublished) {
  FlowCase one("rm_convergence", {"grid.factor=4.5"}), two("rm_convergence", {"grid.factor=9"}),
      three("rm_convergence", {"grid.factor=18"}), four("rm_convergence", {"grid.factor=36"});
  for (FlowCase* run : {&one, &two, &three, &four}) run->run(0.5);
  const double coarse = difference(one, two), fine = difference(two, three);
  EXPECT_LT(coarse, 6e-3);  // published code: 1.44e-2
  EXPECT_LT(fine, 2.4e-3);
  EXPECT_GT(std::log2(coarse / fine), 1.2);  // published: 1.23
  EXPECT_LT(difference(three, four), 1e-3);
}

TEST(FlowSolids, RotorTurnsAsFarAsPublished) {
  FlowCase rotor("rotor");
  EXPECT_NEAR(largest_angle(rotor, 3.3), 6.46, 0.02);
}

/// How far gravity bends the tail of a flag a hundred times as stiff, in a box of fluid at rest, until it swings back.
double largest_deflection(const std::string& factor) {
  FlowCase flag("flag", {"grid.factor=" + factor, "grid.low=[-0.5, -0.5]", "grid.high=[1.5, 0.5]", "time.end=3.3",
                         "output.oscillation=[1, 3]", "gravity=[0, -0.2]", "fluid.viscosity=0.005",
                         "boundaries={left=\"wall\", right=\"wall\", bottom=\"wall\", top=\"wall\"}",
                         "initial={kind=\"uniform\", state=[1, 0, 0, 1]}", "solids.0.material.mu=400",
                         "solids.0.initial.velocity=[0, 0]", "solids.0.anchors=[{radius=0.1}]"});
  double lowest = 0;
  while (flag.flow.time() < 3.3) {
    flag.flow.advance(3.3 - flag.flow.time());
    lowest = std::min(lowest, material_point(mapped_solids(flag.solids, flag.flow)[0], {1, 0})->x.y());
  }
  return -lowest;
}

// Six cells across are enough for the bending stiffness.
TEST(FlowSolids, FlagBendsOnSixCellsAsOnTwelve) {
  const double coarse = largest_deflection("6.4"), fine = largest_deflection("12.8");
  EXPECT_NEAR(fine, 0.085, 0.002);  // q L⁴/(8 D) = .053 at rest, for L = .94 from the hold on, and an overshoot
  EXPECT_NEAR(coarse, fine, 0.04 * fine);
}

// Snaps fold the flag until it touches itself: nothing tears, nothing sticks.
TEST(FlowSolids, FlagOutlivesItsFolds) {
  FlowCase flag("flag", {"time.end=40", "output.oscillation=[10, 40]"});
  const double mass = flag.solid().mass;
  double squares = 0, time = 0;
  int folded = 0;
  while (flag.flow.time() < 40) {
    const double dt = flag.flow.advance(40 - flag.flow.time());
    folded += flag.solids.maps()[0]->folded();
    if (flag.flow.time() < 10) continue;
    const auto tail = material_point(mapped_solids(flag.solids, flag.flow)[0], {1, 0});
    ASSERT_TRUE(tail.has_value());
    squares += dt * tail->x.y() * tail->x.y();
    time += dt;
    ASSERT_NEAR(flag.solid().mass, mass, 0.05 * mass) << flag.flow.time();
  }
  EXPECT_GT(folded, 0);
  EXPECT_NEAR(std::sqrt(2 * squares / time), 0.28, 0.08);  // of the whole run of 160: .279
}

}  // namespace
}  // namespace mortise::testing
