// What is known about the ellipse that a Mach-2 shock sweeps away.
#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "verification/case_runner.hpp"

namespace mortise::testing {

struct EllipseAt {
  double time, x, y, degrees;
};

/// Read off published figures, ±0.004, for mass and inertia 0.
inline constexpr EllipseAt published_ellipse[] = {
    {0.4, 0.166, 0.079, 64.6}, {0.6, 0.403, 0.216, 85.0}, {1.0, 0.934, 0.327, 91.8}};
/// An independent computation of the same on a uniform grid, h = 1/160.
inline constexpr EllipseAt independent_ellipse[] = {
    {0.4, 0.1675, 0.0807, 64.8}, {0.6, 0.4056, 0.2183, 85.1}, {1.0, 0.9368, 0.3299, 91.65}};
/// An independent computation for density 1.
inline constexpr EllipseAt heavy_ellipse = {1.0, 0.7362, 0.0436, 45 + 30.9};

inline EllipseAt ellipse(const CaseRun<2>& run) {
  const Pose<2>& pose = run.simulation.bodies()[0].pose;
  return {run.simulation.time(), pose.position[0], pose.position[1], pose.angle * 180 / std::numbers::pi};
}

inline double distance(const EllipseAt& a, const EllipseAt& b) { return std::hypot(a.x - b.x, a.y - b.y); }

inline void expect_ellipse(const CaseRun<2>& run, const EllipseAt& expected, double distance_bound, double degrees) {
  const EllipseAt now = ellipse(run);
  EXPECT_LE(distance(now, expected), distance_bound) << "t = " << now.time << ": (" << now.x << ", " << now.y << ")";
  EXPECT_NEAR(now.degrees, expected.degrees, degrees) << "t = " << now.time;
}

}  // namespace mortise::testing
