// The stability of a piston coupled to the gas without added mass: a perturbation is amplified by ζ = 1 − z Δt/m a
// step, so it is unstable where m < z Δt/2, z the sum of ρc over the sides with gas. With added mass it is stable for
// every m.
#include <gtest/gtest.h>

#include "unit/fluid/gas_options.hpp"
#include "verification/piston_overrides.hpp"

namespace mortise {
namespace {

using namespace testing;

/// A piston between gases at rest whose velocity is disturbed a little.
struct Disturbed {
  std::string scheme;
  Overrides gases;
  double time_step;

  CaseRun<1> start(double mass, double velocity) const {
    return CaseRun<1>("rigid_piston",
                      gases + Overrides{"grid.factor=4", "exact=none", "time.end=0.5", "scheme=" + scheme,
                                        set("time.step", time_step), set("bodies.0.mass", mass),
                                        "bodies.0.velocity=[" + std::to_string(velocity) + "]"});
  }
  /// Largest speed in the last of `steps` steps, over that at the start.
  double growth(double mass, int steps) const {
    CaseRun<1> run = start(mass, 1e-4);
    for (int i = 0; i < steps; ++i) run.step(1e9);
    return std::abs(run.histories[0].back().velocity[0]) / 1e-4;
  }
  double threshold(double low, double high) const {
    while (high > 1.001 * low) {
      const double m = std::sqrt(low * high);
      (growth(m, 40) > 1 ? low : high) = m;
    }
    return std::sqrt(low * high);
  }
};

const Overrides half_space = {"initial.right=[1.4,0,1]", "bodies.0.force.x=1"};
const Overrides slab = {"bodies.0.shape=slab", "bodies.0.width=0.2", "initial.left=[0.4,0,1]", "initial.right=[1,0,1]"};

double impedance(double density, double pressure) { return std::sqrt(gamma_air * density * pressure); }

TEST(TraditionalPiston, IsUnstableExactlyBelowHalfTheAddedMassOfAStep) {
  for (const double dt : {0.005, 0.01}) {
    const double one_side = 0.5 * impedance(1.4, 1) * dt;
    EXPECT_NEAR(Disturbed({"traditional", half_space, dt}).threshold(0.3 * one_side, 3 * one_side), one_side,
                0.02 * one_side)
        << "step " << dt;
    const double both_sides = 0.5 * (impedance(0.4, 1) + impedance(1, 1)) * dt;
    EXPECT_NEAR(Disturbed({"traditional", slab, dt}).threshold(0.3 * both_sides, 3 * both_sides), both_sides,
                0.02 * both_sides)
        << "step " << dt;
  }
}

TEST(TraditionalPiston, AddedMassDampsTheDisturbanceOnBothSidesOfTheThreshold) {
  const double dt = 0.01, threshold = 0.5 * (impedance(0.4, 1) + impedance(1, 1)) * dt;
  for (const double ratio : {0.0, 1e-8, 0.01, 0.25, 0.9, 1.1, 4.0})
    EXPECT_LE(Disturbed({"rigid", slab, dt}).growth(ratio * threshold, 40), 1e-3) << "m / threshold " << ratio;
}

/// Steps are halved where the state is not admissible, so a run just below the threshold may go on, but not quietly.
TEST(TraditionalPiston, UnstableRunGrowsAndEndsWithAReason) {
  const double dt = 0.01, threshold = 0.5 * (impedance(0.4, 1) + impedance(1, 1)) * dt;
  EXPECT_GE(Disturbed({"traditional", slab, dt}).growth(0.5 * threshold, 12), 1e3);
  CaseRun<1> run = Disturbed{"traditional", slab, dt}.start(0.01 * threshold, 1e-4);
  run.run();
  EXPECT_FALSE(run.finished());
  EXPECT_LT(run.simulation.time(), 0.1);
  EXPECT_NE(run.reason().find("the computation failed at t = "), std::string::npos) << run.reason();
}

TEST(TraditionalPiston, IsRefusedWithoutMass) {
  EXPECT_THROW(
      CaseRun<1>("rigid_piston", slab + Overrides{"exact=none", "scheme=traditional", "bodies.0.mass=0"}).run(),
      InputError);
}

}  // namespace
}  // namespace mortise
