#include "mortise/solid/rigid_body.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(RigidBody, CountsItsDegreesOfFreedom) {
  EXPECT_EQ(degrees_of_freedom<1>, 1);
  EXPECT_EQ(degrees_of_freedom<2>, 3);
}

TEST(RigidBody, AdvancesWithTheMeanVelocity) {
  const Pose<2> plane = advanced<2>({{1, 2}, 0.5}, {4, -8, 16}, 0.25);
  EXPECT_EQ(plane, (Pose<2>{{2, 0}, 4.5}));
  const Pose<1> line = advanced<1>({Point<1>(1), 0}, Velocity<1>(3), 0.5);
  EXPECT_EQ(line, (Pose<1>{Point<1>(2.5), 0}));
}

TEST(RigidBody, PointsMoveWithTranslationAndRotation) {
  RigidBody<2> body;
  body.pose.position = {1, 1};
  body.y = {10, 20, 2};
  EXPECT_EQ(body.velocity_at({1, 1}), Point<2>(10, 20));
  EXPECT_EQ(body.velocity_at({4, 1}), Point<2>(10, 26));
  EXPECT_EQ(body.velocity_at({1, 4}), Point<2>(4, 20));
}

TEST(RigidBody, MassMatrixAndEnergy) {
  RigidBody<2> body{.name = "stick_0", .mass = 3, .inertia = 5};
  body.y = {1, 2, -2};
  EXPECT_EQ(body.mass_diagonal(), Velocity<2>(3, 3, 5));
  EXPECT_DOUBLE_EQ(body.kinetic_energy(), 0.5 * (3 * 5 + 5 * 4));
  const RigidBody<1> slab{.name = "slab", .mass = 2, .y = Velocity<1>(3)};
  EXPECT_EQ(slab.mass_diagonal(), Velocity<1>(2));
  EXPECT_DOUBLE_EQ(slab.kinetic_energy(), 9);
}

}  // namespace
}  // namespace mortise
