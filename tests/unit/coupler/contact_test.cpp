#include "mortise/coupler/contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "unit/coupler/number_in.hpp"

namespace mortise {
namespace {

using Vector1 = BodyVector<1>;
using Vector3 = BodyVector<2>;

ContactBody<1> slab(double x, double mass, double v) {
  return {Point<1>(x), Vector1(v), BodyMatrix<1>(mass > 0 ? 1 / mass : 0)};  // mass 0: held
}
ContactPoint<1> touching(int a, int b, double gap = 0) { return {a, b, Point<1>(1), Point<1>(0), gap}; }

std::vector<double> velocities_after(const std::vector<ContactBody<1>>& bodies, const ContactResult<1>& result) {
  std::vector<double> v;
  for (std::size_t i = 0; i < bodies.size(); ++i) v.push_back(bodies[i].velocity[0] + result.correction[i][0]);
  return v;
}

void expect_near(const std::vector<double>& values, const std::vector<double>& expected, double tolerance) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], tolerance) << "body " << i;
}

TEST(Contact, EqualMassesExchangeVelocities) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 2, 3), slab(1, 2, -1)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1)}, {.restitution = 1});
  expect_near(velocities_after(bodies, result), {-1, 3}, 1e-15);
  EXPECT_EQ(result.count, 1);
  EXPECT_NEAR(result.normal_impulse[0], 8, 1e-14);
  EXPECT_NEAR(result.impulse[0][0], -8, 1e-14);
  EXPECT_NEAR(result.impulse[1][0], 8, 1e-14);
}

TEST(Contact, PlasticBodiesMoveOnTogether) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, 3), slab(1, 2, 0)};
  expect_near(velocities_after(bodies, resolve_contacts<1>(bodies, {touching(0, 1)}, {.restitution = 0})), {1, 1},
              1e-15);
  // Restitution ½: separating velocity 1.5, same momentum.
  expect_near(velocities_after(bodies, resolve_contacts<1>(bodies, {touching(0, 1)}, {.restitution = 0.5})), {0, 1.5},
              1e-15);
}

TEST(Contact, WallsReflect) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 2, 3)};
  for (const double restitution : {0.0, 0.3, 1.0}) {
    const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, -1)}, {.restitution = restitution});
    expect_near(velocities_after(bodies, result), {-3 * restitution}, 1e-15);
  }
}

TEST(Contact, HeldBodiesHaveInfiniteMass) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 0, 2), slab(1, 5, 0)};  // a prescribed piston
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1)}, {.restitution = 1});
  expect_near(velocities_after(bodies, result), {2, 4}, 1e-15);
  EXPECT_EQ(result.correction[0][0], 0);
}

TEST(Contact, OnlyWhatTouchesOrWillTouch) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, 1), slab(1, 1, 0)};
  const ContactOptions options{.restitution = 1, .distance = 0.1, .dt = 0.2};
  const auto count = [&](double gap) { return resolve_contacts<1>(bodies, {touching(0, 1, gap)}, options).count; };
  EXPECT_EQ(count(-0.5), 1);
  EXPECT_EQ(count(0.1), 1);
  EXPECT_EQ(count(0.29), 1);  // would be 0.09 after dt
  EXPECT_EQ(count(0.31), 0);
  const std::vector<ContactBody<1>> separating{slab(-1, 1, 0), slab(1, 1, 1)};
  const ContactResult<1> result = resolve_contacts<1>(separating, {touching(0, 1)}, options);
  EXPECT_EQ(result.count, 0);
  EXPECT_TRUE(result.correction[0].isZero(0) && result.correction[1].isZero(0));
}

TEST(Contact, ChainOfThree) {
  // One impact at both contacts at once: separating velocities 1 (restitution) and 0, momentum and energy kept.
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, 1), slab(0, 1, 0), slab(1, 1, 0)};
  const std::vector<ContactPoint<1>> contacts{touching(0, 1), touching(1, 2)};
  const ContactResult<1> elastic = resolve_contacts<1>(bodies, contacts, {.restitution = 1});
  expect_near(velocities_after(bodies, elastic), {-1.0 / 3, 2.0 / 3, 2.0 / 3}, 1e-15);
  EXPECT_EQ(elastic.count, 2);
  const ContactResult<1> plastic = resolve_contacts<1>(bodies, contacts, {.restitution = 0});
  expect_near(velocities_after(bodies, plastic), {1.0 / 3, 1.0 / 3, 1.0 / 3}, 1e-15);
}

TEST(Contact, ASecondImpactFollowsWhereTheFirstLeavesBodiesApproaching) {
  // The third body flees at 0.1; simultaneous elastic impacts would let the second run into it.
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, 1), slab(0, 1, 0), slab(1, 1, 0.1)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1), touching(1, 2)}, {.restitution = 1});
  const std::vector<double> v = velocities_after(bodies, result);
  EXPECT_LE(v[0], v[1] + 1e-14);
  EXPECT_LE(v[1], v[2] + 1e-14);
  EXPECT_NEAR(v[0] + v[1] + v[2], 1.1, 1e-14);
  EXPECT_NEAR(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1.01, 1e-13);
}

TEST(Contact, ABodyPushedIntoAThirdOneTouchesIt) {
  // 1 and 2 are 0.05 apart and at rest; the impact sends 1 across the gap within dt.
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, 1), slab(0, 1, 0), slab(1, 1, 0)};
  const std::vector<ContactPoint<1>> contacts{touching(0, 1), touching(1, 2, 0.05)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, contacts, {.restitution = 0, .distance = 0, .dt = 0.2});
  expect_near(velocities_after(bodies, result), {1.0 / 3, 1.0 / 3, 1.0 / 3}, 1e-15);
}

TEST(Contact, AlmostMasslessBodyBetweenHeavyOnes) {
  for (const double light : {1e-3, 1e-9, 1e-15}) {
    const std::vector<ContactBody<1>> bodies{slab(-1, 1e3, 1), slab(0, light, 0.3), slab(1, 1e3, -2)};
    const std::vector<ContactPoint<1>> contacts{touching(0, 1), touching(1, 2)};
    const double momentum = 1e3 - 2e3 + light * 0.3, mass = 2e3 + light;
    const ContactResult<1> plastic = resolve_contacts<1>(bodies, contacts, {.restitution = 0});
    expect_near(velocities_after(bodies, plastic), {momentum / mass, momentum / mass, momentum / mass}, 1e-9);
    const ContactResult<1> elastic = resolve_contacts<1>(bodies, contacts, {.restitution = 1});
    const std::vector<double> v = velocities_after(bodies, elastic);
    for (const double value : v) EXPECT_LT(std::abs(value), 10) << "mass " << light;
    EXPECT_LE(v[0], v[1] + 1e-8);
    EXPECT_LE(v[1], v[2] + 1e-8);
    EXPECT_NEAR(1e3 * v[0] + light * v[1] + 1e3 * v[2], momentum, 1e-11);
  }
}

TEST(Contact, ABodyRattlingBetweenTwoWallsComesToRest) {
  // It touches both: impacts with any restitution would follow without end.
  const std::vector<ContactBody<1>> bodies{slab(0, 2, 3)};
  const std::vector<ContactPoint<1>> walls{{0, -1, Point<1>(1), Point<1>(1), 0},
                                           {0, -1, Point<1>(-1), Point<1>(-1), 0}};
  for (const double restitution : {0.5, 1.0})
    expect_near(velocities_after(bodies, resolve_contacts<1>(bodies, walls, {.restitution = restitution})), {0}, 1e-14);
}

TEST(Contact, ASqueezeByPrescribedMotionIsReported) {
  const std::vector<ContactBody<1>> bodies{slab(-1, 0, 1), slab(0, 1, 0)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1), touching(1, -1)}, {.restitution = 0});
  ASSERT_EQ(result.unresolved.size(), 1u);
  EXPECT_LE(std::abs(result.correction[1][0]), 1 + 1e-12);
}

// In the plane.

ContactBody<2> disc(const Point<2>& x, double mass, double inertia, const Vector3& y) {
  return {x, y, Vector3(1 / mass, 1 / mass, 1 / inertia).asDiagonal()};
}

TEST(Contact, CentralImpactInThePlane) {
  const Point<2> n = Point<2>(3, 4) / 5;
  const std::vector<ContactBody<2>> bodies{disc({0, 0}, 1, 1, {3, 4, 7}), disc(2 * n, 1, 1, {0, 0, -7})};
  const ContactResult<2> result = resolve_contacts<2>(bodies, {{0, 1, n, n, 0}}, {.restitution = 1});
  EXPECT_LT((bodies[0].velocity + result.correction[0] - Vector3(0, 0, 7)).norm(), 1e-14);
  EXPECT_LT((bodies[1].velocity + result.correction[1] - Vector3(3, 4, -7)).norm(), 1e-14);
}

TEST(Contact, EccentricImpactTurnsTheBody) {
  // Impulse J = 2 v/(1/m + r²/I) at the lever r.
  const double m = 2, I = 0.5, r = 0.75;
  const std::vector<ContactBody<2>> bodies{disc({0, 0}, m, I, {0, -1, 0})};
  const ContactResult<2> result = resolve_contacts<2>(bodies, {{0, -1, {0, -1}, {r, -0.1}, 0}}, {.restitution = 1});
  const double J = 2 / (1 / m + r * r / I);
  EXPECT_LT((result.correction[0] - Vector3(0, J / m, r * J / I)).norm(), 1e-15);
}

TEST(Contact, AModeThatCannotMoveIsNotPushed) {
  // A body with two ways to move, pressed along the third: no impulse helps, and none is made up of round-off.
  const Vector3 u(1, 0.7, 0.3), w(-0.2, 0.4, 1.1), e = u.cross(w);
  const Point<2> n = e.head<2>().normalized(), arm = e[2] / e.head<2>().norm() * Point<2>(n[1], -n[0]);
  const std::vector<ContactBody<2>> bodies{{{0, 0}, e, u * u.transpose() + w * w.transpose()}};
  const ContactResult<2> result = resolve_contacts<2>(bodies, {{0, -1, n, arm, 0}}, {.restitution = 1});
  EXPECT_LT(result.correction[0].norm(), 1e-12);
  EXPECT_LT(result.impulse[0].norm(), 1e-12);
  EXPECT_EQ(result.unresolved, std::vector<int>({0}));
}

struct Scene {
  std::vector<ContactBody<2>> bodies;
  std::vector<Vector3> mass;
  std::vector<ContactPoint<2>> contacts;
};

using testing::number_in;

Scene any_scene(bool walls) {
  Scene scene;
  const int count = *rc::gen::inRange(2, 6);
  for (int i = 0; i < count; ++i) {
    const double m = number_in(0.1, 10), inertia = m * number_in(0.01, 0.3);
    scene.bodies.push_back(
        disc({number_in(-1, 1), number_in(-1, 1)}, m, inertia, {number_in(-1, 1), number_in(-1, 1), number_in(-1, 1)}));
    scene.mass.emplace_back(m, m, inertia);
  }
  for (int c = *rc::gen::inRange(1, 6); c > 0; --c) {
    const int a = *rc::gen::inRange(0, count), b = walls && *rc::gen::arbitrary<bool>() ? -1 : (a + 1) % count;
    const double angle = number_in(0, 6.28);
    scene.contacts.push_back({a, b, {std::cos(angle), std::sin(angle)}, {number_in(-1, 1), number_in(-1, 1)}, 0});
  }
  return scene;
}

double normal_velocity(const Scene& scene, const ContactPoint<2>& contact, const std::vector<Vector3>& y) {
  const auto along = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return generalized_normal<2>(contact.normal, contact.point - scene.bodies[i].position).dot(y[i]);
  };
  return (contact.b < 0 ? 0 : along(contact.b)) - along(contact.a);
}

std::vector<Vector3> after(const Scene& scene, const ContactResult<2>& result) {
  std::vector<Vector3> y;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) y.push_back(scene.bodies[i].velocity + result.correction[i]);
  return y;
}

RC_GTEST_PROP(ContactProperty, ActionIsReaction, ()) {
  const Scene scene = any_scene(false);
  const ContactResult<2> result = resolve_contacts<2>(scene.bodies, scene.contacts, {.restitution = number_in(0, 1)});
  Vector3 momentum = Vector3::Zero(), impulse = Vector3::Zero();  // angular: about the origin
  double scale = 1;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Point<2>& x = scene.bodies[i].position;
    const Vector3 gained = scene.mass[i].cwiseProduct(result.correction[i]), &J = result.impulse[i];
    momentum += gained + Vector3(0, 0, x[0] * gained[1] - x[1] * gained[0]);
    impulse += J + Vector3(0, 0, x[0] * J[1] - x[1] * J[0]);
    scale = std::max({scale, gained.norm(), J.norm()});
  }
  const double tolerance = (scene.contacts.size() == 1 ? 1e-14 : 1e-12) * scale;
  RC_ASSERT(momentum.norm() <= tolerance);
  RC_ASSERT(impulse.norm() <= tolerance);
}

RC_GTEST_PROP(ContactProperty, NothingApproachesAndNoEnergyIsMade, ()) {
  const Scene scene = any_scene(true);
  const double restitution = number_in(0, 1);
  const ContactResult<2> result = resolve_contacts<2>(scene.bodies, scene.contacts, {.restitution = restitution});
  RC_ASSERT(result.unresolved.empty());
  const std::vector<Vector3> y = after(scene, result);
  double before = 0, energy = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    before += scene.bodies[i].velocity.dot(scene.mass[i].cwiseProduct(scene.bodies[i].velocity));
    energy += y[i].dot(scene.mass[i].cwiseProduct(y[i]));
  }
  RC_ASSERT(energy <= before * (1 + 1e-12));
  for (const ContactPoint<2>& contact : scene.contacts) RC_ASSERT(normal_velocity(scene, contact, y) >= -1e-11);
}

RC_GTEST_PROP(ContactProperty, OneContactFollowsNewtonsLaw, ()) {
  Scene scene = any_scene(true);
  scene.contacts.resize(1);
  const double restitution = number_in(0, 1);
  std::vector<Vector3> y;
  for (const ContactBody<2>& body : scene.bodies) y.push_back(body.velocity);
  const double approach = normal_velocity(scene, scene.contacts[0], y);
  y = after(scene, resolve_contacts<2>(scene.bodies, scene.contacts, {.restitution = restitution}));
  const double expected = approach < 0 ? -restitution * approach : approach;
  RC_ASSERT(std::abs(normal_velocity(scene, scene.contacts[0], y) - expected) < 1e-12);
}

RC_GTEST_PROP(ContactProperty, TheFrameDoesNotMatter, ()) {
  const Scene scene = any_scene(true);
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(number_in(0, 6)).toRotationMatrix();
  Scene turned = scene;
  for (ContactBody<2>& body : turned.bodies) {
    body.position = R * body.position;
    body.velocity.head<2>() = R * body.velocity.head<2>();
  }
  for (ContactPoint<2>& contact : turned.contacts) {
    contact.normal = R * contact.normal;
    contact.point = R * contact.point;
  }
  const ContactOptions plastic{.restitution = 0};  // one impact: unique velocities
  const std::vector<Vector3> y = after(scene, resolve_contacts<2>(scene.bodies, scene.contacts, plastic));
  const std::vector<Vector3> z = after(turned, resolve_contacts<2>(turned.bodies, turned.contacts, plastic));
  for (std::size_t i = 0; i < y.size(); ++i) {
    RC_ASSERT((z[i].head<2>() - R * y[i].head<2>()).norm() < 1e-10);
    RC_ASSERT(std::abs(z[i][2] - y[i][2]) < 1e-10);
  }
}

TEST(Contact, BodiesWithoutMassDoNotBounce) {
  ContactBody<1> light = slab(-1, 1, 1);
  light.inert = false;
  const std::vector<ContactBody<1>> bodies{light, slab(1, 0, 0)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1)}, {.restitution = 1});
  expect_near(velocities_after(bodies, result), {0, 0}, 1e-15);
}

// The contact points of circles are off by what a polygon is off a circle: a light one would be spun by that.
TEST(Contact, DoesNotTurnRoundBodies) {
  ContactBody<2> round;
  round.velocity = Vector3(1, 0, 0.5);
  round.inverse_mass = Vector3(1, 1, 1e8).asDiagonal();
  round.round = true;
  ContactPoint<2> wall;
  wall.normal = Point<2>(1, 0);
  wall.point = Point<2>(0.3, 1e-4);
  const ContactResult<2> result = resolve_contacts<2>({round}, {wall}, {.restitution = 1});
  EXPECT_NEAR(result.correction[0][0], -2, 1e-14);
  EXPECT_EQ(result.correction[0][2], 0);
}

TEST(Contact, OfAnImageActsOnTheBodyItself) {
  ContactBody<2> held, body;
  body.position = Point<2>(0.9, 0);
  body.velocity = Vector3(1, 0, 0);  // towards the image of the other one in the next period
  body.inverse_mass = Vector3(1, 1, 4).asDiagonal();
  held.position = Point<2>(-0.9, 0);
  ContactPoint<2> contact;
  contact.a = 0;
  contact.b = 1;
  contact.normal = Point<2>(-1, 0);
  contact.point = Point<2>(-1, 0.1);
  contact.shift = {-2, 0};
  const ContactResult<2> result = resolve_contacts<2>({held, body}, {contact}, {.restitution = 0});
  // e = (−1, 0, 0.1): λ = 1/(1 + 4·0.01), Δω = 4·0.1 λ
  EXPECT_NEAR(result.correction[1][0], -1 / 1.04, 1e-14);
  EXPECT_NEAR(result.correction[1][2], 0.4 / 1.04, 1e-14);
}

TEST(Contact, EndsOnVelocitiesThatAreNoNumbers) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<ContactBody<1>> bodies{slab(-1, 1, none), slab(0, 1, 0), slab(1, 1, -1)};
  const ContactResult<1> result = resolve_contacts<1>(bodies, {touching(0, 1), touching(1, 2)}, {.restitution = 1});
  EXPECT_EQ(result.correction.size(), 3u);
}

}  // namespace
}  // namespace mortise
