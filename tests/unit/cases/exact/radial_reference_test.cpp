#include "mortise/cases/exact/radial_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"
#include "unit/cases/exact/solid_checks.hpp"

namespace mortise {
namespace {

using testing::elastic_defect;
using testing::euler_defect;

/// A disk of gas in an annulus that is pulled on its outer face.
RadialProblem shell(LoadLaw load) {
  RadialProblem problem;
  problem.far_stress = [](double t) { return t < 1 ? -0.05 * std::pow(std::sin(std::numbers::pi * t), 8) : 0.0; };
  problem.load = load;
  return problem;
}

/// A disk that turns in gas at rest; s is the density and stiffness of the solid over those of the gas.
RadialProblem rotating_disk(double s) {
  RadialProblem problem;
  problem.density = 1.4 / s;
  problem.pressure = 1 / s;
  problem.interface_radius = 1;
  problem.solid_end = 0;
  problem.gas_end = 5;
  problem.angular_velocity = 0.1;
  problem.time_end = 0.5;
  return problem;
}

TEST(RadialReference, ShellReachesThePublishedState) {
  const RadialReference solution(shell(LoadLaw::reference_area), 100, 8);
  const RadialInterface face = solution.interface_now(1);
  EXPECT_NEAR(face.position[0], 0.48975854, 1e-8);
  EXPECT_NEAR(face.velocity[0], 0.00902158, 1e-8);
  EXPECT_NEAR(face.pressure, 0.72109885, 1e-8);
  EXPECT_EQ(solution.valid_until(), 1);
}

TEST(RadialReference, LoadLawsDiffer) {
  const RadialReference solution(shell(LoadLaw::current_area), 100, 8);
  EXPECT_NEAR(solution.interface_now(1).position[0], 0.489708595, 2e-9);
}

TEST(RadialReference, ExtrapolationConvergesFast) {
  const RadialReference coarse(shell(LoadLaw::current_area), 50, 4), fine(shell(LoadLaw::current_area), 100, 4);
  for (const double r : {0.01, 0.2, 0.45}) {
    const Primitive<2> a = coarse.state({0, r}, 1), b = fine.state({0, r}, 1);
    EXPECT_NEAR(a.density, b.density, 5e-6) << r;
    EXPECT_NEAR(a.velocity[1], b.velocity[1], 5e-6) << r;
    EXPECT_NEAR(a.pressure, b.pressure, 5e-6) << r;
  }
  for (const double R : {0.5, 0.7, 1.0})
    EXPECT_NEAR((coarse.solid({R, 0}, 1).stress - fine.solid({R, 0}, 1).stress).norm(), 0, 1e-5) << R;
}

TEST(RadialReference, SatisfiesBothSystemsOfEquations) {
  const RadialProblem problem = shell(LoadLaw::current_area);
  const RadialReference solution(problem, 100, 200);
  const double t = 0.805, h = 0.005;
  for (const Point<2>& X : {Point<2>(0.55, 0.1), Point<2>(-0.4, 0.6), Point<2>(0, -0.9)})
    EXPECT_LT(elastic_defect(solution, problem.material, X, t, h), 2e-3);
  for (const Point<2>& x : {Point<2>(0.1, 0.05), Point<2>(-0.2, 0.3)})
    EXPECT_LT(euler_defect(solution, 1.4, x, t, h), 2e-3);
  // The accelerations that the stresses balance are a hundred times larger.
  const Point<2> X(0.55, 0.1);
  EXPECT_GT((solution.solid(X, t + h).velocity - solution.solid(X, t - h).velocity).norm() / (2 * h), 0.1);
}

TEST(RadialReference, GasAndSolidMeetAtTheInterface) {
  for (const RadialProblem& problem : {shell(LoadLaw::current_area), rotating_disk(0.1)}) {
    const RadialReference solution(problem, 60, 8);
    const double t = problem.time_end, a = problem.interface_radius, side = problem.gas_end > a ? 1 : -1;
    const Point<2> N = side * direction(0.7), X = a * direction(0.7);
    const ExactInterface face = *solution.interface_at(X, t);
    const ExactSolid solid = solution.solid(X, t);
    EXPECT_NEAR((X + solid.displacement - face.position).norm(), 0, 1e-7);
    EXPECT_NEAR((solid.velocity - face.velocity).norm(), 0, 1e-6);
    const Primitive<2> gas = solution.state(face.position, t);
    const Point<2> n = side * face.position.normalized(), u(gas.velocity[0], gas.velocity[1]);
    EXPECT_NEAR(u.dot(n), face.velocity.dot(n), 1e-6);
    EXPECT_NEAR(gas.pressure, face.pressure, 1e-5);
    const Point<2> load = -(face.pressure - problem.pressure) * face.position.norm() / a * n;
    EXPECT_NEAR((solid.stress * N - load).norm(), 0, 1e-5);
    EXPECT_GT(load.norm(), 1e-3);
  }
}

TEST(RadialReference, WallInsideTheGasReflects) {
  RadialProblem problem = shell(LoadLaw::current_area);
  problem.gas_end = 0.25;
  problem.time_end = 1.5;
  const RadialReference coarse(problem, 50, 4), fine(problem, 100, 4);
  EXPECT_EQ(fine.valid_until(), 1.5);
  EXPECT_NEAR(fine.state({0.25, 0}, 1.5).velocity[0], 0, 1e-5);
  EXPECT_GT(std::abs(fine.state({0.25, 0}, 1.5).pressure - problem.pressure), 1e-3);
  EXPECT_NEAR(coarse.interface_now(1.5).pressure, fine.interface_now(1.5).pressure, 5e-6);
}

TEST(RadialReference, DiskInThinGasFliesStraight) {
  RadialProblem problem = rotating_disk(1);
  problem.density = problem.pressure = 1e-9;
  const RadialReference solution(problem, 50, 2);
  const Point<2> X(0.6, 0.8);
  const ExactInterface face = *solution.interface_at(X, 0.5);
  EXPECT_NEAR((face.position - (X + 0.05 * left_of(X))).norm(), 0, 1e-9);
  const ExactSolid inside = solution.solid({0.2, 0.1}, 0.5), center = solution.solid({0, 0}, 0.5);
  EXPECT_NEAR((inside.velocity - Point<2>(-0.01, 0.02)).norm(), 0, 1e-9);
  EXPECT_NEAR(inside.stress.norm() + center.stress.norm() + center.displacement.norm(), 0, 1e-9);
  EXPECT_NEAR(inside.gradient(1, 0), 0.05, 1e-9);
  EXPECT_NEAR(inside.gradient(0, 1), -0.05, 1e-9);
}

TEST(RadialReference, RotatingDiskPushesTheGas) {
  for (const double s : {1.0, 0.1}) {
    const RadialReference solution(rotating_disk(s), 100, 4);
    EXPECT_NEAR(solution.interface_now(0.5).position.norm(), s == 1 ? 1.000708026 : 1.000144591, 2e-9) << s;
    const Primitive<2> far = solution.state({0, -3}, 0.5);
    EXPECT_EQ(far.density, 1.4 / s);
    EXPECT_EQ(far.velocity[1], 0);
    EXPECT_EQ(solution.state({0, 1.2}, 0).velocity[1], 0);
    EXPECT_GT(solution.state({0, 1.01}, 0.5).velocity[1], 1e-4);
  }
}

TEST(RadialReference, GasAndSolidOnOneSideAreRefused) {
  RadialProblem problem;
  problem.gas_end = 2;
  EXPECT_THROW(RadialReference{problem}, InputError);
}

}  // namespace
}  // namespace mortise
