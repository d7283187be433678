// A weak shock passes a free cylinder: its velocity against linear acoustics, for density ratios 0, 1 and 10.
#include "verification/weak_shock_checks.hpp"

namespace mortise {
namespace {

using testing::run_weak_shock;
using testing::WeakShockRun;

TEST(WeakShockOnFreeCylinder, FollowsLinearAcoustics) {
  for (const double factor : {4.0, 8.0})
    for (const double ratio : {0.0, 1.0, 10.0}) {
      const WeakShockRun run = run_weak_shock(factor, ratio);
      const double bound = factor < 8 ? 0.02 : 0.003;  // the shock is itself nonlinear by 0.1 %
      for (std::size_t k = 0; k < run.exact.size(); ++k)
        EXPECT_NEAR(run.computed[k] / run.exact[k], 1, bound)
            << "density ratio " << ratio << ", ct/a = " << testing::weak_shock_times[k] << ", grid.factor " << factor;
    }
}

TEST(WeakShockOnFreeCylinder, ExactVelocities) {
  EXPECT_NEAR(run_weak_shock(2, 1).exact[1], 0.58710, 5e-6);
  EXPECT_NEAR(run_weak_shock(2, 10).exact[1], 0.079929, 5e-7);
}

}  // namespace
}  // namespace mortise
