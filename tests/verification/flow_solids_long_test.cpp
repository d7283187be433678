// Solids in an incompressible flow on the grids of the published runs.
#include "verification/flow_case.hpp"

namespace mortise::testing {
namespace {

/// Velocity on a grid against one twice as fine (means of four of its cells), L2 over the torus.
double difference(const FlowCase& coarse, const FlowCase& fine) {
  const int n = coarse.grid.cells[0];
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point<2> x = coarse.grid.center({i, j});
      sum +=
          (coarse.flow.sample(x)->velocity - fine.flow.sample(x)->velocity).squaredNorm() * coarse.grid.spacing.prod();
    }
  return std::sqrt(sum);
}

TEST(FlowSolids, ConvergesFasterThanFirstOrder) {
  FlowCase one("rm_convergence", {"grid.factor=4.5"}), two("rm_convergence", {"grid.factor=9"}),
      three("rm_convergence", {"grid.factor=18"});
  for (FlowCase* run : {&one, &two, &three}) run->run(0.5);
  const double coarse = difference(one, two), fine = difference(two, three);
  EXPECT_LT(coarse, 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(FlowSolids, RotorTurnsAsFarAsPublished) {
  FlowCase rotor("rotor");
  EXPECT_NEAR(largest_angle(rotor, 3.3), 6.46, 0.02);
}

}  // namespace
}  // namespace mortise::testing
