// Theory of the coupling schemes' stability, seen in the schemes themselves: first-order upwind acoustics on both
// sides.

#include <gtest/gtest.h>

#include "unit/coupler/acoustic_pair.hpp"

namespace mortise {
namespace {

using testing::AcousticPair;
using testing::even_line;
using testing::grows;
using testing::threshold;

TEST(SchemeStability, ProjectionDecaysForAnyRatioOfImpedances) {
  for (const int order : {1, 2})
    for (const double cfl : {0.9, 1.0})
      for (const char* scheme : {"projection", "traditional-subiterated"})
        for (double ratio = 1e-6; ratio < 2e6; ratio *= scheme == std::string("projection") ? 10 : 100) {
          AcousticPair pair(even_line(ratio, cfl, order, scheme, false, true));
          const double start = pair.energy();
          for (int n = 0; n < 300; ++n) pair.step();
          EXPECT_LT(pair.energy(), start * (1 + 1e-10)) << scheme << " " << order << " " << cfl << " " << ratio;
          AcousticPair open(even_line(ratio, cfl, order, scheme, false, false));
          for (int n = 0; n < 300; ++n) open.step();
          EXPECT_LT(open.energy(), 1e-12 * start) << scheme << " " << order << " " << cfl << " " << ratio;
        }
}

TEST(SchemeStability, LaggedTraditionalGrowsByTheRatioOfImpedancesPerStep) {
  for (const double ratio : {0.2, 0.5, 0.8}) {
    AcousticPair pair(even_line(ratio, 0.9, 1, "traditional", true, false));
    AcousticPair mirror(even_line(1 / ratio, 0.9, 1, "anti-traditional", true, false));
    for (int n = 0; n < 150; ++n) pair.step(), mirror.step();
    const double v = pair.velocity(), p = mirror.pressure();
    pair.step(), mirror.step();
    EXPECT_NEAR(pair.velocity() / v, -1 / ratio, 1e-8);
    EXPECT_NEAR(mirror.pressure() / p, -1 / ratio, 1e-8);
  }
}

TEST(SchemeStability, ExtrapolatedTraditionalGrowsByTheLargerRootPerStep) {
  // ζ² + b (2ζ − 1) = 0: ζ = −b − √(b² + b).
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const double b = 1 / ratio;
    AcousticPair pair(even_line(ratio, 0.9, 1, "traditional", false, false));
    AcousticPair mirror(even_line(b, 0.9, 1, "anti-traditional", false, false));
    for (int n = 0; n < 150; ++n) pair.step(), mirror.step();
    const double v = pair.velocity(), p = mirror.pressure();
    pair.step(), mirror.step();
    EXPECT_NEAR(pair.velocity() / v, -b - std::sqrt(b * b + b), 1e-8);
    EXPECT_NEAR(mirror.pressure() / p, -b - std::sqrt(b * b + b), 1e-8);
  }
}

TEST(SchemeStability, ThresholdsAreThoseOfTheory) {
  for (const int order : {1, 2}) {
    EXPECT_NEAR(threshold(0.9, order, "traditional", true), 1, 0.05);
    EXPECT_NEAR(threshold(0.9, order, "traditional", false), 3, 0.15);
    EXPECT_NEAR(threshold(0.9, order, "anti-traditional", true), 1, 0.05);
    EXPECT_NEAR(threshold(0.9, order, "anti-traditional", false), 1.0 / 3, 0.05 / 3);
  }
  EXPECT_TRUE(grows(0.9, 0.9, 1, "traditional", true));
  EXPECT_FALSE(grows(1.1, 0.9, 1, "traditional", true));
}

}  // namespace
}  // namespace mortise
