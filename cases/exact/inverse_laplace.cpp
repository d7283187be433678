#include "mortise/cases/exact/inverse_laplace.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace mortise {
namespace {

constexpr std::size_t terms = 15;  // M

/// ξ_0 = ½, ξ_k = 1 for 1 ≤ k ≤ M, ξ_{2M} = 2^{−M}, ξ_{2M−k} = ξ_{2M−k+1} + 2^{−M} binomial(M, k) for 0 < k < M.
std::array<double, 2 * terms + 1> euler_weights() {
  std::array<double, 2 * terms + 1> weights;
  weights.fill(1);
  weights[0] = 0.5;
  const double last = std::ldexp(1.0, -static_cast<int>(terms));
  weights[2 * terms] = last;
  double binomial = 1;
  for (std::size_t k = 1; k < terms; ++k) {
    binomial *= static_cast<double>(terms - k + 1) / static_cast<double>(k);
    weights[2 * terms - k] = weights[2 * terms - k + 1] + last * binomial;
  }
  return weights;
}

}  // namespace

double inverse_laplace(const std::function<std::complex<double>(std::complex<double>)>& transform, double t) {
  static const auto weights = euler_weights();
  const double line = static_cast<double>(terms) * std::numbers::ln10 / 3;
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const std::complex<double> s{line / t, std::numbers::pi * static_cast<double>(k) / t};
    sum += (k % 2 == 0 ? weights[k] : -weights[k]) * transform(s).real();
  }
  return std::exp(line) / t * sum;
}

}  // namespace mortise
