// The trigonometric polynomial Re Σ c_m e^{2πimX/L}, m = 0 … M, through 2M + 1 equidistant values of a periodic
// function, and its derivative: exact to round-off for analytic functions and enough harmonics.
#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace mortise {

class PeriodicSeries {
 public:
  PeriodicSeries(const std::function<double(double)>& f, double period, int harmonics);

  double value(double X) const;
  double slope(double X) const;
  double period() const { return period_; }

 private:
  double period_;
  std::vector<std::complex<double>> coefficients_;
};

}  // namespace mortise
