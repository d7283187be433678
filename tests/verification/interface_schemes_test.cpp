// Long runs of the interface schemes with second-order acoustics on both sides.

#include <gtest/gtest.h>

#include "unit/coupler/acoustic_pair.hpp"

namespace mortise {
namespace {

TEST(InterfaceSchemesLongRun, ProjectionDecaysOverAHundredThousandSteps) {
  for (const double cfl : {0.9, 1.0})
    for (const double ratio : {1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6}) {
      testing::AcousticPair pair(testing::even_line(ratio, cfl, 2, "projection", false, true, 10));
      double last = pair.energy();
      for (int n = 0; n < 10; ++n) {
        for (int k = 0; k < 10000; ++k) pair.step();
        const double now = pair.energy();
        EXPECT_LT(now, last * (1 + 1e-9)) << cfl << " " << ratio;
        last = now;
      }
    }
}

}  // namespace
}  // namespace mortise
