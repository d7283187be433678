// Norms over time and over several places of what deviates there from step to step.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mortise/cases/summary/summary.hpp"

namespace mortise {

/// L1 and L2 are means over the places, then over time; nothing is there until something was added.
class TimeNorms {
 public:
  void add(std::span<const double> deviations, double dt) {
    if (deviations.empty()) return;
    double sum = 0, squares = 0;
    for (const double deviation : deviations) {
      sum += std::fabs(deviation);
      squares += deviation * deviation;
      max_ = std::max(max_, std::fabs(deviation));
    }
    const auto count = static_cast<double>(deviations.size());
    sum_ += dt * sum / count;
    squares_ += dt * squares / count;
    time_ += dt;
  }

  bool empty() const { return time_ <= 0; }
  ErrorNorms norms() const { return {sum_ / time_, std::sqrt(squares_ / time_), max_}; }

  /// For restarts: what has been summed up, and going on from there.
  static constexpr std::size_t size = 4;
  std::vector<double> state() const { return {sum_, squares_, max_, time_}; }
  void resume(const double* state) { sum_ = state[0], squares_ = state[1], max_ = state[2], time_ = state[3]; }

 private:
  double sum_ = 0, squares_ = 0, max_ = 0, time_ = 0;
};

}  // namespace mortise
