#include "mortise/cases/exact/rigid_piston.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/grids/core/error.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::number;

using std::numbers::pi;

CaseDescription scene(double mass, double width) {
  CaseDescription description;
  description.dimension = 1;
  description.domain_low = {-2, 0};
  description.domain_high = {2, 0};
  description.time_end = 0.9;
  description.initial.kind = "uniform";
  description.initial.state = {1, 0, 0, 1};
  BodyDescription body;
  body.shape = "slab";
  body.width = width;
  body.mass = mass;
  description.bodies = {body};
  return description;
}

/// Mass 0.5 in gas (1, 0, 1) on both sides, pushed by a smooth force.
CaseDescription pushed() {
  CaseDescription description = scene(0.5, 0);
  description.bodies[0].force_x = "t < 1 ? 0.5*sin(pi*t)^4 : 0";
  return description;
}

/// Mass 1 between gas (1, 0, 1) and (0.125, 0, 0.1).
CaseDescription released(double width) {
  CaseDescription description = scene(1, width);
  description.initial.kind = "regions";
  description.initial.regions = {{"x < 0", "1", "0", "0", "1"}, {"", "0.125", "0", "0", "0.1"}};
  return description;
}

double wall_pressure(const RigidPiston& solution, double side, double t) {
  const double x = (*solution.bodies(t))[0].pose.position[0];
  return solution.state(Point<1>(x + side * 1e-13), t).pressure;
}

void expect_history(const CaseDescription& description, const std::string& file) {
  const RigidPiston solution(description);
  for (const auto& row : testing::reference_table(file)) {
    const double t = number(row, "t");
    if (t > solution.valid_until()) continue;
    const ExactMotion<1> motion = (*solution.bodies(t))[0];
    EXPECT_NEAR(motion.pose.position[0], number(row, "x_b"), 1e-11) << t;
    EXPECT_NEAR(motion.velocity[0], number(row, "v_b"), 1e-11) << t;
    EXPECT_NEAR(wall_pressure(solution, -1, t), number(row, "p_L"), 1e-10) << t;
    EXPECT_NEAR(wall_pressure(solution, 1, t), number(row, "p_R"), 1e-10) << t;
  }
}

void expect_profile(const CaseDescription& description, const std::string& file) {
  const RigidPiston solution(description);
  for (const auto& row : testing::reference_table(file)) {
    const double x = number(row, "x");
    const Primitive<1> W = solution.state(Point<1>(x), 0.8);
    EXPECT_NEAR(W.density, number(row, "rho"), 1e-9) << x;
    EXPECT_NEAR(W.velocity[0], number(row, "v"), 1e-9) << x;
    EXPECT_NEAR(W.pressure, number(row, "p"), 1e-9) << x;
  }
}

TEST(RigidPiston, PushedPistonFollowsTheReferenceHistory) { expect_history(pushed(), "rigid_piston_1_body.csv"); }
TEST(RigidPiston, PushedPistonGivesTheReferenceProfile) { expect_profile(pushed(), "rigid_piston_1_fluid_t0.8.csv"); }
TEST(RigidPiston, ReleasedPistonFollowsTheReferenceHistory) { expect_history(released(0), "rigid_piston_4_body.csv"); }
TEST(RigidPiston, ReleasedPistonGivesTheReferenceProfile) {
  expect_profile(released(0), "rigid_piston_4_fluid_t0.8.csv");
}

TEST(RigidPiston, WidthMovesTheGasAside) {
  const RigidPiston thin(released(0)), thick(released(0.3));
  const double t = 0.5;
  EXPECT_EQ((*thin.bodies(t))[0].pose.position, (*thick.bodies(t))[0].pose.position);
  for (const double x : {0.2, 0.4, 0.6}) {
    EXPECT_NEAR(thick.state(Point<1>(x + 0.15), t).pressure, thin.state(Point<1>(x), t).pressure, 1e-13);
    EXPECT_NEAR(thick.state(Point<1>(-x - 0.15), t).pressure, thin.state(Point<1>(-x), t).pressure, 1e-13);
  }
}

TEST(RigidPiston, ShockFormsWhereTheFirstCharacteristicsCross) {
  // v'(0) = 0.9 into gas with c = √1.12 at rest: t = 2c/((γ+1) v'(0)), the earliest crossing.
  CaseDescription description = released(0);
  description.time_end = 3;
  const RigidPiston solution(description);
  EXPECT_NEAR(solution.valid_until(), 2 * std::sqrt(1.12) / (2.4 * 0.9), 1e-6);
  EXPECT_EQ(RigidPiston(pushed()).valid_until(), 0.9);
}

TEST(RigidPiston, MasslessPistonBalancesTheForcesAtAllTimes) {
  CaseDescription description = pushed();
  description.bodies[0].mass = 0;
  const RigidPiston solution(description);
  const double c = std::sqrt(1.4);
  for (const double t : {0.05, 0.33, 0.5, 0.71}) {
    const double force = 0.5 * std::pow(std::sin(pi * t), 4);
    EXPECT_NEAR(wall_pressure(solution, 1, t) - wall_pressure(solution, -1, t), force, 1e-11) << t;
    const double v = (*solution.bodies(t))[0].velocity[0];
    EXPECT_NEAR(std::pow(1 + 0.2 * v / c, 7) - std::pow(1 - 0.2 * v / c, 7), force, 1e-11) << t;
  }
  // x = ∫ v: Simpson's rule on the algebraic velocity.
  double sum = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double weight = k == 0 || k == 1000 ? 1 : (k % 2 == 1 ? 4 : 2);
    sum += weight * (*solution.bodies(0.7 * k / 1000))[0].velocity[0];
  }
  EXPECT_NEAR((*solution.bodies(0.7))[0].pose.position[0], sum * 0.7 / 3000, 1e-11);
}

TEST(RigidPiston, MassTendsToZeroContinuously) {
  CaseDescription light = pushed(), massless = pushed();
  massless.bodies[0].mass = 0;
  const RigidPiston limit(massless);
  double previous = 1;
  for (const double mass : {1e-2, 1e-4, 1e-6, 1e-8}) {
    light.bodies[0].mass = mass;
    const double gap = std::abs((*RigidPiston(light).bodies(0.3))[0].velocity[0] - (*limit.bodies(0.3))[0].velocity[0]);
    EXPECT_LT(gap, 2 * mass);
    EXPECT_LT(gap, previous);
    previous = gap;
  }
}

TEST(RigidPiston, PrescribedMotionIsTheRecedingPistonOfTheTextbook) {
  CaseDescription description = scene(0, 0);
  description.bodies[0].mass.reset();
  description.bodies[0].shape = "half_space";
  description.bodies[0].side = "left";
  description.bodies[0].motion_x = "-t^4/4";
  description.initial.state = {0.1, 0, 0, 1 / 14.0};
  const RigidPiston solution(description);
  const double t = 0.7;
  for (const double tau : {0.01, 0.2, 0.5, 0.69}) {
    const double v = -tau * tau * tau, a = 1 + 0.2 * v;
    const Primitive<1> W = solution.state(Point<1>(-std::pow(tau, 4) / 4 + (1 + 1.2 * v) * (t - tau)), t);
    EXPECT_NEAR(W.velocity[0], v, 1e-11) << tau;
    EXPECT_NEAR(W.density, 0.1 * std::pow(a, 5), 1e-12) << tau;
    EXPECT_NEAR(W.pressure, std::pow(a, 7) / 14, 1e-12) << tau;
  }
  EXPECT_EQ(solution.state(Point<1>(0.71), t).density, 0.1);
  EXPECT_NEAR((*solution.bodies(t))[0].velocity[0], -0.343, 1e-12);
  EXPECT_EQ(solution.valid_until(), 0.9);
}

TEST(RigidPiston, HalfSpaceReleasedFromRestIsDrivenByItsGas) {
  // m v' = −p for gas on the right: dv/(1 + αv)^7 = −(p/m) dt, α = (γ−1)/2c, has a closed form.
  CaseDescription description = scene(2, 0);
  description.bodies[0].shape = "half_space";
  description.bodies[0].side = "left";
  description.initial.state = {1.4, 0, 0, 1};
  const RigidPiston solution(description);
  for (const double t : {0.1, 0.5, 0.9})
    EXPECT_NEAR((*solution.bodies(t))[0].velocity[0], (std::pow(1 + 6 * 0.2 * 0.5 * t, -1.0 / 6) - 1) / 0.2, 1e-12)
        << t;
  description.bodies[0].side = "right";
  EXPECT_NEAR((*RigidPiston(description).bodies(0.5))[0].velocity[0], -(*solution.bodies(0.5))[0].velocity[0], 1e-14);
  description.initial.state[3] = -4;  // stiffened gas with p + p∞ = 1: the force is the physical pressure, −4
  description.p_inf = 5;
  EXPECT_NEAR((*RigidPiston(description).bodies(0.01))[0].velocity[0], -0.02, 1e-3);
}

TEST(RigidPiston, GravityIsAForceOnThePiston) {
  CaseDescription heavy = scene(0.5, 0), pushed_by_force = heavy;
  heavy.gravity = {-0.6, 0};
  pushed_by_force.bodies[0].force_x = "-0.3";
  const double v = (*RigidPiston(heavy).bodies(0.4))[0].velocity[0];
  EXPECT_LT(v, -0.05);
  EXPECT_NEAR(v, (*RigidPiston(pushed_by_force).bodies(0.4))[0].velocity[0], 1e-14);
}

TEST(RigidPiston, PulledAwayAtOnceSendsACentredFan) {
  PistonProblem problem;
  problem.right = Primitive<1>{1, {0}, 1};
  problem.mass = 1;
  problem.velocity = -0.8;
  problem.force = [](double) { return std::pow(1 - 0.2 * 0.8 / std::sqrt(1.4), 7); };  // keeps the velocity
  const RigidPiston solution(problem, 0);
  const Primitive<1> image{1, {-1.6}, 1}, gas{1, {0}, 1};
  for (const double xi : {-0.79, -0.3, 0.3, 0.9, 1.17, 1.19}) {
    const Primitive<1> W = solution.state(Point<1>(0.6 * xi), 0.6), expected = sample(image, gas, 1.4, xi);
    EXPECT_NEAR(W.pressure, expected.pressure, 1e-12) << xi;
    EXPECT_NEAR(W.velocity[0], expected.velocity[0], 1e-12) << xi;
  }
  EXPECT_EQ(solution.valid_until(), 1);
  problem.velocity = 0.8;
  EXPECT_EQ(RigidPiston(problem, 0).valid_until(), 0);
}

TEST(RigidPiston, RejectsOtherScenes) {
  CaseDescription description = pushed();
  description.bodies[0].shape = "circle";
  EXPECT_THROW(RigidPiston{description}, InputError);
  description = pushed();
  description.bodies[0].mass.reset();
  EXPECT_THROW(RigidPiston{description}, InputError);
  description = pushed();
  description.bodies.push_back(description.bodies[0]);
  EXPECT_THROW(RigidPiston{description}, InputError);
}

}  // namespace
}  // namespace mortise
