#include "mortise/cases/exact/bessel_k.hpp"

#include <cmath>
#include <numbers>

namespace mortise {

std::complex<double> scaled_bessel_k(int n, std::complex<double> z) {
  // The integrand's nearest singularity x² = −2z is at least √|z| away from the real axis: the error is exp(−2π√|z|/h).
  const double h = std::min(0.2, 2 * std::numbers::pi * std::sqrt(std::abs(z)) / 34), reach = 6.5;
  const int points = static_cast<int>(std::ceil(reach / h));
  std::complex<double> sum = n == 0 ? 0.5 : 0.0;
  for (int k = 1; k <= points; ++k) {
    const double x = k * h;
    sum += std::exp(-x * x) * std::pow(x, 2 * n) * std::pow(1.0 + x * x / (2.0 * z), n - 0.5);
  }
  return std::sqrt(std::numbers::pi / (2.0 * z)) / std::tgamma(n + 0.5) * 2.0 * h * sum;
}

}  // namespace mortise
