// p = (γ − 1) ρ e − γ p∞ with p∞ > 0, as for water.
#include <gtest/gtest.h>

#include "verification/piston_overrides.hpp"

namespace mortise {
namespace {

using namespace testing;

const Overrides water = {"gas.gamma=4.4", "gas.p_inf=600"};

TEST(StiffenedGas, RiemannProblemConverges) {
  const Overrides tube = water + Overrides{"initial.left=[1,0,1000]", "initial.right=[0.9,0,1]", "time.end=0.0035"};
  for (const std::string solver : {"hllc", "exact", "hlle"}) {
    const auto errors = [&](double f) {
      CaseRun<1> run("sod", tube + Overrides{"fluid.riemann=" + solver} + factor(f));
      run.run();
      EXPECT_TRUE(run.finished()) << run.reason();
      return run.errors();
    };
    auto coarse = errors(10), fine = errors(80);
    EXPECT_LE(fine["fluid.density"].l1, 5e-4) << solver;
    EXPECT_GE(order(coarse["fluid.density"].l1, fine["fluid.density"].l1) / 3, 0.75) << solver;
    EXPECT_GE(order(coarse["fluid.pressure"].l1, fine["fluid.pressure"].l1) / 3, 0.9) << solver;
  }
}

/// The pressure of a stiffened gas may be negative.
TEST(StiffenedGas, MasslessPistonStaysAtRest) {
  for (const double pressure : {1.0, 0.0, -100.0}) {
    CaseRun<1> run("rigid_piston",
                   water + Overrides{"bodies.0.shape=slab", "bodies.0.width=0.2", "bodies.0.mass=0", "exact=uniform",
                                     "initial.kind=uniform", "initial.state=[1,0," + std::to_string(pressure) + "]",
                                     "time.end=0.02"});
    run.run();
    const double c = std::sqrt(4.4 * (pressure + 600));
    ASSERT_TRUE(run.finished()) << run.reason();
    EXPECT_GT(run.simulation.steps(), 100);
    EXPECT_LE(std::abs(run.simulation.bodies()[0].y[0]), 1e-14 * c) << pressure;
    EXPECT_LE(run.errors()["fluid.velocity_x"].max, 1e-13 * c) << pressure;
    EXPECT_LE(run.errors()["fluid.pressure"].max, 1e-13 * 600 * 4.4) << pressure;
  }
}

/// Against the simple waves of a stiffened gas.
TEST(StiffenedGas, PushedSlabIsSecondOrder) {
  const auto run = [](double f) {
    CaseRun<1> slab("rigid_piston",
                    pushed_slab(0.5) + water +
                        Overrides{"bodies.0.force.x=t < 0.02 ? 500*sin(pi*t/0.02)^4 : 0", "time.end=0.015"} +
                        factor(f));
    slab.run();
    EXPECT_TRUE(slab.finished()) << slab.reason();
    return std::pair(slab.worst_velocity(), slab.errors()["fluid.pressure"].l1);
  };
  const auto [coarse_velocity, coarse_pressure] = run(16);
  const auto [fine_velocity, fine_pressure] = run(32);
  EXPECT_LE(fine_velocity, 1e-5);
  EXPECT_GE(order(coarse_velocity, fine_velocity), 1.9);
  EXPECT_GE(order(coarse_pressure, fine_pressure), 1.9);
}

}  // namespace
}  // namespace mortise
