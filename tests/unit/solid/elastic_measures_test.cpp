#include "mortise/solid/elastic_measures.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace mortise {
namespace {

constexpr double lambda = 1.7, mu = 0.6;

Material material(StressLaw law) { return {law, 2.0, lambda, mu}; }

ElasticState hyperelastic(const Gradient& F) { return {0.1, -0.2, F(0, 0), F(0, 1), F(1, 0), F(1, 1), 0.3, 0.4}; }

/// σ of the strain ε.
ElasticState linear(double xx, double xy, double yy) {
  const double pressure = lambda * (xx + yy);
  return {0.1, -0.2, pressure + 2 * mu * xx, 2 * mu * xy, pressure + 2 * mu * yy, 0.3, 0.4, 0};
}

Gradient example() { return (Gradient() << 1.2, 0.3, -0.1, 0.9).finished(); }

TEST(ElasticMeasures, ComponentsOfTheState) {
  for (const auto& [law, state] : {std::pair(StressLaw::linear, linear(0, 0, 0)),
                                   std::pair(StressLaw::neo_hookean, hyperelastic(Gradient::Identity()))}) {
    EXPECT_EQ(velocity_of(state), Point<2>(0.1, -0.2));
    EXPECT_EQ(displacement_of(material(law), state), Point<2>(0.3, 0.4));
  }
}

TEST(ElasticMeasures, VonMisesOfKnownStates) {
  EXPECT_DOUBLE_EQ((CauchyStress{3, 0, 0, 0}.von_mises()), 3);                 // uniaxial
  EXPECT_DOUBLE_EQ((CauchyStress{0, 2, 0, 0}.von_mises()), 2 * std::sqrt(3));  // pure shear
  EXPECT_DOUBLE_EQ((CauchyStress{-5, 0, -5, -5}.von_mises()), 0);              // hydrostatic
}

TEST(ElasticMeasures, LinearLaw) {
  const Material m = material(StressLaw::linear);
  const double xx = 0.02, xy = -0.005, yy = 0.01, dilatation = xx + yy;
  const ElasticState state = linear(xx, xy, yy);
  EXPECT_NEAR(jacobian_of(m, state), 1 + dilatation, 1e-15);
  EXPECT_NEAR(cauchy_stress_of(m, state).zz, lambda * dilatation, 1e-15);
  EXPECT_NEAR(strain_energy_of(m, state),
              0.5 * lambda * dilatation * dilatation + mu * (xx * xx + yy * yy + 2 * xy * xy), 1e-16);
  EXPECT_EQ(stress_of(m, state)(1, 0), state[3]);
}

TEST(ElasticMeasures, CauchyStressTurnsWithTheSolid) {
  const double angle = 0.7;
  const Gradient Q = (Gradient() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)).finished();
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean}) {
    const Material m = material(law);
    const CauchyStress s = cauchy_stress_of(m, hyperelastic(example())),
                       turned = cauchy_stress_of(m, hyperelastic(Q * example()));
    const Gradient expected = Q * (Gradient() << s.xx, s.xy, s.xy, s.yy).finished() * Q.transpose();
    EXPECT_NEAR(turned.xx, expected(0, 0), 1e-14);
    EXPECT_NEAR(turned.xy, expected(0, 1), 1e-14);
    EXPECT_NEAR(turned.yy, expected(1, 1), 1e-14);
    EXPECT_NEAR(turned.zz, s.zz, 1e-14);
    EXPECT_NEAR(turned.von_mises(), s.von_mises(), 1e-14);
  }
}

TEST(ElasticMeasures, StressIsTheDerivativeOfTheEnergy) {
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean}) {
    const Material m = material(law);
    const Gradient P = stress_of(m, hyperelastic(example()));
    constexpr double step = 1e-5;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        Gradient more = example(), less = example();
        more(i, j) += step;
        less(i, j) -= step;
        const double slope =
            (strain_energy_of(m, hyperelastic(more)) - strain_energy_of(m, hyperelastic(less))) / (2 * step);
        EXPECT_NEAR(slope, P(i, j), 1e-9) << i << j;
      }
    EXPECT_NEAR(strain_energy_of(m, hyperelastic(Gradient::Identity())), 0, 1e-15);
  }
}

TEST(ElasticMeasures, NeoHookeanUnderUniformCompression) {
  const Material m = material(StressLaw::neo_hookean);
  const double a = 0.8, J = a * a;
  const CauchyStress s = cauchy_stress_of(m, hyperelastic(a * Gradient::Identity()));
  EXPECT_NEAR(jacobian_of(m, hyperelastic(a * Gradient::Identity())), J, 1e-15);
  EXPECT_NEAR(s.xx, (mu * (J - 1) + lambda * std::log(J)) / J, 1e-14);
  EXPECT_NEAR(s.zz, lambda * std::log(J) / J, 1e-14);
}

}  // namespace
}  // namespace mortise
