// What every Riemann solver must satisfy, whatever its name.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mortise/fluid/face.hpp"
#include "unit/fluid/gas_options.hpp"

namespace mortise::testing {

using Plane = Primitive<2>;

inline void expect_near(const Conserved<2>& a, const Conserved<2>& b, double tolerance) {
  EXPECT_NEAR(a.density, b.density, tolerance);
  EXPECT_NEAR(a.momentum[0], b.momentum[0], tolerance);
  EXPECT_NEAR(a.momentum[1], b.momentum[1], tolerance);
  EXPECT_NEAR(a.energy, b.energy, tolerance);
}

/// F(U)·S − w·S U
inline Conserved<2> physical_flux(const Plane& W, const PlaneFace<double>& face, double gamma) {
  const Conserved<2> U = to_conserved(W, gamma);
  const double q = W.velocity[0] * face.sx + W.velocity[1] * face.sy, relative = q - face.swept;
  return {U.density * relative,
          {U.momentum[0] * relative + W.pressure * face.sx, U.momentum[1] * relative + W.pressure * face.sy},
          U.energy * relative + W.pressure * q};
}

inline std::vector<PlaneFace<double>> sample_faces() {
  return {{1, 0, 0}, {0, 1, 0}, {0.3, -0.4, 0}, {-2, 1.5, 0.7}, {1e-3, 2e-3, -4e-3}, {100, 40, 3e2}};
}
inline std::vector<Plane> sample_states() {
  return {{1, {0, 0}, 1}, {1.4, {0.3, -0.7}, 0.2}, {0.1, {-10, 4}, 1}, {1000, {0.1, 0.2}, 1e5}, {1e-6, {30, 0}, 1e-7}};
}
/// Scale of a flux through a face, for tolerances.
inline double flux_scale(const Plane& W, const PlaneFace<double>& face, double gamma) {
  const double c = std::sqrt(gamma * W.pressure / W.density);
  const double speed = std::hypot(W.velocity[0], W.velocity[1]) + c;
  return (W.density + to_conserved(W, gamma).energy * (1 + speed)) *
         (speed * face.area + std::abs(face.swept) + face.area);
}

template <class Solver>
void check_consistency(double gamma) {
  for (const auto& face : sample_faces())
    for (const Plane& W : sample_states())
      expect_near(Solver::flux(W, W, face, gamma), physical_flux(W, face, gamma), 2e-14 * flux_scale(W, face, gamma));
}

/// With both states running away from the face faster than sound, or towards it: the flux is that of the upwind state.
template <class Solver>
void check_upwinding(double gamma) {
  const Plane L{1, {3, 0.5}, 1}, R{0.5, {4, -0.2}, 0.6}, l{1, {-4, 0.5}, 1}, r{0.5, {-3, -0.2}, 0.6};
  const PlaneFace<double> face(2, 0, 0.1);
  expect_near(Solver::flux(L, R, face, gamma), physical_flux(L, face, gamma), 1e-13);
  expect_near(Solver::flux(l, r, face, gamma), physical_flux(r, face, gamma), 1e-13);
}

/// The flux through a face twice as large is twice the flux, exactly; in a frame that moves along, the same masses
/// pass.
template <class Solver>
void check_scaling_and_frame(double gamma) {
  const Plane L{1, {0.3, 0.5}, 1}, R{0.5, {-0.2, -0.2}, 0.3};
  const Conserved<2> one = Solver::flux(L, R, PlaneFace<double>(0.6, 0.8, 0.05), gamma);
  const Conserved<2> two = Solver::flux(L, R, PlaneFace<double>(1.2, 1.6, 0.1), gamma);
  EXPECT_NEAR(two.density, 2 * one.density, 1e-15);
  EXPECT_NEAR(two.energy, 2 * one.energy, 1e-14);
  const std::array<double, 2> shift = {0.7, -1.1};
  const auto moved = [&](Plane W) {
    for (std::size_t d = 0; d < 2; ++d) W.velocity[d] += shift[d];
    return W;
  };
  const PlaneFace<double> along(0.6, 0.8, 0.05 + 0.6 * shift[0] + 0.8 * shift[1]);
  const Conserved<2> other = Solver::flux(moved(L), moved(R), along, gamma);
  EXPECT_NEAR(other.density, one.density, 1e-14);
  for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(other.momentum[d], one.momentum[d] + shift[d] * one.density, 1e-14);
}

/// Lanes of a vector agree with each other to the bit and with the scalar solver to round-off.
template <class Solver>
void check_lanes(double gamma) {
  const Plane L{1, {0.3, 0.5}, 1}, R{0.5, {-0.2, -0.2}, 0.3};
  const auto wide = [](const Plane& W) {
    return Primitive<2, Pack>{
        broadcast(W.density), {broadcast(W.velocity[0]), broadcast(W.velocity[1])}, broadcast(W.pressure)};
  };
  const PlaneFace<Pack> face(broadcast(0.6), broadcast(0.9), broadcast(0.05));
  const Conserved<2, Pack> F = Solver::flux(wide(L), wide(R), face, gamma);
  const Conserved<2> f = Solver::flux(L, R, PlaneFace<double>(0.6, 0.9, 0.05), gamma);
  for (int k = 0; k < simd_width; ++k) {
    EXPECT_EQ(F.energy[k], F.energy[0]);
    expect_near({F.density[k], {F.momentum[0][k], F.momentum[1][k]}, F.energy[k]}, f, 1e-14);
  }
}

/// Mirror image in the plane x = 0: mass and energy flux change sign, to within `tolerance`.
template <class Solver>
void check_mirror(double gamma, double tolerance) {
  for (const Plane& L : sample_states())
    for (const Plane& R : sample_states()) {
      const Plane l{R.density, {-R.velocity[0], R.velocity[1]}, R.pressure};
      const Plane r{L.density, {-L.velocity[0], L.velocity[1]}, L.pressure};
      const Conserved<2> F = Solver::flux(L, R, AxisFace<0>{}, gamma), G = Solver::flux(l, r, AxisFace<0>{}, gamma);
      const double scale = std::abs(F.density) + std::abs(F.momentum[0]) + std::abs(F.momentum[1]) + std::abs(F.energy);
      expect_near({-G.density, {G.momentum[0], -G.momentum[1]}, -G.energy}, F, tolerance * scale);
    }
}

}  // namespace mortise::testing
