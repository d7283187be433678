#include "mortise/coupler/reference_map/solid_point.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Dense>

namespace mortise {
namespace {

Gradient random_deformation() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  return (Gradient() << number(700, 1500), number(-300, 300), number(-300, 300), number(700, 1500)).finished();
}

SolidPoint<double> at(const Material& material, const Gradient& F, double pressure = 0) {
  const Gradient G = F.inverse();
  const SolidLaw law{
      material.density, material.lambda, material.mu, pressure, 1.4, material.law == StressLaw::neo_hookean};
  return solid_point<double>(law, {G(0, 0), G(0, 1), G(1, 0), G(1, 1)});
}

RC_GTEST_PROP(SolidPoint, CauchyStressIsThatOfTheReferenceFrame, ()) {
  const Gradient F = random_deformation();
  for (const StressLaw law : {StressLaw::neo_hookean, StressLaw::saint_venant_kirchhoff}) {
    const Material material{law, 3, 2, 0.7};
    const Gradient sigma = stress(material, F) * F.transpose() / F.determinant();
    const SolidPoint<double> p = at(material, F, 0.6);
    RC_ASSERT(std::fabs(p.xx - sigma(0, 0)) < 1e-11 && std::fabs(p.xy - sigma(0, 1)) < 1e-11 &&
              std::fabs(p.yy - sigma(1, 1)) < 1e-11);
    RC_ASSERT(std::fabs(p.density * F.determinant() - 3) < 1e-12);
  }
}

// d(J e)/dF = P + (rest of the energy), e with C: J e = W + C − C J, dJ/dF = J F⁻ᵀ.
RC_GTEST_PROP(SolidPoint, EnergyIsThatOfTheStress, ()) {
  const Gradient F = random_deformation();
  const double pressure = 0.6, C = pressure * 1.4 / 0.4, d = 1e-6;
  for (const StressLaw law : {StressLaw::neo_hookean, StressLaw::saint_venant_kirchhoff}) {
    const Material material{law, 3, 2, 0.7};
    const auto energy = [&](const Gradient& A) { return A.determinant() * at(material, A, pressure).energy; };
    const Gradient expected = stress(material, F) - C * F.determinant() * F.inverse().transpose();
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Gradient up = F, down = F;
        up(i, j) += d;
        down(i, j) -= d;
        RC_ASSERT(std::fabs((energy(up) - energy(down)) / (2 * d) - expected(i, j)) < 1e-6);
      }
  }
}

// ρc² bounds the largest eigenvalue of the acoustic tensor of waves along an axis of space.
RC_GTEST_PROP(SolidPoint, StiffnessBoundsTheAcousticTensor, ()) {
  const Gradient F = random_deformation();
  for (const StressLaw law : {StressLaw::neo_hookean, StressLaw::saint_venant_kirchhoff}) {
    const Material material{law, 3, 2, 0.7};
    const SolidPoint<double> p = at(material, F);
    for (int axis = 0; axis < 2; ++axis) {
      const Point<2> s = F.transpose() * Point<2>::Unit(axis);
      const Eigen::Matrix2d tensor = s.squaredNorm() * acoustic_tensor(material, F, s.normalized()) / F.determinant();
      const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(tensor).eigenvalues()[1];
      const double bound = axis == 0 ? p.normal_x : p.normal_y;
      RC_ASSERT(bound > largest - 1e-9);
      if (law == StressLaw::neo_hookean) RC_ASSERT(bound < largest + 1e-9);
    }
  }
}

TEST(SolidPoint, UndeformedIsLikeGasOfTheReferencePressure) {
  for (const StressLaw law : {StressLaw::neo_hookean, StressLaw::saint_venant_kirchhoff}) {
    const SolidPoint<double> p = at({law, 3, 2, 0.7}, Gradient::Identity(), 0.6);
    EXPECT_EQ(p.xx, 0);
    EXPECT_EQ(p.xy, 0);
    EXPECT_EQ(p.yy, 0);
    EXPECT_EQ(p.energy, 0);
    EXPECT_NEAR(p.normal_x, 2 + 2 * 0.7, 0.8);  // λ + 2μ; a bound for saint_venant_kirchhoff
    EXPECT_NEAR(p.tangential_x, 0.7, 1e-14);
  }
}

}  // namespace
}  // namespace mortise
