#include "mortise/fluid/exact_riemann.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "unit/fluid/gas_options.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::gamma_air, testing::number;

std::array<double, 3> flux(const Primitive<1>& W) {
  const double u = W.velocity[0], mass = W.density * u;
  const double energy = W.pressure / (gamma_air - 1) + 0.5 * mass * u;
  return {mass, mass * u + W.pressure, u * (energy + W.pressure)};
}

std::array<double, 3> conserved(const Primitive<1>& W) {
  const Conserved<1> U = to_conserved(W, gamma_air);
  return {U.density, U.momentum[0], U.energy};
}

TEST(ExactRiemann, StarStatesOfTheStandardProblems) {
  for (const auto& row : testing::reference_table("riemann.csv")) {
    SCOPED_TRACE(row.at("test"));
    const Primitive<1> left{number(row, "rhoL"), {number(row, "uL")}, number(row, "pL")};
    const Primitive<1> right{number(row, "rhoR"), {number(row, "uR")}, number(row, "pR")};
    const StarState star = exact_star_state(left, right, gamma_air);
    const double speed = std::abs(left.velocity[0]) + exact_riemann::sound_speed(left, gamma_air);
    EXPECT_NEAR(star.pressure / number(row, "pstar"), 1, 1e-14);
    EXPECT_NEAR(star.velocity, number(row, "ustar"), 1e-14 * speed);
    EXPECT_NEAR(star.density_left / number(row, "rhostarL"), 1, 1e-14);
    EXPECT_NEAR(star.density_right / number(row, "rhostarR"), 1, 1e-14);
    EXPECT_FALSE(star.vacuum);
  }
}

TEST(ExactRiemann, SodProfile) {
  const Primitive<1> left{1, {0}, 1}, right{0.125, {0}, 0.1};
  EXPECT_EQ(sample(left, right, gamma_air, -1.2).density, 1);
  EXPECT_NEAR(sample(left, right, gamma_air, 0).pressure, 0.30313017805064679, 1e-15);  // tail runs at −0.0703
  EXPECT_NEAR(sample(left, right, gamma_air, 0.92).density, 0.42631942817849516, 1e-15);
  EXPECT_NEAR(sample(left, right, gamma_air, 0.93).density, 0.26557371170530703, 1e-15);
  EXPECT_NEAR(sample(left, right, gamma_air, 1.75).density, 0.26557371170530703, 1e-15);
  EXPECT_EQ(sample(left, right, gamma_air, 1.76).density, 0.125);  // the shock runs at 1.7522
  const Primitive<1> fan = sample(left, right, gamma_air, -0.5);
  EXPECT_NEAR(fan.velocity[0] - exact_riemann::sound_speed(fan, gamma_air), -0.5, 1e-15);
  EXPECT_NEAR(fan.pressure, std::pow(fan.density, gamma_air), 1e-15);
}

TEST(ExactRiemann, VacuumBetweenFansThatDoNotMeet) {
  const Primitive<1> left{1, {-4}, 0.4}, right{1, {4}, 0.4};
  EXPECT_TRUE(exact_star_state(left, right, gamma_air).vacuum);
  const double edge = 4 - 5 * std::sqrt(0.56);
  const Primitive<1> empty = sample(left, right, gamma_air, 0.9 * edge);
  EXPECT_EQ(empty.density, 0);
  EXPECT_EQ(empty.pressure, 0);
  EXPECT_GT(sample(left, right, gamma_air, 1.1 * edge).density, 0);
  EXPECT_GT(sample(left, right, gamma_air, -1.1 * edge).density, 0);
  EXPECT_LT(sample(left, right, gamma_air, 1.001 * edge).pressure, 1e-10);
}

TEST(ExactRiemann, ConservesAndMirrors) {
  // ∫(U(ξ) − U(ξ; t = 0)) dξ = F(left) − F(right) for any states: midpoint rule, so only to first order in the shocks.
  const Primitive<1> left{1, {0.75}, 1}, right{0.125, {-2}, 30};
  const double reach = 40;
  const int points = 400000;
  const double width = 2 * reach / points;
  std::array<double, 3> gain{};
  for (int i = 0; i < points; ++i) {
    const double xi = -reach + (i + 0.5) * width;
    const auto U = conserved(sample(left, right, gamma_air, xi)), U0 = conserved(xi < 0 ? left : right);
    for (std::size_t k = 0; k < 3; ++k) gain[k] += (U[k] - U0[k]) * width;
  }
  const auto fl = flux(left), fr = flux(right);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(gain[k], fl[k] - fr[k], 0.02 * (1 + std::abs(fl[k]) + std::abs(fr[k])));
}

RC_GTEST_PROP(ExactRiemann, SatisfiesRankineHugoniotOrTheRiemannInvariant, ()) {
  const auto positive = [] { return std::pow(10.0, *rc::gen::inRange(-4000, 4000) / 1000.0); };
  const Primitive<1> left{positive(), {*rc::gen::inRange(-500, 500) * 0.02}, positive()};
  const Primitive<1> right{positive(), {*rc::gen::inRange(-500, 500) * 0.02}, positive()};
  const StarState star = exact_star_state(left, right, gamma_air);
  if (star.vacuum) return;
  RC_ASSERT(star.pressure > 0);
  const double g = gamma_air, c = exact_riemann::sound_speed(right, g);
  const double scale =
      c + exact_riemann::sound_speed(left, g) + std::abs(left.velocity[0]) + std::abs(right.velocity[0]);
  if (star.pressure > right.pressure) {
    const double mass_flux = std::sqrt((star.pressure - right.pressure) / (1 / right.density - 1 / star.density_right));
    if (star.pressure > 1.001 * right.pressure)
      RC_ASSERT(std::abs(right.velocity[0] + (star.pressure - right.pressure) / mass_flux - star.velocity) <
                1e-9 * scale);
  } else {
    const double star_c = std::sqrt(g * star.pressure / star.density_right);
    RC_ASSERT(std::abs(star.velocity - right.velocity[0] - 5 * (star_c - c)) < 1e-12 * scale);
  }
  const StarState flipped = exact_star_state(exact_riemann::mirrored(right), exact_riemann::mirrored(left), g);
  RC_ASSERT(std::abs(flipped.pressure - star.pressure) <= 1e-12 * star.pressure);
  RC_ASSERT(std::abs(flipped.velocity + star.velocity) <= 1e-13 * scale);
}

}  // namespace
}  // namespace mortise
