#include "mortise/cases/exact/deforming_diffuser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/prandtl_meyer.hpp"
#include "unit/cases/exact/solid_checks.hpp"

namespace mortise {
namespace {

using testing::elastic_defect;
using testing::euler_defect;

DeformingDiffuserProblem published() {
  DeformingDiffuserProblem problem;
  problem.wall = cosine_wall(0.01, 1);
  return problem;
}

Point<2> on_top(double X) { return {X, -0.01 * (1 - std::cos(2 * std::numbers::pi * X))}; }

TEST(PeriodicSeries, IsExactForItsHarmonics) {
  const auto f = [](double X) { return 0.3 + std::sin(5 * X) - 2 * std::cos(3 * X); };
  const PeriodicSeries series(f, 2 * std::numbers::pi, 6);
  EXPECT_NEAR(series.value(0.7), f(0.7), 1e-14);
  EXPECT_NEAR(series.slope(0.7), 5 * std::cos(3.5) + 6 * std::sin(2.1), 1e-13);
}

TEST(PrandtlMeyer, TabulatedAngles) {
  EXPECT_NEAR(prandtl_meyer_angle(2, 1.4) * 180 / std::numbers::pi, 26.3798, 1e-4);
  EXPECT_NEAR(prandtl_meyer_angle(1, 1.4), 0, 1e-15);
  EXPECT_NEAR(mach_at_angle(prandtl_meyer_angle(3.3, 1.4), 1.4, 2), 3.3, 1e-13);
  EXPECT_THROW(mach_at_angle(-0.1, 1.4, 2), NumericalError);
}

TEST(DeformingDiffuser, ReproducesThePublishedPressures) {
  const DeformingDiffuser solution(published());
  EXPECT_NEAR(solution.interface_at(on_top(0.25), 0)->pressure, 0.82065494, 1e-8);
  EXPECT_NEAR(solution.interface_at(on_top(0.75), 0)->pressure, 1.2067552, 1e-7);
}

TEST(DeformingDiffuser, DoesNotDependOnTheNumberOfHarmonics) {
  const DeformingDiffuser few(published(), 9), many(published(), 16);
  for (const double X : {0.1, 0.33, 0.9}) {
    EXPECT_NEAR(few.interface_at(on_top(X), 0)->pressure, many.interface_at(on_top(X), 0)->pressure, 1e-9);
    EXPECT_NEAR((few.solid({X, -0.2}, 0).stress - many.solid({X, -0.2}, 0).stress).norm(), 0, 1e-9);
  }
}

TEST(DeformingDiffuser, SatisfiesBothSystemsOfEquations) {
  const DeformingDiffuserProblem problem = published();
  const DeformingDiffuser solution(problem);
  for (const Point<2>& X : {Point<2>(0.2, -0.1), Point<2>(0.7, -0.45), Point<2>(0.5, -0.03)})
    EXPECT_LT(elastic_defect(solution, problem.material, X, 0), 1e-6);
  for (const Point<2>& x : {Point<2>(0.1, 0.02), Point<2>(0.5, 0.25), Point<2>(0.95, 0.3)})
    EXPECT_LT(euler_defect(solution, 1.4, x, 0), 1e-6);
}

TEST(DeformingDiffuser, GasAndStripBalanceOnTheDeformedWall) {
  for (const LoadLaw law : {LoadLaw::reference_area, LoadLaw::current_area}) {
    DeformingDiffuserProblem problem = published();
    problem.load = law;
    const DeformingDiffuser solution(problem);
    for (const double X : {0.05, 0.41, 0.8}) {
      const double h = 1e-5;
      const ExactInterface face = *solution.interface_at(on_top(X), 0);
      const Point<2> edge =
          solution.interface_at(on_top(X + h), 0)->position - solution.interface_at(on_top(X - h), 0)->position;
      const Point<2> reference = on_top(X + h) - on_top(X - h);
      const Point<2> n = left_of(edge.normalized()), N = left_of(reference.normalized());
      const double area = law == LoadLaw::current_area ? edge.norm() / reference.norm() : 1;
      const ExactSolid solid = solution.solid(on_top(X), 0);
      EXPECT_NEAR((solid.stress * N + (face.pressure - 1) * area * n).norm(), 0, 1e-9);
      EXPECT_NEAR((on_top(X) + solid.displacement - face.position).norm(), 0, 1e-15);
      const Primitive<2> gas = solution.state(face.position, 0);
      EXPECT_NEAR(gas.pressure, face.pressure, 1e-12);
      EXPECT_NEAR(Point<2>(gas.velocity[0], gas.velocity[1]).dot(n), 0, 1e-9);
    }
  }
}

TEST(DeformingDiffuser, BottomIsHeldAndAllIsPeriodic) {
  const DeformingDiffuser solution(published());
  EXPECT_NEAR(solution.solid({0.37, -0.5}, 0).displacement.norm(), 0, 1e-15);
  EXPECT_NEAR(solution.state({0.3, 0.2}, 0).pressure, solution.state({1.3, 0.2}, 0).pressure, 1e-12);
  EXPECT_NEAR((solution.solid({0.3, -0.2}, 0).stress - solution.solid({1.3, -0.2}, 0).stress).norm(), 0, 1e-13);
}

TEST(DeformingDiffuser, KeepsEntropyAndTotalEnthalpy) {
  const DeformingDiffuser solution(published());
  for (const Point<2>& x : {Point<2>(0.2, 0.01), Point<2>(0.6, 0.15), Point<2>(0.9, 0.3)}) {
    const Primitive<2> W = solution.state(x, 0);
    const double u2 = W.velocity[0] * W.velocity[0] + W.velocity[1] * W.velocity[1];
    EXPECT_NEAR(W.pressure / std::pow(W.density / 1.4, 1.4), 1, 1e-13);
    EXPECT_NEAR(3.5 * W.pressure / W.density + 0.5 * u2, 4.5, 1e-12);
  }
}

}  // namespace
}  // namespace mortise
