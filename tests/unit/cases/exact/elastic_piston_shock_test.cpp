#include "mortise/cases/exact/elastic_piston_shock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::number;

ElasticPistonShockProblem onto(double scale, double mach) {
  ElasticPistonShockProblem problem;
  problem.material.density = problem.material.lambda = problem.material.mu = scale;
  problem.mach = mach;
  problem.angle = 0.4;
  return problem;
}

TEST(ElasticPistonShock, TendsToRigidWallReflection) {
  const ElasticPistonShock solution(onto(1e12, 2));
  EXPECT_NEAR(solution.interface_pressure(), 15, 1e-9);
  EXPECT_NEAR(solution.interface_velocity(), 0, 1e-11);
  EXPECT_NEAR(solution.arrival(), 0.25 / (2 * std::sqrt(1.4)), 1e-15);
  const double t = solution.arrival() + 0.1;
  const Point<2> n = direction(0.4);
  EXPECT_NEAR(solution.state((0.1 * 1.1832159 - 1e-6) * n, t).density, 6, 1e-9);
  EXPECT_NEAR(solution.state((0.1 * 1.1832160 + 1e-6) * n, t).density, 2.666666666666667, 1e-12);
}

/// Velocity and pressure are continuous at the interface and the solid obeys p_e − p = σ0 + ρ c v.
TEST(ElasticPistonShock, BalancesBothSidesForShocksAndFans) {
  for (const double scale : {0.01, 0.1, 1.0, 20.0}) {
    for (const double mach : {1.2, 2.0, 10.0}) {
      ElasticPistonShockProblem problem = onto(scale, mach);
      problem.reference_pressure = 0.9;
      const ElasticPistonShock solution(problem);
      const double t = solution.arrival() + 0.05, v = solution.interface_velocity();
      const Point<2> n = direction(0.4), X = 0.7 * left_of(n);
      const ExactInterface face = *solution.interface_at(X, t);
      const ExactSolid solid = solution.solid(X, t);
      const Primitive<2> gas = solution.state(face.position + 1e-12 * n, t);
      EXPECT_NEAR((X + solid.displacement - face.position).norm(), 0, 1e-14 + 1e-14 * std::abs(v));
      EXPECT_NEAR((solid.velocity - v * n).norm(), 0, 1e-13 * std::abs(v));
      EXPECT_NEAR(gas.velocity[0] * n[0] + gas.velocity[1] * n[1], v, 1e-9 * (1 + std::abs(v)));
      EXPECT_NEAR((solid.stress * n + (face.pressure - 0.9) * n).norm(), 0, 1e-12 * (1 + face.pressure));
      EXPECT_NEAR(gas.pressure, face.pressure, 1e-9 * face.pressure);
      EXPECT_LT(v, 0);
    }
  }
}

TEST(ElasticPistonShock, LightSolidsSendAFanBack) {
  const ElasticPistonShock light(onto(0.01, 2)), heavy(onto(10, 2));
  EXPECT_LT(light.interface_pressure(), 4.5);
  EXPECT_GT(heavy.interface_pressure(), 4.5);
  // In the fan u − 2c/(γ−1) is that of the gas behind the shock and u + c = ξ/t.
  const Point<2> n = direction(0.4);
  const double c2 = std::sqrt(1.4 * 4.5 / (8.0 / 3)), u2 = -1.479019945775, after = 0.1;
  const double xi = (u2 + c2) * after - 1e-3;
  const Primitive<2> W = light.state(xi * n, light.arrival() + after);
  const double c = std::sqrt(1.4 * W.pressure / W.density), u = W.velocity[0] * n[0] + W.velocity[1] * n[1];
  EXPECT_NEAR(u - 5 * c, u2 - 5 * c2, 1e-11);
  EXPECT_NEAR(u + c, xi / after, 1e-11);
}

TEST(ElasticPistonShock, BackReflectsTheStep) {
  ElasticPistonShockProblem problem = onto(1, 2);
  const double c = std::sqrt(3.0);
  const Point<2> n = direction(0.4);
  for (const SolidBack back : {SolidBack::fixed, SolidBack::free}) {
    problem.back = back;
    const ElasticPistonShock solution(problem);
    EXPECT_NEAR(solution.valid_until(), solution.arrival() + 2 / c, 1e-15);
    const double t = solution.arrival() + 1.5 / c;
    const ExactSolid at_back = solution.solid(-n, t), middle = solution.solid(-0.4 * n, t);
    const double held = at_back.displacement.norm() + at_back.velocity.norm();
    EXPECT_NEAR(back == SolidBack::fixed ? held : (at_back.stress * n).norm(), 0, 1e-14);
    EXPECT_NEAR(middle.velocity.dot(n), solution.interface_velocity(), 1e-15);  // not yet reached by the reflection
  }
  problem.back = SolidBack::open;
  EXPECT_EQ(ElasticPistonShock(problem).valid_until(), std::numeric_limits<double>::infinity());
}

TEST(ElasticPistonShock, ShockAheadIsUndisturbed) {
  const ElasticPistonShock solution(onto(1, 2));
  const Point<2> n = direction(0.4);
  const double t = 0.5 * solution.arrival();
  EXPECT_EQ(solution.state(0.1 * n, t).pressure, 1);
  EXPECT_NEAR(solution.state(0.13 * n, t).pressure, 4.5, 1e-14);
  EXPECT_EQ(solution.solid(-0.1 * n, t).velocity.norm(), 0);
  EXPECT_EQ(solution.interface_at(Point<2>::Zero(), t)->position.norm(), 0);
}

}  // namespace
}  // namespace mortise
