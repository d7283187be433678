#include "mortise/cases/exact/shock_on_massless_body.hpp"

#include <gtest/gtest.h>

#include "mortise/fluid/shock.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription scene() {
  const Primitive<1> behind = behind_shock(Primitive<1>{1, {0}, 1}, 2, 1.4);
  CaseDescription description;
  description.initial.kind = "shock";
  description.initial.left = {behind.density, behind.velocity[0], 0, behind.pressure};
  description.initial.right = {1, 0, 0, 1};
  description.initial.position = -0.5;
  BodyDescription slab;
  slab.shape = "slab";
  slab.width = 0.2;
  slab.position = {0.1, 0};
  slab.mass = 0;
  description.bodies = {slab};
  return description;
}

constexpr double shock_velocity = 2.366431913240, gas_velocity = 1.479019945775;

TEST(ShockOnMasslessBody, SlabTakesTheVelocityOfTheGasAtOnce) {
  const ShockOnMasslessBody solution(scene());
  const double arrival = 0.5 / shock_velocity;
  EXPECT_EQ((*solution.bodies(arrival - 1e-6))[0].pose.position[0], 0.1);
  EXPECT_NEAR((*solution.bodies(arrival + 1))[0].pose.position[0], 0.1 + gas_velocity, 1e-11);
  EXPECT_NEAR((*solution.bodies(arrival + 1))[0].velocity[0], gas_velocity, 1e-12);
}

TEST(ShockOnMasslessBody, ShockLeavesTheRightFaceWhenItMeetsTheLeftOne) {
  const ShockOnMasslessBody solution(scene());
  const auto pressure = [&](double x, double t) { return solution.state(Point<1>(x), t).pressure; };
  const double before = 0.4 / shock_velocity, after = 0.6 / shock_velocity;
  EXPECT_EQ(pressure(-0.1001, before), 4.5);
  EXPECT_EQ(pressure(-0.0999, before), 1);
  EXPECT_EQ(pressure(0.3, before), 1);
  EXPECT_EQ(pressure(-0.05, after), 4.5);
  EXPECT_EQ(pressure(0.2999, after), 4.5);  // 0.1 past the right face, which was at 0.2
  EXPECT_EQ(pressure(0.3001, after), 1);
}

TEST(ShockOnMasslessBody, MirroredSceneMirrorsTheAnswer) {
  CaseDescription mirrored = scene();
  std::swap(mirrored.initial.left, mirrored.initial.right);
  mirrored.initial.right[1] = -mirrored.initial.right[1];
  mirrored.initial.position = 0.5;
  mirrored.bodies[0].position[0] = -0.1;
  const ShockOnMasslessBody solution(scene()), image(mirrored);
  for (const double t : {0.1, 0.25, 0.4}) {
    EXPECT_NEAR((*image.bodies(t))[0].pose.position[0], -(*solution.bodies(t))[0].pose.position[0], 1e-14);
    for (const double x : {-0.3, -0.15, 0.05, 0.25, 0.45})
      EXPECT_EQ(image.state(Point<1>(-x), t).pressure, solution.state(Point<1>(x), t).pressure) << x << ' ' << t;
  }
}

TEST(ShockOnMasslessBody, RejectsOtherScenes) {
  CaseDescription description = scene();
  description.bodies[0].mass = 0.1;
  EXPECT_THROW(ShockOnMasslessBody{description}, InputError);
  description = scene();
  description.initial.left[3] = 4.4;
  EXPECT_THROW(ShockOnMasslessBody{description}, InputError);
}

}  // namespace
}  // namespace mortise
