// Where the traditional coupling of an elastic solid becomes unstable: with the lagged velocity of the wall where
// z_s < z_f, extrapolated to second order where z_s < 3 z_f. The projection has no such threshold.
#include "verification/elastic_noise.hpp"

namespace mortise {
namespace {

using namespace testing;

constexpr double amplitude = 1e-9;

/// Speed of the wall after `steps` steps over that of the noise; growth per step is the ratio of the impedances.
double growth(double impedances, const Overrides& scheme, int steps) {
  NoisyTube tube(impedances, amplitude, scheme + Overrides{"coupling.substeps=false"});
  for (int i = 0; i < steps; ++i) tube.step();
  return tube.wall_speed() / amplitude;
}

double threshold(const Overrides& scheme, double low, double high) {
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    (growth(middle, scheme, 250) > 10 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

TEST(InterfaceThresholds, LaggedWallVelocity) {
  EXPECT_NEAR(threshold({"scheme=traditional", "coupling.wall_velocity=lagged"}, 0.5, 2), 1, 0.05);
}

TEST(InterfaceThresholds, ExtrapolatedWallVelocity) { EXPECT_NEAR(threshold({"scheme=traditional"}, 1.5, 6), 3, 0.15); }

TEST(InterfaceThresholds, ProjectionHasNone) {
  for (const double impedances : {1e-6, 1e-3, 0.3, 1.0, 3.0, 1e3, 1e6})
    EXPECT_LE(growth(impedances, {}, 250), 2) << impedances;
}

}  // namespace
}  // namespace mortise
