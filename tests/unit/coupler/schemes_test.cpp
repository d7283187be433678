#include "mortise/coupler/schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "mortise/grids/core/error.hpp"
#include "unit/coupler/interface_scene.hpp"
#include "unit/coupler/wall_scene.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::acoustic;
using testing::curve;
using testing::ideal_gas;
using testing::InterfaceScene;
using testing::number;
using testing::one_face;

const Point<2> x_axis(1, 0);

InterfaceScene riemann_problem(const testing::ReferenceRow& row) {
  const Point<2> n = row.at("orient") == "SF" ? x_axis : Point<2>(-x_axis);
  const double z = number(row, "rho_s") * number(row, "c_s");
  return one_face(n, {{number(row, "v_s"), 0}, number(row, "sigma_s") * n, testing::isotropic_admittance(n, z, z)},
                  {number(row, "rho"), {number(row, "v"), 0}, number(row, "p")}, ideal_gas(number(row, "gamma")));
}

void expect_reference(const std::string& scheme, double tolerance) {
  for (const auto& row : testing::reference_table("fsrp.csv"))
    for (const bool nonlinear : {true, false}) {
      SCOPED_TRACE(row.at("case") + (nonlinear ? " nonlinear" : " linear"));
      const std::string prefix = nonlinear ? "nl_" : "lin_";
      const double v = number(row, prefix + "v"), sigma = number(row, prefix + "sigma"), p_e = number(row, "p_e");
      const InterfaceScene scene = riemann_problem(row);
      const InterfaceSolution solution = scene.solve(scheme, {.nonlinear = nonlinear, .reference_pressure = p_e});
      EXPECT_NEAR(solution.velocity[0][0], v, tolerance * (1 + std::abs(v)));
      EXPECT_EQ(solution.velocity[0][1], 0);
      EXPECT_EQ(solution.wall_velocity[0], solution.velocity[0]);
      const double scale = tolerance * (std::abs(sigma) + number(row, "p") + 1);
      EXPECT_NEAR(solution.pressure[0], p_e - sigma, scale);
      EXPECT_NEAR(solution.traction[0].dot(scene.area[0]), sigma, scale);
    }
}

TEST(InterfaceSchemes, ProjectionSolvesFluidStructureRiemannProblems) { expect_reference("projection", 1e-10); }
TEST(InterfaceSchemes, SubIterationsSolveFluidStructureRiemannProblems) {
  expect_reference("traditional-subiterated", 1e-9);
}
TEST(InterfaceSchemes, FirstStepsOfTheOthersAreTheProjection) {
  expect_reference("traditional", 1e-10);
  expect_reference("anti-traditional", 1e-10);
}

TEST(InterfaceSchemes, RigidWallKeepsItsVelocity) {
  const InterfaceScene scene =
      one_face(x_axis, {{0.3, -0.2}, {5, 1}, Eigen::Matrix2d::Zero()}, {1, {0, 0.7}, 1}, ideal_gas());
  for (const char* scheme : {"projection", "traditional-subiterated"}) {
    const InterfaceSolution solution = scene.solve(scheme);
    EXPECT_EQ(solution.velocity[0], Point<2>(0.3, -0.2));
    EXPECT_DOUBLE_EQ(solution.pressure[0], wall_response(1, 1, 0.3, 1.4).pressure);
  }
}

TEST(InterfaceSchemes, MasslessStructureCarriesNoLoad) {
  const Point<2> n = Point<2>(3, 4) / 5, t(-n[1], n[0]);
  for (const double z : {1e-9, 1e-12, 1e-15})
    for (const double p_e : {1e-3, 1.0, 40.0}) {
      const InterfaceScene scene = one_face(n, {0.3 * n + 0.1 * t, {0, 0}, testing::isotropic_admittance(n, z, 1)},
                                            {1, 0.2 * n, 1}, ideal_gas());
      const InterfaceSolution solution = scene.solve("projection", {.reference_pressure = p_e});
      EXPECT_NEAR(solution.pressure[0], p_e, 10 * z * (1 + p_e) + 1e-13);
      EXPECT_NEAR(wall_response(1, 1, solution.velocity[0].dot(n) - 0.2, 1.4).pressure, p_e,
                  10 * z * (1 + p_e) + 1e-13);
      EXPECT_NEAR(solution.velocity[0].dot(t), 0.1, 1e-14 * (1 + p_e));
    }
}

TEST(InterfaceSchemes, FleeingStructureLeavesAVacuum) {
  const double z = 0.5;
  const InterfaceScene scene =
      one_face(x_axis, {{-40, 0}, {0, 0}, testing::isotropic_admittance(x_axis, z, z)}, {1, {0, 0}, 1}, ideal_gas());
  const InterfaceSolution solution = scene.solve("projection", {.reference_pressure = 0.2});
  EXPECT_EQ(solution.pressure[0], 0);
  EXPECT_NEAR(solution.velocity[0][0], -40 + 0.2 / z, 1e-13);
}

TEST(InterfaceSchemes, WorkAtAnyScaleOfPressureAndAnyMachNumber) {
  for (const double scale : {1e-12, 1.0, 1e12})
    for (const double mach : {-1e3, -4.0, 0.1, 4.0, 1e3})
      for (const double ratio : {1e-8, 1e-3, 1.0, 1e3, 1e8}) {
        const double c = std::sqrt(1.4 * scale), z = ratio * c;  // density 1
        const InterfaceScene scene =
            one_face(x_axis, {{mach * c, 0}, {0, 0}, testing::isotropic_admittance(x_axis, z, z)}, {1, {0, 0}, scale},
                     ideal_gas());
        const InterfaceSolution solution = scene.solve("projection", {.reference_pressure = scale});
        const double v = solution.velocity[0][0], p = solution.pressure[0];
        EXPECT_DOUBLE_EQ(p, wall_response(1, scale, v, 1.4).pressure);
        EXPECT_NEAR((p - scale + z * (v - mach * c)) / (p + scale + z * (std::abs(v) + std::abs(mach) * c)), 0, 1e-14)
            << scale << " " << mach << " " << ratio;
      }
}

TEST(InterfaceSchemes, DeformedAreaIsNansonsRelation) {
  // Acoustic fluid: v = (y (p_e − p + z v_f) + v_e)/(1 + y z) with y = a/z_p; the traction is per reference area.
  const double a = 1.7, z = 2, z_p = 3, p = 1.5, p_e = 0.7, v_s = 0.4, v_f = -0.1, sigma = 0.25;
  const InterfaceScene scene = one_face(x_axis, {{v_s, 0}, {sigma, 0}, testing::isotropic_admittance(x_axis, z_p, 1)},
                                        {1, {v_f, 0}, p}, acoustic(z), a);
  const auto expect = [&](const InterfaceOptions& options, double ratio) {
    const double y = ratio / z_p, v = (y * (p_e - p + z * v_f) + v_s - sigma / z_p) / (1 + y * z);
    const InterfaceSolution solution = scene.solve("projection", options);
    EXPECT_NEAR(solution.velocity[0][0], v, 1e-15);
    EXPECT_NEAR(solution.pressure[0], p + z * (v - v_f), 1e-15);
    EXPECT_NEAR(solution.traction[0][0], -(solution.pressure[0] - p_e) * ratio, 1e-15);
  };
  expect({.reference_pressure = p_e}, a);
  expect({.reference_load = true, .reference_pressure = p_e}, 1);
}

TEST(InterfaceSchemes, StructureSlipsAlongAnInviscidFluid) {
  // Oblique normal: the fluid feels n·v only, the structure gives in along the interface by its own shear traction.
  const Point<2> n = Point<2>(3, 4) / 5, t(-n[1], n[0]);
  const InterfaceScene scene =
      one_face(n, {0.2 * n + 0.1 * t, 0.3 * n - 0.5 * t, testing::isotropic_admittance(n, 2, 4)},
               {1, 0.2 * n + 9 * t, 1}, acoustic(1.5));
  const InterfaceSolution solution = scene.solve("projection");
  EXPECT_NEAR(solution.velocity[0].dot(t), 0.1 + 0.5 / 4, 1e-15);
  EXPECT_NEAR(solution.traction[0].dot(t), 0, 1e-15);
}

TEST(InterfaceSchemes, ForcesOnBothSidesBalanceWhateverTheFaces) {
  const InterfaceOptions options{.reference_pressure = 0.8};
  for (const bool closed : {true, false})
    for (const double shift : {0.0, closed ? 0.123 : 0.0}) {
      const InterfaceScene scene = curve(100, 137, closed, 2, ideal_gas(), shift);
      ASSERT_FALSE(scene.transfer.matching());
      InterfaceHistory history;
      for (const std::string& scheme : interface_schemes().keys()) {
        const InterfaceSolution solution = scene.solve(scheme, options, history);
        const Point<2> fluid = scene.fluid_force(solution.load, options.reference_pressure);
        EXPECT_GT(fluid.norm(), 1e-3);
        EXPECT_LT((fluid - scene.structure_force(solution.traction)).norm(), 1e-13) << scheme << closed;
        history.remember(solution);
      }
    }
}

TEST(InterfaceSchemes, UniformPressureOnAClosedCurveHasNoForce) {
  const InterfaceScene scene = curve(61, 83, true, 2, ideal_gas());
  const std::vector<double> pressure(83, 3.0);
  EXPECT_LT(scene.structure_force(tractions(scene.problem(), pressure, {})).norm(), 1e-13);
}

TEST(InterfaceSchemes, NonMatchingFacesConvergeToMatchingOnes) {
  // Mean pressure over an arc of the closed curve, against a fine matching division.
  const auto force = [](int structure, int fluid) {
    const InterfaceScene scene = curve(structure, fluid, true, 2, ideal_gas());
    return scene.fluid_force(scene.solve("projection").pressure, 0);
  };
  const Point<2> fine = force(4000, 4000);
  const double coarse = (force(100, 137) - fine).norm(), finer = (force(200, 274) - fine).norm();
  EXPECT_LT(finer, 1e-3);
  EXPECT_GT(coarse / finer, 3.5);
}

TEST(InterfaceSchemes, SubIterationsConvergeToTheProjection) {
  for (const double ratio : {1e-2, 1e-1, 0.5, 1.0, 3.0, 1e1, 1e2}) {
    const InterfaceScene scene = curve(40, 40, true, ratio * 1.2, ideal_gas());
    const InterfaceOptions options{.reference_pressure = 0.9};
    const InterfaceSolution expected = scene.solve("projection", options);
    const InterfaceSolution solution = scene.solve("traditional-subiterated", options);
    EXPECT_GT(solution.iterations, 1);
    RecordProperty("iterations_" + std::to_string(ratio), solution.iterations);
    for (std::size_t i = 0; i < 40; ++i) {
      EXPECT_NEAR(solution.pressure[i], expected.pressure[i], 1e-11) << ratio;
      EXPECT_LT((solution.velocity[i] - expected.velocity[i]).norm(), 1e-11 * std::max(1.0, 1 / ratio)) << ratio;
    }
  }
}

TEST(InterfaceSchemes, SubIterationsThatDoNotConvergeSaySo) {
  const InterfaceScene scene = curve(40, 40, true, 0.01, ideal_gas());
  EXPECT_THROW(scene.solve("traditional-subiterated", {.most_iterations = 2}), NumericalError);
}

InterfaceHistory made_up(const InterfaceScene& scene, double sign_x) {
  InterfaceHistory history;
  for (const double part : {0.9, 1.0}) {
    InterfaceSolution past = scene.solve("projection");
    for (Point<2>& v : past.velocity) v += part * Point<2>(0.01 * sign_x, 0.02);
    for (double& p : past.load) p *= 1 + 0.1 * part;
    history.remember(past);
  }
  return history;
}

/// The same interface with all faces numbered backwards.
InterfaceScene renumbered(const InterfaceScene& scene) {
  InterfaceScene other = scene;
  std::vector<double> s = {0}, f = {0};
  for (const double length : scene.reference_length) s.push_back(s.back() + length);
  for (std::size_t b = 0; b < scene.fluid.size(); ++b)
    f.push_back(s.back() * double(b + 1) / double(scene.fluid.size()));
  std::reverse(other.structure.begin(), other.structure.end());
  std::reverse(other.fluid.begin(), other.fluid.end());
  std::reverse(other.area.begin(), other.area.end());
  std::reverse(other.reference_length.begin(), other.reference_length.end());
  std::reverse(s.begin(), s.end());
  std::reverse(f.begin(), f.end());
  other.transfer = Transfer(s, f, false);
  return other;
}

/// The mirror image x → −x.
InterfaceScene mirrored(const InterfaceScene& scene) {
  InterfaceScene other = scene;
  const auto flip = [](Point<2>& v) { v[0] = -v[0]; };
  for (StructureTrace& trace : other.structure) {
    flip(trace.velocity), flip(trace.traction);
    trace.admittance(0, 1) *= -1, trace.admittance(1, 0) *= -1;
  }
  for (FluidTrace& trace : other.fluid) flip(trace.velocity);
  for (Point<2>& S : other.area) flip(S);
  return other;
}

TEST(InterfaceSchemes, MirroredAndRenumberedInterfacesHaveTheSameAnswer) {
  for (const int fluid_faces : {30, 41}) {
    const InterfaceScene scene = curve(30, fluid_faces, false, 1.5, ideal_gas());
    const InterfaceScene backwards = renumbered(scene), mirror = mirrored(scene);
    for (const std::string& scheme : interface_schemes().keys()) {
      const InterfaceSolution a = scene.solve(scheme, {}, made_up(scene, 1));
      const InterfaceSolution b = backwards.solve(scheme, {}, made_up(backwards, 1));
      const InterfaceSolution m = mirror.solve(scheme, {}, made_up(mirror, -1));
      for (std::size_t i = 0; i < 30; ++i) {
        EXPECT_LT((a.velocity[i] - b.velocity[29 - i]).norm(), 1e-12) << scheme;
        EXPECT_LT((a.traction[i] - b.traction[29 - i]).norm(), 1e-12) << scheme;
        EXPECT_LT((a.velocity[i] - Point<2>(-m.velocity[i][0], m.velocity[i][1])).norm(), 1e-15) << scheme;
      }
      for (std::size_t k = 0; k < a.pressure.size(); ++k) EXPECT_EQ(a.pressure[k], m.pressure[k]) << scheme;
    }
  }
}

TEST(InterfaceSchemes, TraditionalMovesTheWallWithTheStructuresPastVelocity) {
  const double z = 1.5, z_s = 4;
  const InterfaceScene scene = one_face(x_axis, {{0.1, 0}, {0.2, 0}, testing::isotropic_admittance(x_axis, z_s, 1)},
                                        {1, {0.05, 0}, 1}, acoustic(z));
  InterfaceHistory history{{{{0.3, 0}}, {{0.2, 0}}}, {{1.1}, {1.3}}};
  for (const bool lagged : {true, false}) {
    const double v_w = lagged ? 0.3 : 0.4, p_w = lagged ? 1.1 : 0.9;
    const InterfaceSolution a = scene.solve("traditional", {.lagged = lagged}, history);
    const double p = 1 + z * (v_w - 0.05);
    EXPECT_NEAR(a.wall_velocity[0][0], v_w, 1e-15);
    EXPECT_NEAR(a.pressure[0], p, 1e-15);
    EXPECT_NEAR(a.velocity[0][0], 0.1 + (-p - 0.2) / z_s, 1e-15);

    const InterfaceSolution b = scene.solve("anti-traditional", {.lagged = lagged}, history);
    const double v = 0.05 + (p_w - 1) / z;
    EXPECT_NEAR(b.pressure[0], p_w, 1e-15);
    EXPECT_NEAR(b.velocity[0][0], v, 1e-15);
    EXPECT_NEAR(b.wall_velocity[0][0], v, 1e-15);
    EXPECT_NEAR(b.traction[0][0], 0.2 + z_s * (v - 0.1), 1e-15);
    EXPECT_NEAR(b.load[0], -b.traction[0][0], 1e-15);
  }
}

TEST(InterfaceSchemes, FailuresNameTheFace) {
  InterfaceScene scene = curve(5, 5, false, 1, ideal_gas());
  const InterfaceHistory history = made_up(scene, 1);
  scene.fluid[3].pressure = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& scheme : interface_schemes().keys()) try {
      scene.solve(scheme, {}, history);
      ADD_FAILURE() << scheme;
    } catch (const NumericalError& error) {
      EXPECT_NE(std::string(error.what()).find("fluid face 3"), std::string::npos) << error.what();
    }
  const InterfaceScene rigid = one_face(x_axis, {}, {1, {0, 0}, 1}, ideal_gas());
  EXPECT_THROW(rigid.solve("anti-traditional", {}, {{{{0, 0}}}, {{1.0}}}), NumericalError);
  EXPECT_THROW(interface_schemes().at("projektion"), InputError);
}

}  // namespace
}  // namespace mortise
