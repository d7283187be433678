#include "mortise/cases/exact/periodic_series.hpp"

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

std::complex<double> turn(double fraction) { return std::polar(1.0, 2 * std::numbers::pi * fraction); }

}  // namespace

PeriodicSeries::PeriodicSeries(const std::function<double(double)>& f, double period, int harmonics)
    : period_(period), coefficients_(static_cast<std::size_t>(harmonics) + 1) {
  const int points = 2 * harmonics + 1;
  for (int i = 0; i < points; ++i) {
    const double value = f(period * i / points);
    for (int m = 0; m <= harmonics; ++m)
      coefficients_[static_cast<std::size_t>(m)] +=
          (m == 0 ? 1.0 : 2.0) / points * value * turn(-static_cast<double>(m * i % points) / points);
  }
}

double PeriodicSeries::value(double X) const {
  const std::complex<double> z = turn(X / period_);
  std::complex<double> sum = 0;
  for (std::size_t m = coefficients_.size(); m-- > 0;) sum = sum * z + coefficients_[m];
  return sum.real();
}

double PeriodicSeries::slope(double X) const {
  const std::complex<double> z = turn(X / period_), i(0, 2 * std::numbers::pi / period_);
  std::complex<double> sum = 0;
  for (std::size_t m = coefficients_.size(); m-- > 0;) sum = sum * z + static_cast<double>(m) * i * coefficients_[m];
  return sum.real();
}

}  // namespace mortise
