#include "mortise/solid/material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>

namespace mortise {
namespace {

using ::testing::HasSubstr;

const std::array<StressLaw, 3> all_laws = {StressLaw::linear, StressLaw::saint_venant_kirchhoff,
                                           StressLaw::neo_hookean};

Material sample_material(StressLaw law) { return {law, 2, 3, 5}; }  // ρ0, λ, μ
Gradient gradient(double xx, double xy, double yx, double yy) { return (Gradient() << xx, xy, yx, yy).finished(); }
const Gradient sheared = gradient(1.2, 0.3, -0.2, 0.9);

/// dP/dF : dF by central differences of sixth order.
Gradient difference(const Material& m, const Gradient& F, const Gradient& dF) {
  const double e = 1e-2;
  const auto d = [&](double s) -> Gradient {
    return (stress(m, F + s * e * dF) - stress(m, F - s * e * dF)) / (2 * s * e);
  };
  return 1.5 * d(1) - 0.6 * d(2) + 0.1 * d(3);
}

TEST(Material, StressesByHand) {
  // F = diag(2, 1): E = diag(3/2, 0), S = diag(3·1.5 + 10·1.5, 4.5), P = F S
  EXPECT_TRUE(stress(sample_material(StressLaw::saint_venant_kirchhoff), gradient(2, 0, 0, 1))
                  .isApprox(gradient(39, 0, 0, 4.5)));
  // J = 2, F⁻ᵀ = diag(1/2, 1): P = 5 diag(3/2, 0) + 3 ln 2 diag(1/2, 1)
  const double l = 3 * std::log(2.0);
  EXPECT_TRUE(
      stress(sample_material(StressLaw::neo_hookean), gradient(2, 0, 0, 1)).isApprox(gradient(7.5 + 0.5 * l, 0, 0, l)));
  // ∇u = (0.2 0.3; −0.2 −0.1): tr = 0.1, 2μ ε = 5 (0.4 0.1; 0.1 −0.2)
  EXPECT_TRUE(stress(sample_material(StressLaw::linear), sheared).isApprox(gradient(2.3, 0.5, 0.5, -0.7)));
}

TEST(Material, LawsAgreeForSmallStrains) {
  const Gradient H = gradient(1e-6, 3e-6, -2e-6, 4e-6), F = Gradient::Identity() + H;
  const Gradient linear = stress(sample_material(StressLaw::linear), F);
  for (const StressLaw law : all_laws) {
    EXPECT_LT((stress(sample_material(law), F) - linear).norm(), 1e-9) << int(law);
    EXPECT_LT(stress(sample_material(law), Gradient::Identity()).norm(), 1e-15) << int(law);
  }
}

TEST(Material, StressTurnsWithTheBody) {
  const Gradient Q = gradient(std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7));
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean})
    EXPECT_TRUE(stress(sample_material(law), Q * sheared).isApprox(Q * stress(sample_material(law), sheared), 1e-14))
        << int(law);
  EXPECT_FALSE(stress(sample_material(StressLaw::linear), Q * sheared)
                   .isApprox(Q * stress(sample_material(StressLaw::linear), sheared), 1e-2));
}

TEST(Material, AcousticTensorIsTheTangentOfTheTraction) {
  const Point<2> N = Point<2>(0.6, -0.8);
  for (const StressLaw law : all_laws) {
    const Material m = sample_material(law);
    Eigen::Matrix2d tangent;
    for (int k = 0; k < 2; ++k) tangent.col(k) = difference(m, sheared, Point<2>::Unit(k) * N.transpose()) * N;
    EXPECT_LT((acoustic_tensor(m, sheared, N) - tangent).norm(), 1e-9) << int(law);
  }
}

TEST(Material, ImpedanceIsTheRootOfDensityTimesAcousticTensor) {
  const Point<2> N = Point<2>(0.6, -0.8);
  for (const StressLaw law : all_laws) {
    const Material m = sample_material(law);
    const Eigen::Matrix2d Z = impedance(m, sheared, N);
    EXPECT_TRUE((Z * Z).isApprox(m.density * acoustic_tensor(m, sheared, N), 1e-14)) << int(law);
    EXPECT_GT(Z.trace(), 0);
    EXPECT_GT(Z.determinant(), 0);
    const Eigen::Matrix2d at_rest = impedance(m, Gradient::Identity(), N);
    EXPECT_TRUE((at_rest * N).isApprox(m.density * m.pressure_wave_speed() * N, 1e-14));
    EXPECT_TRUE((at_rest * Point<2>(0.8, 0.6)).isApprox(m.density * m.shear_wave_speed() * Point<2>(0.8, 0.6), 1e-14));
  }
}

TEST(Material, ImpedanceStaysPositiveWhereTheLawIsNotElliptic) {
  const Point<2> N(1, 0);
  for (const auto& [law, F] : {std::pair{StressLaw::saint_venant_kirchhoff, gradient(0.3, 0.05, 0, 0.4)},
                               {StressLaw::neo_hookean, gradient(0.1, 0, 0.1, 400)}}) {
    const Eigen::Matrix2d Z = impedance(sample_material(law), F, N);
    EXPECT_GT(Z.determinant(), 0);
    EXPECT_GT(Z.trace(), 0);
  }
  const Gradient crushed = gradient(0.3, 0.05, 0, 0.4);
  EXPECT_LT(acoustic_tensor(sample_material(StressLaw::saint_venant_kirchhoff), crushed, N).trace(), 0);
}

TEST(Material, WaveSpeeds) {
  EXPECT_DOUBLE_EQ(sample_material(StressLaw::linear).pressure_wave_speed(), std::sqrt(6.5));
  EXPECT_DOUBLE_EQ(sample_material(StressLaw::linear).shear_wave_speed(), std::sqrt(2.5));
}

std::string complaint(const Material& m) {
  try {
    m.check();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Material, CheckNamesTheNumberThatIsWrong) {
  const StressLaw law = StressLaw::neo_hookean;
  EXPECT_EQ(complaint({law, 1, -0.5, 1}), "");
  EXPECT_EQ(complaint({law, 1, 1, -1}), "material: mu must be > 0, not -1");
  EXPECT_EQ(complaint({law, 0, 1, 1}), "material: density must be > 0, not 0");
  EXPECT_EQ(complaint({law, 1, -2, 1.5}), "material: lambda must be > -mu = -1.5, not -2");
  EXPECT_THAT(complaint({law, 1, std::numeric_limits<double>::quiet_NaN(), 1}), HasSubstr("lambda must be finite"));
}

TEST(Material, LawsByKey) {
  EXPECT_EQ(stress_laws().at("neo_hookean"), StressLaw::neo_hookean);
  EXPECT_EQ(stress_laws().keys().size(), 3u);
  EXPECT_THROW(stress_laws().at("neohookean"), InputError);
}

}  // namespace
}  // namespace mortise
