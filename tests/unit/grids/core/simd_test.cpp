#include "mortise/grids/core/simd.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace mortise {
namespace {

Pack ramp(double first, double step) {
  Pack v{};
  for (int k = 0; k < simd_width; ++k) v[k] = first + k * step;
  return v;
}

TEST(Simd, InverseSqrtIsAccurateToRoundOff) {
  for (double x = 1e-30; x < 1e30; x *= 1.37) {
    const Pack v = ramp(x, 0.11 * x), y = inverse_sqrt(v);
    for (int k = 0; k < simd_width; ++k) EXPECT_NEAR(y[k] * std::sqrt(v[k]), 1, 5e-16) << v[k];
  }
}

TEST(Simd, LaneByLaneFunctionsAgreeWithTheScalarOnes) {
  for (double b = -2; b < 2; b += 0.37) {
    const Pack x = ramp(-1.3, 0.45), y = ramp(b, 0.21);
    for (int k = 0; k < simd_width; ++k) {
      EXPECT_EQ(min(x, y)[k], min(x[k], y[k]));
      EXPECT_EQ(max(x, y)[k], max(x[k], y[k]));
      EXPECT_EQ(abs(x)[k], abs(x[k]));
      EXPECT_EQ(sqrt(abs(x))[k], std::sqrt(std::fabs(x[k])));
      EXPECT_EQ(smaller_magnitude(x, y)[k], smaller_magnitude(x[k], y[k]));
      EXPECT_EQ(larger_magnitude(x, y)[k], larger_magnitude(x[k], y[k]));
      EXPECT_EQ(limit_magnitude(x, abs(y))[k], limit_magnitude(x[k], abs(y[k])));
      EXPECT_EQ(select(x > y, x, y)[k], select(x[k] > y[k], x[k], y[k]));
    }
  }
}

TEST(Simd, LanesBelowCountsFromTheFirstLane) {
  for (int count = -1; count <= simd_width + 1; ++count) {
    const Pack ones = select(lanes_below(count), broadcast(1), broadcast(0));
    for (int k = 0; k < simd_width; ++k) EXPECT_EQ(ones[k], k < count ? 1 : 0);
  }
}

TEST(Simd, LoadsAndStoresAtAnyAlignment) {
  std::array<double, 3 * simd_width> from{}, to{};
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<double>(i) + 0.5;
  for (std::size_t offset = 0; offset < simd_width; ++offset) {
    store(to.data() + offset, load(from.data() + offset + 1));
    for (std::size_t k = 0; k < simd_width; ++k) EXPECT_EQ(to[offset + k], from[offset + k + 1]);
  }
  EXPECT_EQ(horizontal_max(load(from.data())), simd_width - 0.5);
}

TEST(Simd, AllPositiveSeesOneBadLane) {
  EXPECT_TRUE(all_positive(broadcast(1e-300)));
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    for (int k = 0; k < simd_width; ++k) {
      Pack v = broadcast(1);
      set_lane(v, k, bad);
      EXPECT_FALSE(all_positive(v));
      EXPECT_FALSE(all_positive(bad));
    }
}

}  // namespace
}  // namespace mortise
