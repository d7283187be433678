#include "mortise/grids/core/simd_log.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

/// Largest error of a vector of logarithms relative to std::log; ln 1 must be 0.
double error_at(Pack x) {
  double largest = 0;
  const Pack y = natural_log(x);
  for (int k = 0; k < simd_width; ++k) {
    const double exact = std::log(x[k]);
    EXPECT_NEAR(natural_log(x[k]), exact, 4e-16 * std::fabs(exact));
    largest = std::max(largest, exact == 0 ? std::fabs(y[k]) : std::fabs(y[k] / exact - 1));
  }
  return largest;
}

TEST(SimdLog, AgreesWithTheLibraryToRoundOff) {
  for (double x = 1e-300; x < 1e300; x *= 1.37) EXPECT_LT(error_at(broadcast(x)), 4e-16) << x;
  for (double x = 0.4; x < 2.5; x += 0.00137) EXPECT_LT(error_at(broadcast(x)), 4e-16) << x;
}

TEST(SimdLog, LosesNoDigitsAroundOne) {
  for (double d = 1; d > 1e-16; d *= 0.7) {
    EXPECT_LT(error_at(broadcast(1 + d)), 4e-16) << d;
    EXPECT_LT(error_at(broadcast(1 - 0.9 * d)), 4e-16) << d;
  }
  EXPECT_EQ(natural_log(1.0), 0);
}

TEST(SimdLog, IsNotANumberWhereThereIsNone) {
  for (const double x : {0.0, -0.0, -1.0, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(natural_log(x))) << x;
    for (int k = 0; k < simd_width; ++k) EXPECT_TRUE(std::isnan(natural_log(broadcast(x))[k])) << x;
  }
}

}  // namespace
}  // namespace mortise
