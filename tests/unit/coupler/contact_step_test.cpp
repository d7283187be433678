#include "mortise/coupler/contact_step.hpp"

#include <gtest/gtest.h>

#include "unit/coupler/wall_scene.hpp"

namespace mortise {
namespace {

using testing::acoustic;
using testing::ideal_gas;
using testing::line_face;
using Vector1 = BodyVector<1>;
using Vector3 = BodyVector<2>;

CoupledBody<1> slab(double x, double mass, double v, double dt, std::vector<WallFace<1>> faces = {}) {
  BodyStep<1> step{.name = "slab", .mass = Vector1(mass), .velocity = Vector1(v), .dt = dt};
  return {step, std::move(faces), Point<1>(x)};
}

template <int Dim>
GapSearch<Dim> found(std::vector<ContactPoint<Dim>> contacts) {
  return [contacts](double) { return contacts; };
}

TEST(ContactStep, WithoutContactsBodiesMoveAlone) {
  const auto free = slab(0, 0.2, 1, 0.1, {line_face(1, 1, 0, 1)});
  const BodyMotion<1> alone = advance_added_mass<1>(free.step, free.faces, ideal_gas());
  for (const GapSearch<1>& gaps : {GapSearch<1>(), found<1>({}), found<1>({{0, -1, Point<1>(1), Point<1>(9), 9}})}) {
    const ContactStep<1> step = advance_bodies<1>({free}, &advance_added_mass<1>, ideal_gas(), gaps, {});
    EXPECT_EQ(step.motions[0].velocity, alone.velocity);
    EXPECT_EQ(step.motions[0].pressure, alone.pressure);
    EXPECT_EQ(step.count, 0);
  }
}

TEST(ContactStep, AsksForGapsAsFarAsBodiesMove) {
  double asked = 0;
  const GapSearch<1> gaps = [&](double within) {
    asked = within;
    return std::vector<ContactPoint<1>>{};
  };
  advance_bodies<1>({slab(0, 1, 3, 0.1), slab(1, 1, -4, 0.1)}, &advance_added_mass<1>, acoustic(1), gaps,
                    {.distance = 0.25});
  EXPECT_GE(asked, 0.25 + 0.7);
  EXPECT_LE(asked, 0.25 + 0.81);
}

TEST(ContactStep, ImpactsKeepTheirRestitution) {
  for (const double restitution : {0.0, 0.4, 1.0}) {
    const ContactStep<1> step =
        advance_bodies<1>({slab(0, 2, 3, 0.1)}, &advance_added_mass<1>, acoustic(1),
                          found<1>({{0, -1, Point<1>(1), Point<1>(1), 0}}), {.restitution = restitution});
    EXPECT_NEAR(step.motions[0].velocity[0], -3 * restitution, 1e-14);
    EXPECT_NEAR(step.motions[0].mean[0], -3 * restitution, 1e-14);
    EXPECT_NEAR(step.impulse[0][0], -2 * 3 * (1 + restitution), 1e-13);
    EXPECT_EQ(step.count, 1);
  }
}

TEST(ContactStep, AShockPressesALightBodyAgainstAWallWithTheReflectedPressure) {
  // Behind a Mach 2 shock into (1, 0, 1); reflected from a rigid wall the pressure is exactly 15.
  const double density = 8.0 / 3, velocity = 1.479019945774904, pressure = 4.5;
  for (const double mass : {0.0, 1e-8, 1e-3, 1.0}) {
    const auto body = slab(0, mass, 0, 0.01, {line_face(-1, density, velocity, pressure)});
    const ContactStep<1> step = advance_bodies<1>({body}, &advance_added_mass<1>, ideal_gas(),
                                                  found<1>({{0, -1, Point<1>(1), Point<1>(1), 0}}), {});
    EXPECT_NEAR(step.motions[0].velocity[0], 0, 1e-12) << "mass " << mass;
    EXPECT_NEAR(step.motions[0].mean[0], 0, 1e-12) << "mass " << mass;
    EXPECT_NEAR(step.motions[0].pressure[0], 15, 1e-9) << "mass " << mass;
    EXPECT_NEAR(step.impulse[0][0], -15 * 0.01, 1e-11) << "mass " << mass;
  }
}

TEST(ContactStep, AContactForceDoesNotPull) {
  // The gas sucks the body off the wall it touches.
  const auto body = slab(0, 0.1, 0, 0.01, {line_face(-1, 1, -0.5, 1), line_face(1, 1, -0.5, 1)});
  const ContactStep<1> step = advance_bodies<1>({body}, &advance_added_mass<1>, ideal_gas(),
                                                found<1>({{0, -1, Point<1>(1), Point<1>(1), 0}}), {});
  EXPECT_LT(step.motions[0].velocity[0], -0.01);
  EXPECT_EQ(step.count, 0);
  EXPECT_EQ(step.impulse[0][0], 0);
}

TEST(ContactStep, MasslessBodyBetweenHeavyOnes) {
  for (const double restitution : {0.0, 1.0}) {
    const ContactStep<1> step =
        advance_bodies<1>({slab(-1, 1e3, 1, 0.01), slab(0, 0, 0, 0.01, {line_face(-1, 1, 0, 1), line_face(1, 1, 0, 1)}),
                           slab(1, 1e3, -1, 0.01)},
                          &advance_added_mass<1>, ideal_gas(),
                          found<1>({{0, 1, Point<1>(1), Point<1>(0), 0}, {1, 2, Point<1>(1), Point<1>(0), 0}}),
                          {.restitution = restitution});
    const double v = step.motions[0].velocity[0];
    EXPECT_NEAR(step.motions[1].velocity[0], 0, 1e-10);
    EXPECT_NEAR(step.motions[2].velocity[0], -v, 1e-10);
    EXPECT_LE(v, 1e-12);
    EXPECT_GE(v, -1 - 1e-12);
    EXPECT_LT(v, -0.9 * restitution + 1e-12);
  }
}

TEST(ContactStep, BooksOfMomentumCloseInThePlane) {
  std::vector<CoupledBody<2>> bodies;
  for (const double side : {-1.0, 1.0}) {
    BodyStep<2> step{.name = "stick", .mass = {0.3, 0.3, 0.02}, .velocity = {-2 * side, 0.3, side}};
    step.length = 0.2;
    step.dt = 0.02;
    step.external.fill(Vector3(0, -0.3, 0));
    bodies.push_back({step,
                      testing::polygon_faces(testing::capsule(0.4, 0.1, 12), testing::uniform(1, {1, 0.5}, 1)),
                      {0.5 * side, 0.1 * side}});
  }
  const std::vector<ContactPoint<2>> contacts{{0, 1, Point<2>(2, 1).normalized(), {0, 0.05}, 0.01}};
  const ContactStep<2> step = advance_bodies<2>(bodies, &advance_added_mass<2>, ideal_gas(), found<2>(contacts),
                                                {.restitution = 0.5, .distance = 0.02});
  EXPECT_EQ(step.count, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyStep<2>& body = bodies[i].step;
    const Vector3 gained = body.mass.cwiseProduct(step.motions[i].velocity - body.velocity);
    const Vector3 given = body.dt * (step.motions[i].force + body.external[0]) + step.impulse[i];
    EXPECT_LT((gained - given).norm(), 1e-14);
  }
  EXPECT_LT((step.impulse[0] + step.impulse[1]).head<2>().norm(), 1e-15);
}

TEST(ContactStep, APrescribedSqueezeIsReportedNotAmplified) {
  auto piston = slab(-1, 1, 1, 0.01);
  piston.step.held[0] = true;
  const ContactStep<1> step = advance_bodies<1>(
      {piston, slab(0, 1, 0, 0.01)}, &advance_added_mass<1>, acoustic(1),
      found<1>({{0, 1, Point<1>(1), Point<1>(0), 0}, {1, -1, Point<1>(1), Point<1>(1), 0}}), {.restitution = 0});
  EXPECT_EQ(step.unresolved.size(), 1u);
  EXPECT_EQ(step.motions[0].velocity[0], 1);
  EXPECT_LE(std::abs(step.motions[1].velocity[0]), 1 + 1e-12);
}

}  // namespace
}  // namespace mortise
