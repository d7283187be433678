#include "mortise/cases/exact/acoustic_cylinder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "mortise/cases/exact/bessel_k.hpp"
#include "mortise/cases/exact/inverse_laplace.hpp"

namespace mortise {
namespace {

TEST(AcousticCylinder, PublishedVelocities) {
  EXPECT_NEAR(acoustic_cylinder_velocity(0.5, 0), 1.13338, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(1, 0), 1.44808, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(2, 0), 1.72894, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(4, 0), 1.90720, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(1, 1), 0.58710, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(1, 10), 0.079929, 1e-6);
}

TEST(AcousticCylinder, EarlyAndLateLimits) {
  // V(s) → 2 √(2/π) s^(−3/2) for s → ∞ and μ = 0; added mass for t → ∞.
  const double pi = std::acos(-1.0), t = 1e-6;
  EXPECT_NEAR(acoustic_cylinder_velocity(t, 0) / (4 * std::sqrt(2 * t) / pi), 1, 1e-5);
  EXPECT_NEAR(acoustic_cylinder_velocity(200, 0), 2, 1e-3);
  EXPECT_NEAR(acoustic_cylinder_velocity(200, 3), 0.5, 1e-3);
  EXPECT_EQ(acoustic_cylinder_velocity(-0.1, 0), 0);
  EXPECT_EQ(acoustic_cylinder_displacement(0, 0), 0);
}

TEST(AcousticCylinder, DisplacementIsTheIntegralOfVelocity) {
  double sum = 0;
  const int n = 200;
  for (int k = 0; k < n; ++k) sum += acoustic_cylinder_velocity(0.5 + 2.0 * (k + 0.5) / n, 0.4) * 2.0 / n;
  EXPECT_NEAR(acoustic_cylinder_displacement(2.5, 0.4) - acoustic_cylinder_displacement(0.5, 0.4), sum, 1e-5);
}

TEST(BesselK, RealAndComplexArguments) {
  // Abramowitz & Stegun table 9.8 and DLMF: K0(1), K1(1), K0(0.1), K1(0.1), K1(10).
  EXPECT_NEAR(scaled_bessel_k(0, 1).real() / std::exp(1.0), 0.42102443824070834, 1e-13);
  EXPECT_NEAR(scaled_bessel_k(1, 1).real() / std::exp(1.0), 0.60190723019723457, 1e-13);
  EXPECT_NEAR(scaled_bessel_k(0, 0.1).real() / std::exp(0.1), 2.4270690247020166, 1e-12);
  EXPECT_NEAR(scaled_bessel_k(1, 0.1).real() / std::exp(0.1), 9.8538447808706, 1e-12);
  EXPECT_NEAR(scaled_bessel_k(1, 10).real() / std::exp(10.0), 1.8648773453825585e-5, 1e-18);
  for (const std::complex<double> z : {std::complex<double>{0.3, 0.4}, {2, 15}, {0.05, 1}}) {
    // K2 = K0 + 2 K1/z, and K0' = −K1 by a central difference along z.
    const std::complex<double> k0 = scaled_bessel_k(0, z), k1 = scaled_bessel_k(1, z), k2 = scaled_bessel_k(2, z);
    EXPECT_LT(std::abs(k0 + 2.0 * k1 / z - k2), 1e-12 * std::abs(k2));
    const double h = 1e-4;
    const std::complex<double> slope =
        (scaled_bessel_k(0, z + h) * std::exp(-h) - scaled_bessel_k(0, z - h) * std::exp(h)) / (2 * h);
    EXPECT_LT(std::abs(slope + k1), 1e-6 * std::abs(k1));
  }
}

TEST(InverseLaplace, KnownTransforms) {
  using Complex = std::complex<double>;
  EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / (s + 1.0); }, 0.7), std::exp(-0.7), 1e-9);
  EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / (s * s); }, 3), 3, 1e-8);
  EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / (s * s + 1.0); }, 2), std::sin(2.0), 1e-8);
  EXPECT_NEAR(inverse_laplace([](Complex s) { return 1.0 / std::sqrt(s); }, 0.25), 2 / std::sqrt(std::acos(-1.0)),
              1e-8);
}

}  // namespace
}  // namespace mortise
