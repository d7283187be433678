#include "mortise/cases/exact/elastic_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Gas at rest with p = p_e beside one linear solid ρ = λ = μ = 1.
CaseDescription scene(const std::string& exact, const std::string& shape) {
  CaseDescription description;
  description.exact = exact;
  description.time_end = 0.5;
  description.initial.state = {1, 0, 0, 1 / 1.4};
  description.coupling.reference_pressure = 1 / 1.4;
  SolidDescription solid;
  solid.shape = shape;
  solid.material = {"linear", 1, 1, 1};
  description.solids = {solid};
  return description;
}

TEST(ElasticCases, PistonFollowsTheWallsAngle) {
  CaseDescription description = scene("elastic_piston", "strip");
  description.solids[0].thickness = 1;
  description.layer.angle = 30;
  const ExactInterface face = *make_exact<2>(description)->interface_at(Point<2>::Zero(), 0.5);
  EXPECT_NEAR((face.position + std::pow(0.5, 4) / 4 * direction(std::acos(-1.0) / 6)).norm(), 0, 1e-15);
}

TEST(ElasticCases, BarStartsFromItsFormulas) {
  CaseDescription description = scene("elastic_bar", "strip");
  SolidDescription& solid = description.solids[0];
  solid.thickness = 1;
  solid.back.kind = "fixed";
  solid.initial.kind = "formula";
  solid.initial.velocity_y = "0.15*sin(pi*y)^4";
  description.layer.angle = 90;
  const auto solution = make_exact<2>(description);
  EXPECT_NEAR(solution->solid({0.3, -0.25}, 0).velocity[1], 0.15 / 4, 1e-15);
  EXPECT_NEAR(solution->solid({0.3, -1}, 0.4).displacement.norm(), 0, 1e-14);
  EXPECT_GT(solution->interface_at({0.3, 0}, 0.4)->velocity[1], 0.01);
  description.solids[0].back.kind = "free";
  EXPECT_THROW(make_exact<2>(description), InputError);
}

TEST(ElasticCases, ShockArrivesFromTheGas) {
  CaseDescription description = scene("elastic_piston_shock", "strip");
  description.solids[0].thickness = 1;
  description.initial.right = {1, 0, 0, 1 / 1.4};
  description.initial.mach = 2;
  description.initial.position = -0.25;
  const auto solution = make_exact<2>(description);
  EXPECT_EQ(solution->interface_at(Point<2>::Zero(), 0.124)->velocity[0], 0);
  EXPECT_LT(solution->interface_at(Point<2>::Zero(), 0.126)->velocity[0], -0.5);
}

TEST(ElasticCases, ShellIsPressedByTheTractionOfItsOuterSide) {
  CaseDescription description = scene("radial_reference", "annulus");
  SolidDescription& solid = description.solids[0];
  solid.gas = "inside";
  solid.inner_radius = 0.5;
  solid.outer_radius = 1;
  solid.outer.traction = "-0.05*sin(pi*t)^8";
  description.coupling.load = "reference";
  description.time_end = 1;
  const ExactInterface face = *make_exact<2>(description)->interface_at({0, 0.5}, 1);
  EXPECT_NEAR(face.position[1], 0.48975854, 1e-8);
  EXPECT_NEAR(face.velocity[1], 0.00902158, 1e-8);
  EXPECT_NEAR(face.pressure, 0.72109885, 1e-8);
}

TEST(ElasticCases, DiffuserHasTheWallOfTheCase) {
  CaseDescription description = scene("deforming_diffuser", "strip");
  SolidDescription& solid = description.solids[0];
  solid.thickness = 0.5;
  solid.wall = "-0.01*(1 - cos(2*pi*x))";
  solid.material = {"linear", 10, 10, 10};
  description.initial.state = {1.4, 2, 0, 1};
  description.coupling.reference_pressure = 1;
  description.coupling.load = "reference";
  description.layer.along_low = 0;
  description.layer.along_high = 1;
  const auto solution = make_exact<2>(description);
  EXPECT_NEAR(solution->interface_at({0.25, -0.01}, 0)->pressure, 0.82065494, 1e-8);
  EXPECT_NEAR(solution->interface_at({0.75, -0.01}, 0)->pressure, 1.2067552, 1e-7);
}

TEST(ElasticCases, SuperseismicShockTakesItsLoadLaw) {
  CaseDescription description = scene("superseismic_shock", "strip");
  description.initial.state = {0.1114827, 0, 0, 0.010451503125};
  description.coupling.reference_pressure = 0.010451503125;
  description.solids[0].material = {"linear", 1, 0.1398307, 0.07203351};
  const Point<2> behind(-0.5, 0.2);
  EXPECT_GT(std::abs(make_exact<2>(description)->state(behind, 0).density - 0.4032762), 1e-5);
  description.coupling.load = "reference";
  EXPECT_NEAR(make_exact<2>(description)->state(behind, 0).density, 0.4032762, 1e-7);
}

}  // namespace
}  // namespace mortise
