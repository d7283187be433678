#include "mortise/cases/exact/running_integral.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mortise {
namespace {

const double outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3, inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
const double outer_weight = (322 - 13 * std::sqrt(70.0)) / 900, inner_weight = (322 + 13 * std::sqrt(70.0)) / 900;
const std::array<double, 5> gauss_nodes{-outer, -inner, 0, inner, outer};
const std::array<double, 5> gauss_weights{outer_weight, inner_weight, 128.0 / 225, inner_weight, outer_weight};

}  // namespace

RunningIntegral::RunningIntegral(std::function<double(double)> f, double length, int panels)
    : f_(std::move(f)), width_(length / panels), sum_(static_cast<std::size_t>(panels), 0.0) {
  for (std::size_t k = 1; k < sum_.size(); ++k)
    sum_[k] = sum_[k - 1] + over(static_cast<double>(k - 1) * width_, static_cast<double>(k) * width_);
}

double RunningIntegral::over(double from, double to) const {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (std::size_t i = 0; i < gauss_nodes.size(); ++i) sum += gauss_weights[i] * f_(middle + half * gauss_nodes[i]);
  return half * sum;
}

double RunningIntegral::operator()(double s) const {
  const int k = std::clamp(static_cast<int>(s / width_), 0, static_cast<int>(sum_.size()) - 1);
  return sum_[static_cast<std::size_t>(k)] + over(k * width_, s);
}

}  // namespace mortise
