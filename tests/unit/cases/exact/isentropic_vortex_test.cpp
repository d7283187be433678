#include "mortise/cases/exact/isentropic_vortex.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription vortex() {
  CaseDescription description;
  description.initial.kind = "vortex";
  description.initial.strength = 2;
  description.initial.vortex_radius = 0.15;
  description.initial.vortex_center = {-0.15, 0.05};
  description.initial.vortex_velocity = {0.5, 0.3};
  return description;
}

std::array<double, 4> conserved(const Primitive<2>& W) {
  const Conserved<2> U = to_conserved(W, 1.4);
  return {U.density, U.momentum[0], U.momentum[1], U.energy};
}

std::array<double, 4> flux(const Primitive<2>& W, std::size_t d) {
  auto F = conserved(W);
  F[3] += W.pressure;
  for (double& f : F) f *= W.velocity[d];
  F[1 + d] += W.pressure;
  return F;
}

TEST(IsentropicVortex, SolvesTheEulerEquations) {
  const IsentropicVortex vortex_flow(vortex());
  const Point<2> x(0.07, 0.11);
  const double t = 0.3, h = 1e-4;
  const Point<2> ex(h, 0), ey(0, h);
  const auto U1 = conserved(vortex_flow.state(x, t + h)), U0 = conserved(vortex_flow.state(x, t - h));
  const auto F1 = flux(vortex_flow.state(x + ex, t), 0), F0 = flux(vortex_flow.state(x - ex, t), 0);
  const auto G1 = flux(vortex_flow.state(x + ey, t), 1), G0 = flux(vortex_flow.state(x - ey, t), 1);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_GT(std::abs(G1[k] - G0[k]) / (2 * h), 1e-2) << k;
    EXPECT_NEAR((U1[k] - U0[k] + F1[k] - F0[k] + G1[k] - G0[k]) / (2 * h), 0, 1e-5) << k;
  }
}

TEST(IsentropicVortex, CentreAndFarField) {
  const IsentropicVortex vortex_flow(vortex());
  const double pi = std::acos(-1.0);
  const double temperature = 1 - 0.4 * 4 * std::exp(1.0) / (8 * 1.4 * pi * pi);
  const Primitive<2> center = vortex_flow.state(Point<2>(-0.15 + 0.5 * 0.6, 0.05 + 0.3 * 0.6), 0.6);
  EXPECT_NEAR(center.density, std::pow(temperature, 2.5), 1e-14);
  EXPECT_NEAR(center.pressure, std::pow(temperature, 3.5), 1e-14);
  EXPECT_NEAR(center.velocity[0], 0.5, 1e-14);
  const Primitive<2> far = vortex_flow.state(Point<2>(1.5, 1.5), 0);
  EXPECT_NEAR(far.density, 1, 1e-14);
  EXPECT_NEAR(far.velocity[1], 0.3, 1e-14);
}

TEST(IsentropicVortex, RejectsAVortexWithoutGasInItsCentre) {
  CaseDescription description = vortex();
  description.initial.strength = 11;
  EXPECT_THROW(IsentropicVortex{description}, InputError);
  description = vortex();
  description.p_inf = 1;
  EXPECT_THROW(IsentropicVortex{description}, InputError);
}

}  // namespace
}  // namespace mortise
