#include "mortise/coupler/added_mass.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>

#include "mortise/grids/core/error.hpp"
#include "unit/coupler/number_in.hpp"
#include "unit/coupler/wall_scene.hpp"

namespace mortise {
namespace {

using testing::acoustic;
using testing::advance;
using testing::ideal_gas;
using testing::line_face;
using testing::number_in;
using Vector3 = BodyVector<2>;
using Matrix3 = BodyMatrix<2>;
using Faces = std::vector<WallFace<2>>;

Matrix3 tensor(const std::vector<Point<2>>& vertices) {
  const Faces faces = testing::polygon_faces(vertices, testing::uniform(1, {0, 0}, 1));
  return added_mass_tensor<2>(faces, std::vector<double>(faces.size(), 1.0));
}

Matrix3 blocks(double a11, double a12, double a22, double rotation) {
  Matrix3 A = Matrix3::Zero();
  A << a11, a12, 0, a12, a22, 0, 0, 0, rotation;
  return A;
}

TEST(AddedMassTensor, IsExactForRectangles) {
  const double a = 0.3, b = 0.5;
  // The face centres integrate (r × n)² with the midpoint rule: error −length³/(12 n²) per side.
  const auto rotation = [&](int n) { return 4 * (a * a * a + b * b * b) / 3 * (1 - 1.0 / (n * n)); };
  for (const int n : {4, 16})
    EXPECT_TRUE(tensor(testing::rectangle(2 * a, 2 * b, n)).isApprox(blocks(4 * b, 0, 4 * a, rotation(n)), 1e-13));
}

void expect_second_order(const std::function<Matrix3(int)>& at, const Matrix3& exact) {
  const double coarse = (at(64) - exact).cwiseAbs().maxCoeff(), fine = (at(128) - exact).cwiseAbs().maxCoeff();
  EXPECT_LT(fine, 3e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
}

TEST(AddedMassTensor, ConvergesWithSecondOrder) {
  const double pi = std::numbers::pi, a = 0.4, l = 0.5, r = 0.2;
  expect_second_order([&](int n) { return tensor(testing::ellipse(a, a, 0, n)); }, blocks(pi * a, 0, pi * a, 0));
  expect_second_order([&](int n) { return tensor(testing::capsule(l, r, n / 4)); },
                      blocks(pi * r, 0, pi * r + 4 * l, 4 * l * l * l / 3 + pi * l * l * r));
  const Matrix3 reference = blocks(1.695478, -0.813049, 1.695478, 0.199197);
  EXPECT_LT((tensor(testing::ellipse(0.7, 0.35, pi / 4, 16384)) - reference).cwiseAbs().maxCoeff(), 6e-7);
  expect_second_order([&](int n) { return tensor(testing::ellipse(0.7, 0.35, pi / 4, n)); },
                      tensor(testing::ellipse(0.7, 0.35, pi / 4, 16384)));
}

TEST(AddedMassTensor, OfACircleHasNoRotation) {
  const Matrix3 A = tensor(testing::ellipse(0.4, 0.4, 0, 100));
  EXPECT_LT(A.row(2).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(AddedMass, MasslessPistonBalancesItsForces) {
  // 0 = −(p + z (v − u)) + f at the end of the step.
  BodyStep<1> step{.name = "piston", .dt = 0.1};
  step.external.fill(BodyVector<1>(3));
  const BodyMotion<1> motion = advance<1>(step, {line_face(1, 1, 0.5, 1)}, acoustic(4));
  EXPECT_NEAR(motion.velocity[0], 0.5 + (3 - 1) / 4.0, 1e-15);
  EXPECT_NEAR(motion.mean[0], 1, 1e-15);
  EXPECT_NEAR(motion.pressure[0], 3, 1e-14);
  EXPECT_NEAR(motion.force[0], -3, 1e-14);
  EXPECT_DOUBLE_EQ(motion.added_mass(0, 0), 4);
}

TEST(AddedMass, MasslessBodyMovesWithAUniformStream) {
  // Any closed outline, any Mach number: all pressures balance when the body does not disturb the gas.
  const Faces faces = testing::polygon_faces(testing::capsule(0.5, 0.1, 10), testing::uniform(1.2, {7, -3}, 0.8));
  const BodyStep<2> step{.name = "stick", .length = 0.2, .dt = 0.01};
  const BodyMotion<2> motion = advance<2>(step, faces, ideal_gas());
  EXPECT_LT((motion.velocity - Vector3(7, -3, 0)).norm(), 1e-12);
  EXPECT_LT(motion.force.norm(), 1e-13);
}

TEST(AddedMass, MomentumIsExchangedToRoundOff) {
  for (const double mass : {1e-6, 0.3, 1e4}) {
    Faces faces = testing::polygon_faces(testing::ellipse(0.7, 0.35, 0.3, 80), [](const Point<2>& x) {
      return testing::GasState{1 + 0.2 * x[0], {1.5, x[0] - 0.4}, 1 + 0.7 * x[1] + 0.3 * x[0]};
    });
    for (WallFace<2>& face : faces) face.pressure_half *= 1.1;
    BodyStep<2> step{.name = "ellipse", .mass = {mass, mass, 0.1 * mass}, .velocity = {0.2, 0.1, -0.5}};
    step.length = 0.5;
    step.dt = 0.05;
    step.p_inf = 0.25;
    step.external = {Vector3(1, 2, 3), Vector3(-1, 0.5, 2)};
    const BodyMotion<2> motion = advance<2>(step, faces, ideal_gas());
    Vector3 force = (1 - sdirk2_gamma) * step.external[0] + sdirk2_gamma * step.external[1];
    for (std::size_t i = 0; i < faces.size(); ++i)
      force -=
          (motion.pressure[i] - step.p_inf) * faces[i].measure * generalized_normal<2>(faces[i].normal, faces[i].arm);
    const Vector3 gained = step.mass.cwiseProduct(motion.velocity - step.velocity);
    EXPECT_LT((gained - step.dt * force).norm(), 2e-14 + 1e-15 * mass) << "mass " << mass;
    EXPECT_LT(motion.iterations, 14);
  }
}

TEST(AddedMass, ModeWithoutMassAndAddedMassKeepsItsVelocity) {
  for (const double mass : {0.0, 1.0}) {
    const Faces faces = testing::polygon_faces(testing::ellipse(0.3, 0.3, 0, 60), testing::uniform(1, {1, 0}, 1));
    const BodyStep<2> step{.name = "circle", .mass = {mass, mass, 0}, .velocity = {0, 0, 5}, .length = 0.3, .dt = 0.02};
    const BodyMotion<2> motion = advance<2>(step, faces, ideal_gas());
    EXPECT_NEAR(motion.velocity[2], 5, 1e-12);
    EXPECT_NEAR(motion.mean[2], 5, 1e-12);
    EXPECT_GT(motion.velocity[0], 0.01);
  }
}

TEST(AddedMass, BodyWithoutInertiaTurnsWithTheGasHoweverHeavy) {
  const Faces faces = testing::polygon_faces(testing::rectangle(0.06, 1, 20), [](const Point<2>& x) {
    return testing::GasState{1, {-0.1 * x[1], 0.1 * x[0]}, 1};
  });
  for (const double mass : {0.0, 1.0, 1e9}) {
    const BodyStep<2> step{.name = "stick", .mass = {mass, mass, 0}, .length = 0.14, .dt = 1e-3};
    EXPECT_NEAR(advance<2>(step, faces, ideal_gas()).velocity[2], 0.1, 1e-12) << "mass " << mass;
  }
}

TEST(AddedMass, HeldDegreesAreLeftAlone) {
  const Faces faces = testing::polygon_faces(testing::ellipse(0.7, 0.35, 0.5, 60), [](const Point<2>& x) {
    return testing::GasState{1, {1, 0}, 1 + 0.5 * x[0] * x[1]};
  });
  BodyStep<2> step{
      .name = "ellipse", .velocity = {0.25, -0.5, 0}, .held = {true, true, false}, .length = 0.5, .dt = 0.1};
  const BodyMotion<2> pivot = advance<2>(step, faces, acoustic(1));
  EXPECT_EQ(pivot.velocity.head<2>(), Point<2>(0.25, -0.5));
  EXPECT_EQ(pivot.mean.head<2>(), Point<2>(0.25, -0.5));
  EXPECT_TRUE(pivot.response.topRows<2>().isZero(0));
  EXPECT_LT(std::abs(pivot.force[2]), 1e-13);  // free and massless: no torque is left
  step.held = {true, true, true};
  step.velocity.setZero();
  const BodyMotion<2> fixed = advance<2>(step, faces, acoustic(1));
  EXPECT_TRUE(fixed.velocity.isZero(0));
  EXPECT_GT(std::abs(fixed.force[2]), 1e-3);
}

TEST(AddedMass, ExtrapolatedDataWithoutPressureFallBackToHalfTime) {
  WallFace<1> face = line_face(1, 1, 0, 1);
  face.pressure0 = 4;  // would extrapolate to −2 at t + Δt
  BodyStep<1> step{.name = "piston", .dt = 0.1};
  step.external.fill(BodyVector<1>(3));
  EXPECT_NEAR(advance<1>(step, {face}, acoustic(2)).velocity[0], (3 - 1) / 2.0, 1e-14);
  face.pressure0 = 1.5;  // extrapolates to 0.5
  EXPECT_NEAR(advance<1>(step, {face}, acoustic(2)).velocity[0], (3 - 0.5) / 2.0, 1e-14);
}

TEST(AddedMass, StrongShocksAndVacuaConverge) {
  // A massless piston with a driving force of 1e-4 … 1e6 times the gas pressure, and Mach 20 streams both ways.
  for (const double force : {1e-4, 1.0, 1e6})
    for (const double stream : {-24.0, 0.0, 24.0}) {
      BodyStep<1> step{.name = "piston", .dt = 0.01};
      step.external.fill(BodyVector<1>(force));
      const BodyMotion<1> motion = advance<1>(step, {line_face(1, 1, stream, 1)}, ideal_gas());
      EXPECT_NEAR(motion.pressure[0], force, 1e-9 * (force + 1)) << force << " " << stream;
      EXPECT_LT(motion.iterations, 50);
    }
  // A heavy body leaving the gas at five times the escape speed feels nothing.
  const BodyStep<1> step{.name = "piston", .mass = BodyVector<1>(1), .velocity = BodyVector<1>(-30), .dt = 0.01};
  EXPECT_EQ(advance<1>(step, {line_face(1, 1, 0, 1)}, ideal_gas()).force[0], 0);
}

TEST(AddedMass, FarApartGasesAreBridged) {
  // Full Newton steps cycle between the vacuum of one side and the shock of the other: the step must be damped.
  const BodyStep<1> step{.name = "diaphragm", .dt = 0.25};
  const BodyMotion<1> motion = advance<1>(
      step, {line_face(-1, 52.1163, -14.7007, 4.12317), line_face(1, 0.0088417, -16.7098, 0.0109049)}, ideal_gas());
  EXPECT_NEAR(motion.pressure[0], motion.pressure[1], 1e-12);
  EXPECT_GT(motion.pressure[0], 0.0109049);
}

TEST(AddedMass, ImpossibleBalanceIsANumericalError) {
  BodyStep<1> step{.name = "kite", .dt = 0.1};
  step.external.fill(BodyVector<1>(-1));  // away from the gas, no mass: no velocity balances it
  try {
    advance<1>(step, {line_face(1, 1, 0, 1)}, ideal_gas());
    FAIL();
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("kite"), std::string::npos);
  }
  step.external.fill(BodyVector<1>(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_THROW(advance<1>(step, {line_face(1, 1, 0, 1)}, ideal_gas()), NumericalError);
}

TEST(AddedMass, ResponseIsTheSlopeOfTheVelocity) {
  const Faces faces = testing::polygon_faces(testing::ellipse(0.7, 0.35, 0.3, 40), testing::uniform(1, {0.3, 0.2}, 1));
  for (const double mass : {0.0, 0.01, 10.0}) {
    BodyStep<2> step{.name = "ellipse", .mass = {mass, mass, 0.2 * mass}, .length = 0.5, .dt = 0.05};
    const BodyMotion<2> motion = advance<2>(step, faces, acoustic(1.3));
    EXPECT_LT((motion.response - motion.response.transpose()).norm(), 1e-14 * motion.response.norm());
    for (int k = 0; k < 3; ++k) {
      BodyStep<2> pushed = step;
      for (Vector3& force : pushed.external) force[k] += 1;
      const Vector3 change = advance<2>(pushed, faces, acoustic(1.3)).velocity - motion.velocity;
      EXPECT_LT((change - step.dt * motion.response.col(k)).norm(), 1e-12 * (1 + change.norm()));
    }
  }
}

TEST(Traditional, IsExplicitAndLagged) {
  const double m = 0.5, z = 3, dt = 0.1;
  const BodyStep<1> step{
      .name = "piston", .mass = BodyVector<1>(m), .velocity = BodyVector<1>(2), .dt = dt, .p_inf = 1};
  const std::vector<WallFace<1>> faces{line_face(1, 1, 0, 1)};
  const BodyMotion<1> motion = advance_traditional<1>(step, faces, acoustic(z));
  EXPECT_DOUBLE_EQ(motion.velocity[0], 2 * (1 - z * dt / m));
  EXPECT_DOUBLE_EQ(motion.mean[0], 2);
  EXPECT_DOUBLE_EQ(motion.pressure[0], 1 + z * 2);
}

TEST(Traditional, NeedsMass) {
  BodyStep<2> step{.name = "feather", .mass = {1, 1, 0}, .dt = 0.1};
  EXPECT_FALSE(traditional_possible(step));
  EXPECT_THROW(advance_traditional<2>(step, {}, acoustic(1)), InputError);
  step.held = {false, false, true};
  EXPECT_TRUE(traditional_possible(step));
  EXPECT_NO_THROW(advance_traditional<2>(step, {}, acoustic(1)));
}

// Properties.

Faces any_faces() {
  const double slope = number_in(-0.5, 0.5), turn = number_in(-0.5, 0.5);
  const Point<2> stream(number_in(-2, 2), number_in(-2, 2));
  const double long_axis = number_in(0.2, 1), short_axis = long_axis * number_in(0.1, 0.9);  // not a circle: A22 > 0
  return testing::polygon_faces(
      testing::ellipse(long_axis, short_axis, number_in(0, 3), *rc::gen::inRange(5, 40)), [&](const Point<2>& x) {
        return testing::GasState{1 + slope * x[0], stream + turn * Point<2>(-x[1], x[0]), 1 + 0.9 * slope * x[1]};
      });
}

BodyStep<2> any_step() {
  const double mass = *rc::gen::element(0.0, 1e-8, 1e-3, 1.0, 1e3);
  BodyStep<2> step{.name = "body", .mass = {mass, mass, 0.1 * mass}};
  step.velocity = {number_in(-1, 1), number_in(-1, 1), number_in(-1, 1)};
  step.length = 0.3;
  step.dt = number_in(1e-3, 0.1);
  return step;
}

RC_GTEST_PROP(AddedMassProperty, TensorIsSymmetricAndPositiveSemidefinite, ()) {
  const BodyMotion<2> motion = advance<2>(any_step(), any_faces(), ideal_gas());
  for (const Matrix3& A : {motion.added_mass, motion.response}) {
    RC_ASSERT((A - A.transpose()).norm() <= 1e-13 * A.norm());
    RC_ASSERT(Eigen::SelfAdjointEigenSolver<Matrix3>(A).eigenvalues()[0] >= -1e-13 * A.norm());
  }
}

RC_GTEST_PROP(AddedMassProperty, TheFrameDoesNotMatter, ()) {
  const Faces faces = any_faces();
  const BodyStep<2> step = any_step();
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(number_in(0, 6)).toRotationMatrix();
  Faces turned_faces = faces;
  for (WallFace<2>& face : turned_faces) {
    face.normal = R * face.normal;
    face.arm = R * face.arm;
  }
  BodyStep<2> turned_step = step;
  turned_step.velocity.head<2>() = R * step.velocity.head<2>();
  const BodyMotion<2> motion = advance<2>(step, faces, ideal_gas());
  const BodyMotion<2> turned = advance<2>(turned_step, turned_faces, ideal_gas());
  RC_ASSERT((turned.velocity.head<2>() - R * motion.velocity.head<2>()).norm() < 1e-9);
  RC_ASSERT((turned.mean.head<2>() - R * motion.mean.head<2>()).norm() < 1e-9);
  RC_ASSERT(std::abs(turned.velocity[2] - motion.velocity[2]) < 1e-9);
  RC_ASSERT((turned.force.head<2>() - R * motion.force.head<2>()).norm() < 1e-9);
}

RC_GTEST_PROP(AddedMassProperty, AMirroredSceneMovesMirrored, ()) {
  Faces faces = any_faces();
  BodyStep<2> step = any_step();
  const BodyMotion<2> motion = advance<2>(step, faces, ideal_gas());
  for (WallFace<2>& face : faces) {
    face.normal[1] *= -1;
    face.arm[1] *= -1;
  }
  step.velocity.tail<2>() *= -1;
  const BodyMotion<2> mirrored = advance<2>(step, faces, ideal_gas());
  RC_ASSERT((mirrored.velocity - motion.velocity.cwiseProduct(Vector3(1, -1, -1))).norm() < 1e-10);
}

}  // namespace
}  // namespace mortise
