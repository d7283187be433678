// The velocity of a cylinder that a Mach-1.001 shock passes, in units of P/(ρc), P the strength of the shock.
#pragma once

#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise::testing {

/// ct/a after first touch.
inline constexpr std::array<double, 4> weak_shock_times = {0.5, 1, 2, 4};

struct WeakShockRun {
  std::array<double, 4> computed, exact;
  double worst;  // largest error over all steps
};

inline WeakShockRun run_weak_shock(double grid_factor, double density_ratio) {
  CaseRun<2> run("weak_shock_on_free_cylinder",
                 {set("grid.factor", grid_factor), set("bodies.0.density", 1.4 * density_ratio)});
  const auto &behind = run.description.initial.left, &ahead = run.description.initial.right;
  const double density = ahead[0], sound_speed = std::sqrt(1.4 * ahead[3] / density),
               radius = run.description.bodies[0].radius;
  const double unit = (behind[3] - ahead[3]) / (density * sound_speed);
  const double first_touch = (-radius - run.description.initial.position) / (1.001 * sound_speed);
  WeakShockRun result{};
  for (std::size_t k = 0; k < weak_shock_times.size(); ++k) {
    const double t = first_touch + weak_shock_times[k] * radius / sound_speed;
    run.run(t);
    EXPECT_TRUE(run.finished()) << run.reason();
    result.computed[k] = run.simulation.bodies()[0].y[0] / unit;
    result.exact[k] = (*run.scene.exact->bodies(t))[0].velocity[0] / unit;
  }
  EXPECT_LE(std::abs(run.simulation.bodies()[0].y[1]), 1e-10 * unit);
  result.worst = run.worst_velocity() / unit;
  return result;
}

}  // namespace mortise::testing
