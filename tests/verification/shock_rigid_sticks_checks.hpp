// What an independent computation says about the five sticks, at h = 0.0125.
#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "verification/case_runner.hpp"

namespace mortise::testing {

struct StickAt {
  double x, y, turned;  // degrees
};
using Sticks = std::vector<StickAt>;

inline const Sticks sticks_at_half = {
    {-0.1665, 0, 0}, {0.0286, 0.9478, -10.4}, {0.0396, -0.8444, 11.5}, {1, 0.35, 0}, {1, -0.3, 0}};
inline const Sticks sticks_at_one = {{0.4887, 0.0058, -0.5},
                                     {0.6749, 0.9106, -21.5},
                                     {0.7025, -0.7732, 23.1},
                                     {1.0672, 0.3363, -10.9},
                                     {1.0802, -0.2936, -3.2}};

inline Sticks sticks(const CaseRun<2>& run) {
  Sticks all;
  for (std::size_t b = 0; b < run.histories.size(); ++b) {
    const Pose<2>&start = run.histories[b].front().pose, &now = run.simulation.bodies()[b].pose;
    all.push_back({now.position[0], now.position[1], (now.angle - start.angle) * 180 / std::numbers::pi});
  }
  return all;
}

inline double distance(const StickAt& a, const StickAt& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace mortise::testing
