#include "mortise/coupler/reference_map/mixture_riemann.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mortise/fluid/hllc.hpp"

namespace mortise {
namespace {

constexpr double gamma = 1.4;

MixtureSide<double> side(const Primitive<2>& W) {
  return {W.density,
          W.velocity[0],
          W.velocity[1],
          W.pressure,
          to_conserved(W, gamma).energy,
          std::sqrt(gamma * W.pressure / W.density)};
}

Primitive<2> random_gas() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  return {number(10, 500), {number(-300, 300), number(-300, 300)}, number(10, 500)};
}

RC_GTEST_PROP(MixtureRiemann, IsHllcWithoutShearStiffness, ()) {
  const Primitive<2> L = random_gas(), R = random_gas();
  const Conserved<2> expected = Hllc::flux(L, R, AxisFace<0>{}, gamma);
  const MixtureFlux<double> flux = mixture_flux(side(L), side(R), 0.0, 0.0);
  const double size = 1e-11 * (1 + std::fabs(expected.energy) + std::fabs(expected.momentum[0]));
  RC_ASSERT(std::fabs(flux.mass - expected.density) < size);
  RC_ASSERT(std::fabs(flux.normal - expected.momentum[0]) < size);
  RC_ASSERT(std::fabs(flux.tangential - expected.momentum[1]) < size);
  RC_ASSERT(std::fabs(flux.energy - expected.energy) < size);
}

// Equal states on both sides have the flux of that state, whatever the stiffness and the traction.
RC_GTEST_PROP(MixtureRiemann, IsConsistent, ()) {
  const Primitive<2> W = random_gas();
  const double traction = *rc::gen::inRange(-300, 300) / 100.0, stiffness = *rc::gen::inRange(0, 1000) / 100.0;
  const MixtureFlux<double> flux = mixture_flux(side(W), side(W), traction, stiffness);
  const double u = W.velocity[0], v = W.velocity[1];
  RC_ASSERT(std::fabs(flux.mass - W.density * u) < 1e-11 * (1 + std::fabs(flux.mass)));
  RC_ASSERT(std::fabs(flux.normal - (W.density * u * u + W.pressure)) < 1e-10 * (1 + std::fabs(flux.normal)));
  RC_ASSERT(std::fabs(flux.tangential - (W.density * u * v - traction)) < 1e-10 * (1 + std::fabs(flux.tangential)));
  const double energy = (to_conserved(W, gamma).energy + W.pressure) * u - traction * v;
  RC_ASSERT(std::fabs(flux.energy - energy) < 1e-9 * (1 + std::fabs(energy)));
}

// A jump of the tangential velocity alone in a solid at rest: v** and τ** of two equal impedances, and their work.
TEST(MixtureRiemann, ShearWaves) {
  const double density = 4, stiffness = 9, jump = 0.1;
  MixtureSide<double> L{density, 0, 0, 1, 5, 3}, R = L;
  R.tangential = jump;
  R.energy += 0.5 * density * jump * jump;
  const MixtureFlux<double> flux = mixture_flux(L, R, 0.2, stiffness);
  const double tau = 0.2 + 0.5 * std::sqrt(density * stiffness) * jump;
  EXPECT_NEAR(flux.mass, 0, 1e-15);
  EXPECT_NEAR(flux.tangential, -tau, 1e-14);
  EXPECT_NEAR(flux.energy, -tau * 0.5 * jump, 1e-14);
}

// As the contact passes a wave of the tangential velocity the flux does not jump.
TEST(MixtureRiemann, IsContinuousAcrossTheWavesOfTheTangentialVelocity) {
  const double density = 4, stiffness = 9, ct = std::sqrt(stiffness / density);
  const auto at = [&](double u) {
    const auto of = [&](double v) {
      return MixtureSide<double>{density, u, v, 1, 5 + 0.5 * density * (u * u + v * v), 3};
    };
    return mixture_flux(of(0.0), of(0.4), 0.2, stiffness);
  };
  for (const double sign : {-1.0, 1.0}) {
    const MixtureFlux<double> below = at(sign * (ct - 1e-9)), above = at(sign * (ct + 1e-9));
    EXPECT_NEAR(below.tangential, above.tangential, 1e-7);
    EXPECT_NEAR(below.energy, above.energy, 1e-7);
  }
}

}  // namespace
}  // namespace mortise
