#include "mortise/fluid/wall_pressure.hpp"

#include <gtest/gtest.h>

#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/fluid/shock.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::number;

TEST(WallPressure, FluidStructureRiemannProblems) {
  // With the exact interface velocity the relation must return the exact interface pressure and density.
  for (const auto& row : testing::reference_table("fsrp.csv")) {
    SCOPED_TRACE(row.at("case"));
    const double density = number(row, "rho"), pressure = number(row, "p"), gamma = number(row, "gamma");
    const double n = row.at("orient") == "SF" ? 1 : -1;
    const double exact = number(row, "nl_p");
    const double d = n * (number(row, "nl_v") - number(row, "v"));
    const WallResponse wall = wall_response(density, pressure, d, gamma);
    EXPECT_NEAR(wall.pressure, exact, 1e-12 * (exact + pressure));
    const double exact_density = number(row, "nl_rho");  // 0 in a vacuum
    EXPECT_NEAR(wall_density(density, pressure, wall.pressure, gamma), exact_density, 1e-11 * exact_density);
    EXPECT_EQ(d > 0, row.at("wave") == "shock");
  }
}

TEST(WallPressure, LinearFluidStructureRiemannProblems) {
  for (const auto& row : testing::reference_table("fsrp.csv")) {
    SCOPED_TRACE(row.at("case"));
    const double n = row.at("orient") == "SF" ? 1 : -1;
    const double d = n * (number(row, "lin_v") - number(row, "v"));
    const double exact = number(row, "p_e") - number(row, "lin_sigma");
    const double pressure = number(row, "p");
    const WallResponse wall = linear_wall_response(number(row, "rho"), pressure, d, number(row, "gamma"));
    EXPECT_NEAR(wall.pressure, exact, 1e-12 * (std::abs(exact) + pressure));
  }
}

TEST(WallPressure, MachTwoShockOffARigidWall) {
  const Primitive<1> behind = behind_shock(Primitive<1>{1, {0}, 1}, 2, 1.4);
  const WallResponse wall = wall_response(behind.density, behind.pressure, behind.velocity[0], 1.4);
  EXPECT_NEAR(wall.pressure, 15, 1e-13);
  EXPECT_NEAR(wall_density(behind.density, behind.pressure, wall.pressure, 1.4), 6, 1e-13);
}

TEST(WallPressure, SlopeIsTheDerivativeAndContinuousAtRest) {
  const double density = 0.7, pressure = 2.3, gamma = 1.4, c = std::sqrt(gamma * pressure / density);
  for (const double d : {-4.9 * c, -2.0 * c, -0.3 * c, 0.2 * c, c, 30 * c}) {
    const double h = 1e-4 * std::min(c, 5 * c + d);
    const double slope = (wall_response(density, pressure, d + h, gamma).pressure -
                          wall_response(density, pressure, d - h, gamma).pressure) /
                         (2 * h);
    EXPECT_NEAR(wall_response(density, pressure, d, gamma).impedance / slope, 1, 1e-4) << d;
  }
  EXPECT_DOUBLE_EQ(wall_response(density, pressure, 0, gamma).pressure, pressure);
  EXPECT_NEAR(wall_response(density, pressure, 0, gamma).impedance, density * c, 1e-15);
  EXPECT_NEAR(wall_response(density, pressure, -1e-12, gamma).impedance, density * c, 1e-11);
}

TEST(WallPressure, VacuumBehindAWallFasterThanTheEscapeSpeed) {
  EXPECT_EQ(wall_response(1, 1, -5.01 * std::sqrt(1.4), 1.4).pressure, 0);
  EXPECT_EQ(wall_response(1, 1, -5.01 * std::sqrt(1.4), 1.4).impedance, 0);
  EXPECT_GT(wall_response(1, 1, -4.99 * std::sqrt(1.4), 1.4).pressure, 0);
  EXPECT_LT(linear_wall_response(1, 1, -std::sqrt(1.4), 1.4).pressure, 0);
}

TEST(WallPressure, IsTheStarPressureOfTheMirroredGas) {
  // A wall at rest in a gas of speed −d n is the contact of a Riemann problem with the mirror image.
  for (const double d : {-3.0, -0.4, 0.0, 0.6, 12.0}) {
    const Primitive<1> gas{1.3, {-d}, 0.8}, image{1.3, {d}, 0.8};
    const double star = exact_star_state(image, gas, 5.0 / 3).pressure;
    EXPECT_NEAR(wall_response(1.3, 0.8, d, 5.0 / 3).pressure, star, 1e-13 * (star + 0.8)) << d;
  }
}

TEST(WallPressure, IsentropicAndShockRelationsPartAtThirdOrder) {
  const auto gap = [](double d) {
    return wall_response(1, 1, d, 1.4).pressure - isentropic_wall_response(1, 1, d, 1.4).pressure;
  };
  EXPECT_NEAR(gap(0.02) / gap(0.01), 8, 0.2);
  EXPECT_EQ(gap(-0.5), 0);
}

}  // namespace
}  // namespace mortise
