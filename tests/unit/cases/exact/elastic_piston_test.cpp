#include "mortise/cases/exact/elastic_piston.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/elastic_bar.hpp"
#include "mortise/cases/exact/linear_elasticity.hpp"
#include "unit/cases/exact/solid_checks.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::elastic_defect;
using testing::euler_defect;
using testing::number;

ElasticPistonProblem against_unit_gas(double density, double speed, double reference_pressure, double time_end) {
  ElasticPistonProblem problem;
  problem.material.density = density;
  problem.material.lambda = 0.25 * density * speed * speed;
  problem.material.mu = 0.375 * density * speed * speed;
  problem.reference_pressure = reference_pressure;
  problem.time_end = time_end;
  return problem;
}

ElasticPiston receding() { return ElasticPiston(power_of_time(against_unit_gas(1, 2, 0, 0.9), -0.25, 4)); }
ElasticPiston advancing() { return ElasticPiston(power_of_time(against_unit_gas(10, 1.5, 1, 0.9), 1.0 / 16, 4)); }
ElasticPiston bar() {
  return ElasticPiston(fixed_bar(against_unit_gas(1, 1, 1, 1.8),
                                 [](double xi) { return 0.15 * std::pow(std::sin(std::numbers::pi * xi), 4); }));
}

void expect_history(const ElasticPiston& solution, const std::string& file) {
  for (const auto& row : testing::reference_table(file)) {
    const double t = number(row, "t");
    if (t > 1.8) continue;
    const ExactInterface face = *solution.interface_at(Point<2>::Zero(), t);
    EXPECT_NEAR(face.position[0], number(row, "F"), 1e-12) << t;
    EXPECT_NEAR(face.velocity[0], number(row, "Fdot"), 1e-12) << t;
    EXPECT_NEAR(face.pressure, number(row, "p"), 1e-12) << t;
    EXPECT_NEAR(solution.solid(Point<2>::Zero(), t).stress(0, 0), number(row, "sigma"), 1e-12) << t;
  }
}

void expect_profiles(const ElasticPiston& solution, const std::string& fluid, const std::string& solid, double t) {
  for (const auto& row : testing::reference_table(fluid)) {
    const Primitive<2> W = solution.state({number(row, "x"), 0.3}, t);
    EXPECT_NEAR(W.density, number(row, "rho"), 1e-12);
    EXPECT_NEAR(W.velocity[0], number(row, "v"), 1e-12);
    EXPECT_NEAR(W.pressure, number(row, "p"), 1e-12);
  }
  for (const auto& row : testing::reference_table(solid)) {
    const ExactSolid at = solution.solid({number(row, "xref"), -0.7}, t);
    EXPECT_NEAR(at.displacement[0], number(row, "u"), 1e-12);
    EXPECT_NEAR(at.velocity[0], number(row, "v"), 1e-12);
    EXPECT_NEAR(at.stress(0, 0), number(row, "sigma"), 1e-12);
  }
}

TEST(ElasticPiston, RecedingFaceFollowsTheReferenceHistory) {
  expect_history(receding(), "elastic_piston_1_interface.csv");
}
TEST(ElasticPiston, RecedingFaceGivesTheReferenceProfiles) {
  expect_profiles(receding(), "elastic_piston_1_fluid_t0.9.csv", "elastic_piston_1_solid_t0.9.csv", 0.9);
}
TEST(ElasticPiston, AdvancingFaceFollowsTheReferenceHistory) {
  expect_history(advancing(), "elastic_piston_3_interface.csv");
}
TEST(ElasticPiston, AdvancingFaceGivesTheReferenceProfiles) {
  expect_profiles(advancing(), "elastic_piston_3_fluid_t0.9.csv", "elastic_piston_3_solid_t0.9.csv", 0.9);
}
TEST(ElasticPiston, FixedBarFollowsTheReferenceHistory) { expect_history(bar(), "elastic_piston_6_interface.csv"); }
TEST(ElasticPiston, FixedBarGivesTheReferenceProfiles) {
  expect_profiles(bar(), "elastic_piston_6_fluid_t1.8.csv", "elastic_piston_6_solid_t1.8.csv", 1.8);
}

TEST(ElasticPiston, FixedBarStartsUndeformedAndItsBackStays) {
  const ElasticPiston solution = bar();
  for (const double xi : {-0.9, -0.5, -0.2}) {
    const ExactSolid start = solution.solid({xi, 0}, 0);
    EXPECT_NEAR(start.displacement.norm(), 0, 1e-15);
    EXPECT_NEAR(start.velocity[0], 0.15 * std::pow(std::sin(std::numbers::pi * xi), 4), 1e-15);
  }
  for (const double t : {0.3, 0.9, 1.5}) EXPECT_NEAR(solution.solid({-1, 0}, t).displacement.norm(), 0, 1e-14) << t;
}

/// The published piston: gas with speed of sound 1, solid ρ = λ = μ = s, at rest under the pressure of the gas.
ElasticPistonProblem published(double scale, double angle) {
  ElasticPistonProblem problem;
  problem.density = 0.1;
  problem.pressure = problem.reference_pressure = 1.0 / 14;
  problem.material.density = problem.material.lambda = problem.material.mu = scale;
  problem.angle = angle;
  problem.time_end = 0.7;
  return power_of_time(problem, -0.25, 4);
}

TEST(ElasticPiston, SatisfiesBothSystemsOfEquations) {
  for (const double scale : {0.01, 1.0, 10.0}) {
    const ElasticPistonProblem problem = published(scale, 0.6);
    const ElasticPiston solution(problem);
    EXPECT_EQ(solution.valid_until(), 0.7);
    for (const double xi : {-0.95, -0.5, -0.05}) {
      const Point<2> X = xi * direction(0.6) + 0.2 * left_of(direction(0.6));
      EXPECT_LT(elastic_defect(solution, problem.material, X, 0.5), 1e-8 * (1 + scale)) << scale << " " << xi;
    }
    for (const double xi : {0.0, 0.1, 0.3, 0.49})
      EXPECT_LT(euler_defect(solution, 1.4, xi * direction(0.6), 0.5), 1e-9);
  }
}

TEST(ElasticPiston, GasAndSolidMeetAtTheInterface) {
  const ElasticPiston solution(published(0.1, 2.0));
  const Point<2> n = direction(2.0), X = 0.4 * left_of(n);
  for (const double t : {0.1, 0.4, 0.7}) {
    const ExactSolid solid = solution.solid(X, t);
    const ExactInterface face = *solution.interface_at(X, t);
    const Primitive<2> gas = solution.state(face.position, t);
    EXPECT_NEAR((X + solid.displacement - face.position).norm(), 0, 1e-14);
    EXPECT_NEAR((solid.velocity - face.velocity).norm(), 0, 1e-14);
    EXPECT_NEAR(std::hypot(gas.velocity[0] - face.velocity[0], gas.velocity[1] - face.velocity[1]), 0, 1e-12);
    EXPECT_NEAR((solid.stress * n + (face.pressure - 1.0 / 14) * n).norm(), 0, 1e-14);
    EXPECT_NEAR(gas.pressure, face.pressure, 1e-12);
    EXPECT_NEAR(face.position.dot(n), -0.25 * std::pow(t, 4), 1e-14);
  }
}

TEST(ElasticPiston, RotationTurnsTheAnswer) {
  const ElasticPiston straight(published(1, 0)), turned(published(1, 0.5));
  const Eigen::Matrix2d R =
      (Eigen::Matrix2d() << std::cos(0.5), -std::sin(0.5), std::sin(0.5), std::cos(0.5)).finished();
  const Point<2> X(-0.3, 0.2);
  const ExactSolid a = straight.solid(X, 0.6), b = turned.solid(R * X, 0.6);
  EXPECT_NEAR((R * a.velocity - b.velocity).norm(), 0, 1e-15);
  EXPECT_NEAR((R * a.displacement - b.displacement).norm(), 0, 1e-15);
  EXPECT_NEAR((R * a.stress * R.transpose() - b.stress).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace mortise
