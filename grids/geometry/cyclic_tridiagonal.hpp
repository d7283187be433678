// The cyclic tridiagonal system of a closed curve,
//   a_i x_{i−1} + b_i x_i + c_i x_{i+1} = r_i,   indices modulo n,
// by elimination and the Sherman-Morrison formula (Press et al., Numerical Recipes, section 2.7.2).
#pragma once

#include <cstddef>
#include <vector>

namespace mortise {

/// Coefficients of row i, each of length n ≥ 3; diagonally dominant, so that no pivoting is needed.
struct CyclicTridiagonal {
  std::vector<double> below, diagonal, above;

  explicit CyclicTridiagonal(std::size_t n) : below(n), diagonal(n), above(n) {}
};

namespace detail {

/// Thomas algorithm for the system without its two corner entries; overwrites `x` with the solution.
template <class Value>
void solve_tridiagonal(const CyclicTridiagonal& m, const std::vector<double>& diagonal, std::vector<Value>& x) {
  const std::size_t n = x.size();
  std::vector<double> ratio(n);
  double pivot = diagonal[0];
  x[0] = x[0] / pivot;
  for (std::size_t i = 1; i < n; ++i) {
    ratio[i] = m.above[i - 1] / pivot;
    pivot = diagonal[i] - m.below[i] * ratio[i];
    x[i] = (x[i] - m.below[i] * x[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 0;) x[i] -= ratio[i + 1] * x[i + 1];
}

}  // namespace detail

/// Solves m x = right; Value is a number or a vector of numbers.
template <class Value>
std::vector<Value> solve(const CyclicTridiagonal& m, std::vector<Value> right) {
  const std::size_t n = right.size();
  const double gamma = -m.diagonal[0], corner_low = m.above[n - 1], corner_high = m.below[0];
  std::vector<double> diagonal = m.diagonal, u(n, 0.0);
  diagonal[0] -= gamma;
  diagonal[n - 1] -= corner_low * corner_high / gamma;
  u[0] = gamma;
  u[n - 1] = corner_low;
  detail::solve_tridiagonal(m, diagonal, right);
  detail::solve_tridiagonal(m, diagonal, u);
  const double last = corner_high / gamma;
  const Value factor = (right[0] + last * right[n - 1]) / (1 + u[0] + last * u[n - 1]);
  for (std::size_t i = 0; i < n; ++i) right[i] -= u[i] * factor;
  return right;
}

}  // namespace mortise
