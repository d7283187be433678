// I(s) = ∫₀ˢ f(τ) dτ for 0 ≤ s ≤ length to round-off: Gauss's rule of five points on equal panels, summed once, and on
// the part of the last panel.
#pragma once

#include <functional>
#include <vector>

namespace mortise {

class RunningIntegral {
 public:
  /// f is smooth on each of the panels.
  RunningIntegral(std::function<double(double)> f, double length, int panels);
  double operator()(double s) const;

 private:
  double over(double from, double to) const;

  std::function<double(double)> f_;
  double width_;             // of a panel
  std::vector<double> sum_;  // over the panels before each one
};

}  // namespace mortise
