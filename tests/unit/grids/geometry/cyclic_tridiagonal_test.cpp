#include "mortise/grids/geometry/cyclic_tridiagonal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mortise {
namespace {

TEST(CyclicTridiagonal, SolvesWhatTheMatrixMakes) {
  constexpr std::size_t n = 7;
  CyclicTridiagonal matrix(n);
  std::vector<double> x(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i);
    matrix.below[i] = -1 - 0.1 * s;
    matrix.above[i] = 0.7 + 0.05 * s;
    matrix.diagonal[i] = 4 + std::sin(s);
    x[i] = std::cos(2 * s) + s;
  }
  for (std::size_t i = 0; i < n; ++i)
    right[i] = matrix.below[i] * x[(i + n - 1) % n] + matrix.diagonal[i] * x[i] + matrix.above[i] * x[(i + 1) % n];
  const std::vector<double> found = solve(matrix, right);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(found[i], x[i], 1e-14) << "row " << i;
}

}  // namespace
}  // namespace mortise
