#include "mortise/grids/core/limiters.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mortise {
namespace {

TEST(Limiters, ExactNumbers) {
  EXPECT_EQ(half_slope<Limiter::none>(1.0, 3.0, 0), 1);
  EXPECT_EQ(half_slope<Limiter::minmod>(1.0, 3.0, 0), 0.5);
  EXPECT_EQ(half_slope<Limiter::mc>(1.0, 3.0, 0), 1);  // central
  EXPECT_EQ(half_slope<Limiter::mc>(1.0, 4.0, 0), 1);  // twice the smaller
  EXPECT_EQ(half_slope<Limiter::mc>(-0.5, -4.0, 0), -0.5);
  EXPECT_NEAR(half_slope<Limiter::van_albada>(1.0, 3.0, 0), 0.5 * (1 * 9 + 3 * 1) / 10.0, 1e-15);
  EXPECT_NEAR(half_slope<Limiter::van_albada>(1.0, -2.0, 0.5), 0.5 * (4.5 - 2 * 1.5) / 6.0, 1e-15);
}

TEST(Limiters, ExtremaAreClipped) {
  EXPECT_EQ(half_slope<Limiter::minmod>(1.0, -3.0, 0), 0);
  EXPECT_EQ(half_slope<Limiter::mc>(1.0, -3.0, 0), 0);
  EXPECT_EQ(half_slope<Limiter::mc>(0.0, 3.0, 0), 0);
}

TEST(Limiters, UniformFlowHasNoSlope) {
  EXPECT_EQ(half_slope<Limiter::van_albada>(0.0, 0.0, 0), 0);
  EXPECT_EQ(half_slope<Limiter::mc>(0.0, 0.0, 0), 0);
}

template <Limiter limiter>
void check_symmetries() {
  const auto number = rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int n) { return n * 1.7e-5; });
  EXPECT_TRUE(rc::check("odd, exact on lines, the same in every lane", [&] {
    const double a = *number, b = *number, floor = std::abs(*number);
    const double h = half_slope<limiter>(a, b, floor);
    RC_ASSERT(h == -half_slope<limiter>(-b, -a, floor));
    RC_ASSERT(std::abs(half_slope<limiter>(a, a, floor) - 0.5 * a) <= 1e-15 * std::abs(a));
    const Pack v = half_slope<limiter>(broadcast(a), broadcast(b), floor);
    for (int k = 0; k < simd_width; ++k) RC_ASSERT(std::abs(v[k] - h) <= 4e-16 * (std::abs(a) + std::abs(b)));
    for (int k = 1; k < simd_width; ++k) RC_ASSERT(v[k] == v[0]);
  }));
}
TEST(Limiters, NoneIsSymmetric) { check_symmetries<Limiter::none>(); }
TEST(Limiters, MinmodIsSymmetric) { check_symmetries<Limiter::minmod>(); }
TEST(Limiters, McIsSymmetric) { check_symmetries<Limiter::mc>(); }
TEST(Limiters, VanAlbadaIsSymmetric) { check_symmetries<Limiter::van_albada>(); }

}  // namespace
}  // namespace mortise
