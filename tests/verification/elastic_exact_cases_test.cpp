// Elastic cases with exact or radial reference solutions: of second order in the maximum norm, against published
// numbers where there are any.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

/// Interface radius, velocity (outwards) and pressure at the end of the run; the latter two live at half time and are
/// continued from the last two steps.
struct Ring {
  double radius, velocity, pressure;
};

Ring continued(const InterfaceState& before, const InterfaceState& last, double time) {
  const auto mean = [&](const InterfaceState& state) {
    Ring ring{};
    for (std::size_t n = 0; n < state.nodes.size(); ++n) {
      ring.radius += state.nodes[n].norm() / static_cast<double>(state.nodes.size());
      ring.velocity +=
          state.node_velocities[n].dot(state.nodes[n].normalized()) / static_cast<double>(state.nodes.size());
    }
    for (const double pressure : state.pressure) ring.pressure += pressure / static_cast<double>(state.pressure.size());
    return ring;
  };
  const Ring a = mean(before), b = mean(last);
  const double s = (time - last.half_time) / (last.half_time - before.half_time);
  return {b.radius, b.velocity + s * (b.velocity - a.velocity), b.pressure + s * (b.pressure - a.pressure)};
}

Ring shell_at_the_end(double factor) {
  CaseRun<2> run("radial_shell", {set("grid.factor", factor)});
  InterfaceState before, last;
  while (run.simulation.time() < 1) {
    run.step(1);
    before = std::exchange(last, run.simulation.interfaces().at(0));
  }
  return continued(before, last, 1);
}

// Radial reference at t = 1: a = .48975854, v = .00902158, p = .72109885.
TEST(RadialShell, InterfaceConvergesToTheReference) {
  const auto errors = [](double factor) {
    const Ring ring = shell_at_the_end(factor);
    return Ring{std::abs(ring.radius - 0.48975854), std::abs(std::abs(ring.velocity) - 0.00902158),
                std::abs(ring.pressure - 0.72109885)};
  };
  const Ring coarse = errors(4), fine = errors(8);
  EXPECT_GE(order(coarse.radius, fine.radius), 1.9) << fine.radius;
  EXPECT_GE(order(coarse.velocity, fine.velocity), 1.9) << fine.velocity;
  EXPECT_GE(order(coarse.pressure, fine.pressure), 1.9) << fine.pressure;
}

std::map<std::string, ErrorNorms> case_errors(const std::string& name, double factor, const Overrides& more = {}) {
  CaseRun<2> run(name, more + Overrides{set("grid.factor", factor)});
  EXPECT_TRUE(run.run().finished()) << run.reason();
  return run.errors();
}

void expect_case_order(const std::string& name, double coarse, const std::map<std::string, double>& least,
                       const Overrides& more = {}) {
  const auto before = case_errors(name, coarse, more), after = case_errors(name, 2 * coarse, more);
  for (const auto& [field, order_of_field] : least)
    EXPECT_GE(order(before.at(field).max, after.at(field).max), order_of_field)
        << name << " " << field << " " << after.at(field).max;
}

// Mean errors of an independent computation at the same spacing (README of the case).
TEST(SuperseismicShock, MeanErrorsAreBelowTheIndependentOnes) {
  const auto errors = case_errors("superseismic_shock", 16);
  const std::map<std::string, double> independent = {
      {"fluid.density", 1.77e-3},     {"fluid.velocity_x", 3.96e-3}, {"fluid.temperature", 8.3e-4},
      {"solid.displacement", 4.4e-5}, {"solid.velocity", 1.36e-3},   {"solid.stress", 7.3e-4}};
  for (const auto& [field, most] : independent) EXPECT_LT(errors.at(field).l1, most) << field;
}

TEST(SolidAlone, PlaneWaves) {
  for (const char* wave : {"pressure", "shear"})
    expect_case_order("plane_waves", 4, {{"solid.displacement", 1.9}, {"solid.velocity", 1.9}, {"solid.stress", 1.9}},
                      {std::string("solids.0.initial.wave=") + wave});
}

TEST(SolidAlone, AnnulusModes) {
  expect_case_order("annulus_modes", 4, {{"solid.displacement", 1.9}, {"solid.velocity", 1.9}, {"solid.stress", 1.9}});
}

// The stress next to the free surface comes to its order slowly.
TEST(SolidAlone, RayleighWave) {
  expect_case_order("rayleigh_wave", 4, {{"solid.displacement", 1.9}, {"solid.velocity", 1.9}, {"solid.stress", 1.8}});
}

}  // namespace
}  // namespace mortise
