// The weak shock on three grids, up to h = 0.00625: 80 cells on the radius.
#include "verification/weak_shock_checks.hpp"

namespace mortise {
namespace {

using testing::run_weak_shock;
using testing::WeakShockRun;

TEST(WeakShockOnFreeCylinderLong, ConvergesToLinearAcoustics) {
  for (const double ratio : {0.0, 1.0, 10.0}) {
    const WeakShockRun coarse = run_weak_shock(4, ratio), middle = run_weak_shock(8, ratio),
                       fine = run_weak_shock(16, ratio);
    for (std::size_t k = 0; k < fine.exact.size(); ++k)
      EXPECT_NEAR(fine.computed[k] / fine.exact[k], 1, 0.002)
          << "density ratio " << ratio << ", ct/a = " << testing::weak_shock_times[k];
    EXPECT_LT(middle.worst, coarse.worst);
    EXPECT_LT(fine.worst, middle.worst);
    const double order = testing::order(coarse.worst, fine.worst) / 2;
    EXPECT_GE(order, ratio > 0 ? 0.9 : 0.4)
        << "density ratio " << ratio;  // without mass, V jumps like √t at first touch
  }
}

}  // namespace
}  // namespace mortise
