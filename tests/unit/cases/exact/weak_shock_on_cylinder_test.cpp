#include "mortise/cases/exact/weak_shock_on_cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mortise/fluid/shock.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription weak_shock(double mach) {
  const Primitive<2> ahead{1.4, {0, 0}, 1};
  const Primitive<2> behind = behind_shock(ahead, mach, 1.4);
  CaseDescription description;
  description.initial.kind = "shock";
  description.initial.left = {behind.density, behind.velocity[0], 0, behind.pressure};
  description.initial.right = {1.4, 0, 0, 1};
  description.initial.position = -1;
  BodyDescription cylinder;
  cylinder.shape = "circle";
  cylinder.radius = 0.5;
  cylinder.position = {0.25, 0.1};
  cylinder.mass = 0;
  description.bodies = {cylinder};
  return description;
}

TEST(WeakShockOnCylinder, MovesByTheAcousticTheoryAfterFirstTouch) {
  const double mach = 1.0005;
  const CaseDescription description = weak_shock(mach);
  const WeakShockOnCylinder solution(description);
  EXPECT_NEAR(solution.first_touch(), 0.75 / mach, 1e-10);
  EXPECT_EQ((*solution.bodies(0.7))[0].velocity[0], 0);
  const double strength = (description.initial.left[3] - 1) / 1.4;
  const ExactMotion<2> motion = (*solution.bodies(solution.first_touch() + 1))[0];  // ct/a = 2
  EXPECT_NEAR(motion.velocity[0] / strength, 1.72894, 1e-5);
  EXPECT_NEAR(motion.velocity[1], 0, 1e-15);
  EXPECT_EQ(motion.pose.position[1], 0.1);
  EXPECT_GT(motion.pose.position[0], 0.25 + 0.5 * strength * 1.44808);
  EXPECT_LT(motion.pose.position[0], 0.25 + strength * 1.72894);
  EXPECT_FALSE(solution.describes_fluid());
  EXPECT_THROW(solution.state(Point<2>(0, 0), 0), std::logic_error);
}

TEST(WeakShockOnCylinder, MassIsDensityTimesArea) {
  CaseDescription by_mass = weak_shock(1.001), by_density = by_mass;
  by_mass.bodies[0].mass = 14 * std::acos(-1.0) * 0.25;
  by_density.bodies[0].mass.reset();
  by_density.bodies[0].density = 14;
  const double v = (*WeakShockOnCylinder(by_density).bodies(1.3))[0].velocity[0];
  EXPECT_NEAR((*WeakShockOnCylinder(by_mass).bodies(1.3))[0].velocity[0], v, 1e-15);
  EXPECT_LT(v, 0.2 * (*WeakShockOnCylinder(weak_shock(1.001)).bodies(1.3))[0].velocity[0]);
}

TEST(WeakShockOnCylinder, RejectsOtherScenes) {
  CaseDescription description = weak_shock(1.001);
  description.initial.position = 2;
  EXPECT_THROW(WeakShockOnCylinder{description}, InputError);
  description = weak_shock(1.001);
  description.bodies[0].velocity = {0.2, 0};
  EXPECT_THROW(WeakShockOnCylinder{description}, InputError);
  description = weak_shock(1.001);
  description.bodies.clear();
  EXPECT_THROW(WeakShockOnCylinder{description}, InputError);
}

}  // namespace
}  // namespace mortise
