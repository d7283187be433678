#include "mortise/cases/exact/superseismic_shock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

TEST(SuperseismicShock, ReproducesThePublishedConstants) {
  const SuperseismicShock solution(SuperseismicShockProblem{});
  EXPECT_NEAR(std::cos(solution.shock_angle()), 0.9981722, 1e-7);
  EXPECT_NEAR(std::sin(solution.shock_angle()), 0.06043363, 1e-7);
  EXPECT_NEAR(solution.pressure_amplitude(), 0.3079172, 2e-7);
  EXPECT_NEAR(solution.shear_amplitude(), -0.1229946, 2e-7);
  const Primitive<2> behind = solution.state({-0.5, 0.5}, 0);
  EXPECT_NEAR(behind.density, 0.4032762, 1e-7);
  EXPECT_NEAR(behind.velocity[0], 0.7209148, 1e-7);
  EXPECT_NEAR(behind.velocity[1], -0.04364727, 1e-7);
  EXPECT_NEAR(behind.pressure / behind.density, 0.2252081, 1e-7);
  const Primitive<2> ahead = solution.state({0.5, 0.1}, 0);
  EXPECT_EQ(ahead.density, 0.1114827);
  EXPECT_EQ(ahead.velocity[0], 0);
}

/// Conditions between gas and surface behind the foot, on the deformed normal.
void expect_balance(const SuperseismicShock& solution, LoadLaw law) {
  const SuperseismicShockProblem problem;
  const Point<2> X(-0.3, 0), beside(-0.3001, 0);
  const double t = 0.5;
  const ExactSolid solid = solution.solid(X, t);
  const ExactInterface here = *solution.interface_at(X, t), next = *solution.interface_at(beside, t);
  const Point<2> edge = (here.position - next.position) / 1e-4;
  const Point<2> normal = Point<2>(-edge[1], edge[0]) / edge.norm();
  const double area = law == LoadLaw::current_area ? edge.norm() : 1;
  const Primitive<2> gas = solution.state(here.position, t);
  const Point<2> slip(gas.velocity[0] - solid.velocity[0], gas.velocity[1] - solid.velocity[1]);
  EXPECT_NEAR(slip.dot(normal), 0, 1e-11);
  const Point<2> load = -(gas.pressure - problem.reference_pressure) * area * normal;
  EXPECT_NEAR((solid.stress.col(1) - load).norm(), 0, 1e-11);
  EXPECT_NEAR((here.velocity - solid.velocity).norm(), 0, 1e-15);
  EXPECT_EQ(here.pressure, gas.pressure);
}

TEST(SuperseismicShock, GasAndSolidBalancePerReferenceArea) {
  expect_balance(SuperseismicShock(SuperseismicShockProblem{}), LoadLaw::reference_area);
}

TEST(SuperseismicShock, GasAndSolidBalancePerCurrentArea) {
  SuperseismicShockProblem problem;
  problem.load = LoadLaw::current_area;
  const SuperseismicShock solution(problem), published(SuperseismicShockProblem{});
  expect_balance(solution, LoadLaw::current_area);
  EXPECT_GT(std::abs(solution.pressure_amplitude() - published.pressure_amplitude()), 1e-3);
}

TEST(SuperseismicShock, ShockSatisfiesRankineHugoniot) {
  const SuperseismicShock solution(SuperseismicShockProblem{});
  const double t = 0.2, c = std::cos(solution.shock_angle()), s = std::sin(solution.shock_angle());
  const Point<2> n(c, -s), on_front = Point<2>(t, 0) + 0.5 * Point<2>(s, c);
  const Primitive<2> a = solution.state(on_front + 1e-9 * n, t), b = solution.state(on_front - 1e-9 * n, t);
  const double speed = c;  // the foot moves at 1
  const double ua = a.velocity[0] * n[0] + a.velocity[1] * n[1] - speed;
  const double ub = b.velocity[0] * n[0] + b.velocity[1] * n[1] - speed;
  EXPECT_NEAR(a.density * ua, b.density * ub, 1e-15);
  EXPECT_NEAR(a.density * ua * ua + a.pressure, b.density * ub * ub + b.pressure, 1e-15);
  EXPECT_NEAR(3.5 * a.pressure / a.density + 0.5 * ua * ua, 3.5 * b.pressure / b.density + 0.5 * ub * ub, 1e-15);
}

TEST(SuperseismicShock, SolidJumpsSatisfyMomentumAndCompatibility) {
  // Across a front that moves with c along k: [v] = −c [∇u] k and ρ c [v] = −[σ] k; the displacement is continuous.
  const SuperseismicShock solution(SuperseismicShockProblem{});
  const double c_p = std::sqrt(0.1398307 + 2 * 0.07203351), c_s = std::sqrt(0.07203351), t = 0.5;
  for (const double c : {c_p, c_s}) {
    const Point<2> k(c, -std::sqrt(1 - c * c)), on_front = Point<2>(t, 0) - 0.4 * Point<2>(-k[1], k[0]);
    const ExactSolid ahead = solution.solid(on_front + 1e-9 * k, t), behind = solution.solid(on_front - 1e-9 * k, t);
    const Point<2> jump = behind.velocity - ahead.velocity;
    EXPECT_GT(jump.norm(), 0.01);
    EXPECT_NEAR((jump + c * (behind.gradient - ahead.gradient) * k).norm(), 0, 1e-15);
    EXPECT_NEAR((c * jump + (behind.stress - ahead.stress) * k).norm(), 0, 1e-15);
    EXPECT_NEAR((behind.displacement - ahead.displacement).norm(), 0, 1e-9);
  }
}

TEST(SuperseismicShock, SlowFootIsRefused) {
  SuperseismicShockProblem problem;
  problem.foot_speed = 0.5;
  EXPECT_THROW(SuperseismicShock{problem}, InputError);
}

}  // namespace
}  // namespace mortise
