#include "mortise/cases/exact/plane_riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/fluid/shock.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription sod() {
  CaseDescription description;
  description.exact = "riemann";
  description.initial.kind = "riemann";
  description.initial.left = {1, 0, 0, 1};
  description.initial.right = {0.125, 0, 0, 0.1};
  description.initial.position = 0.5;
  return description;
}

TEST(PlaneRiemann, Sod) {
  const PlaneRiemann<1> solution(sod());
  EXPECT_EQ(solution.state(Point<1>(0.49), 0).density, 1);
  EXPECT_EQ(solution.state(Point<1>(0.51), 0).density, 0.125);
  const Primitive<1> star = solution.state(Point<1>(0.5 + 0.9 * 0.25), 0.25);
  EXPECT_NEAR(star.density, 0.42631942817849516, 1e-15);
  EXPECT_NEAR(star.velocity[0], 0.92745262004894991, 1e-15);
  EXPECT_NEAR(star.pressure, 0.30313017805064679, 1e-15);
}

TEST(PlaneRiemann, TurnedIsTheSameAlongItsNormalAndKeepsTheTangentialVelocity) {
  CaseDescription turned = sod();
  turned.initial.angle = 30;
  const double c = std::sqrt(0.75), s = 0.5;
  turned.initial.left = {1, -s * 2, c * 2, 1};  // slip along the diaphragm: +2 left, −3 right
  turned.initial.right = {0.125, s * 3, -c * 3, 0.1};
  const PlaneRiemann<2> solution(turned);
  const PlaneRiemann<1> line(sod());
  for (const double xi : {-2.0, -0.5, 0.9, 1.0, 1.7, 2.0}) {
    const double r = 0.25 * xi, along = 0.7;
    const Primitive<2> W = solution.state(Point<2>((0.5 + r) * c - along * s, (0.5 + r) * s + along * c), 0.25);
    const Primitive<1> expected = line.state(Point<1>(0.5 + r), 0.25);
    EXPECT_NEAR(W.density, expected.density, 1e-14) << xi;
    EXPECT_NEAR(W.pressure, expected.pressure, 1e-14) << xi;
    EXPECT_NEAR(c * W.velocity[0] + s * W.velocity[1], expected.velocity[0], 1e-14) << xi;
    EXPECT_NEAR(-s * W.velocity[0] + c * W.velocity[1], xi < 0.9274 ? 2 : -3, 1e-14) << xi;
  }
}

TEST(PlaneRiemann, ObliqueTravellingShockMovesUnchanged) {
  const std::array<double, 2> n{0.6, 0.8};
  const Primitive<2> ahead{1.4, {0.1, -0.2}, 1};
  const Primitive<2> behind = behind_shock(ahead, 3, 1.4, n);
  CaseDescription description;
  description.initial.kind = "shock";
  description.initial.left = {behind.density, behind.velocity[0], behind.velocity[1], behind.pressure};
  description.initial.right = {ahead.density, ahead.velocity[0], ahead.velocity[1], ahead.pressure};
  description.initial.angle = std::atan2(0.8, 0.6) * 180 / std::acos(-1.0);
  const PlaneRiemann<2> solution(description);
  const double t = 0.7, front = shock_speed(ahead, 3, 1.4, n) * t;
  for (const double s : {-5.0, 0.0, front - 1e-6}) {
    const Primitive<2> W = solution.state(s * Point<2>(0.6, 0.8) + Point<2>(-0.8, 0.6), t);
    EXPECT_NEAR(W.pressure, behind.pressure, 1e-12) << s;
    EXPECT_NEAR(W.density, behind.density, 1e-12) << s;
    EXPECT_NEAR(W.velocity[1], behind.velocity[1], 1e-12) << s;
  }
  EXPECT_NEAR(solution.state((front + 1e-6) * Point<2>(0.6, 0.8), t).pressure, 1, 1e-12);
}

TEST(PlaneRiemann, StiffenedGasShiftsThePressure) {
  CaseDescription shifted = sod();
  shifted.p_inf = 7;
  shifted.initial.left[3] -= 7;
  shifted.initial.right[3] -= 7;
  const PlaneRiemann<1> solution(shifted), ideal(sod());
  const Point<1> x(0.6);
  EXPECT_NEAR(solution.state(x, 0.25).pressure, ideal.state(x, 0.25).pressure - 7, 1e-14);
  EXPECT_NEAR(solution.state(x, 0.25).density, ideal.state(x, 0.25).density, 1e-14);
}

TEST(PlaneRiemann, RejectsStatesThatAreNotGas) {
  CaseDescription description = sod();
  description.initial.right[0] = 0;
  EXPECT_THROW(PlaneRiemann<1>{description}, InputError);
  description = sod();
  description.initial.left[3] = -1;
  EXPECT_THROW(PlaneRiemann<1>{description}, InputError);
  description = sod();
  description.initial.kind = "vortex";
  EXPECT_THROW(PlaneRiemann<1>{description}, InputError);
}

}  // namespace
}  // namespace mortise
