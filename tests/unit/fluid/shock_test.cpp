#include "mortise/fluid/shock.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(Shock, MachTwoIntoGasAtRest) {
  const Primitive<1> ahead{1, {0}, 1};
  const Primitive<1> behind = behind_shock(ahead, 2, 1.4);
  EXPECT_NEAR(behind.density, 2.666666666667, 1e-12);
  EXPECT_NEAR(behind.velocity[0], 1.479019945775, 1e-12);
  EXPECT_NEAR(behind.pressure, 4.5, 1e-14);
  EXPECT_NEAR(shock_speed(ahead, 2, 1.4), 2.366431913240, 1e-12);
}

TEST(Shock, ConservesMassMomentumAndEnergyAcrossAnObliqueFront) {
  const Primitive<2> ahead{1.4, {0.3, -0.2}, 0.9};
  const std::array<double, 2> n{0.6, -0.8};
  const double gamma = 5.0 / 3, mach = 3.1;
  const Primitive<2> behind = behind_shock(ahead, mach, gamma, n);
  const double speed = shock_speed(ahead, mach, gamma, n);
  const auto flux = [&](const Primitive<2>& W) {
    const Conserved<2> U = to_conserved(W, gamma);
    const double un = W.velocity[0] * n[0] + W.velocity[1] * n[1], r = un - speed;
    return std::array<double, 4>{U.density * r, U.momentum[0] * r + W.pressure * n[0],
                                 U.momentum[1] * r + W.pressure * n[1], U.energy * r + W.pressure * un};
  };
  const auto f1 = flux(ahead), f2 = flux(behind);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(f1[k], f2[k], 1e-13 * 30);
}

TEST(Shock, MachOneIsNoShock) {
  const Primitive<1> ahead{1.4, {0.25}, 1};
  const Primitive<1> behind = behind_shock(ahead, 1, 1.4);
  EXPECT_DOUBLE_EQ(behind.density, 1.4);
  EXPECT_DOUBLE_EQ(behind.velocity[0], 0.25);
  EXPECT_DOUBLE_EQ(behind.pressure, 1);
  EXPECT_DOUBLE_EQ(shock_speed(ahead, 1, 1.4), 1.25);
}

}  // namespace
}  // namespace mortise
