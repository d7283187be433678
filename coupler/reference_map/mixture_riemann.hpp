// The Riemann problem at a face of cells in which gas and solids are mixed (mixture_step.hpp). With a_K = ρ_K(s_K −
// u_K), Davis' speeds s_L, s_R of the fastest waves and the normal pressures p_K (= −t_n), the contact moves with
//   u* = (p_R − p_L + a_L u_L − a_R u_R)/(a_L − a_R),   p* = p_K + a_K (u* − u_K),   ρ* = a_K/(s_K − u*),
// and upwind of it the flux is that of HLLC (Toro, Riemann Solvers, 3rd ed., section 10.4). Waves of the tangential
// velocity run at u* ± c_t, ρ*c_t² = k_t being the stiffness against shear: between them, with Z_K = √(ρ*_K k_t),
//   v** = (Z_L v_L + Z_R v_R)/(Z_L + Z_R),   τ** = τ + Z_L Z_R (v_R − v_L)/(Z_L + Z_R),
// for the traction τ along the face, common to both sides; the energy there follows from its jump (Miyoshi & Kusano,
// Journal of Computational Physics 208, 2005, solve the same five waves for magnetohydrodynamics).
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise {

/// One side of a face: velocity along the normal and along the face, pressure along the normal, energy per volume.
template <class T>
struct MixtureSide {
  T density, normal, tangential, pressure, energy;
  T speed;  // of the fastest wave
};

template <class T>
struct MixtureFlux {
  T mass, normal, tangential, energy;
};

/// traction: τ; stiffness: k_t ≥ 0.
template <class T>
MORTISE_INLINE MixtureFlux<T> mixture_flux(const MixtureSide<T>& L, const MixtureSide<T>& R, T traction, T stiffness) {
  const T sl = min(L.normal - L.speed, R.normal - R.speed), sr = max(L.normal + L.speed, R.normal + R.speed);
  const T al = L.density * (sl - L.normal), ar = R.density * (sr - R.normal);
  const T contact = ((R.pressure - L.pressure) + (al * L.normal - ar * R.normal)) / (al - ar);
  const auto left = contact >= 0;
  const auto of = [&](T l, T r) { return select(left, l, r); };
  const T density = of(L.density, R.density), normal = of(L.normal, R.normal),
          tangential = of(L.tangential, R.tangential);
  const T pressure = of(L.pressure, R.pressure), energy = of(L.energy, R.energy);
  // Beyond the fastest wave s becomes 0, and what follows the flux of the upwind state.
  const T s = of(min(sl, T{}), max(sr, T{}));
  const T inverse = 1.0 / (s - contact);
  const T k = contact * inverse, l = s * inverse;  // l = 1 + k
  const T d = s - normal, b = density * d, rise = b * (contact - normal);
  MixtureFlux<T> flux;
  flux.mass = b * k;
  flux.normal = flux.mass * normal + (pressure + l * rise);
  flux.energy = k * (energy * d - pressure * normal) + (l * (pressure + rise)) * contact;
  flux.tangential = flux.mass * tangential - traction;
  flux.energy = flux.energy - traction * tangential;
  // Between the waves of the tangential velocity.
  const T rl = max(al / (sl - contact), T{}), rr = max(ar / (sr - contact), T{});  // ρ*
  const T zl = sqrt(rl * stiffness), zr = sqrt(rr * stiffness), z = zl + zr;
  const T side = of(zl, zr), star = of(rl, rr);
  const T ct = side / max(star, T{} + 1e-300);
  const auto between = (abs(contact) < ct) & (sl < 0) & (sr > 0);
  const T over = 1.0 / select(between, z, T{} + 1.0);
  const T v = (zl * L.tangential + zr * R.tangential) * over,
          tau = traction + (zl * zr * over) * (R.tangential - L.tangential);
  const T ratio = abs(contact) / select(between, ct, T{} + 1.0);
  const T work = tau * v - traction * tangential;
  flux.tangential = select(between, flux.mass * v - tau, flux.tangential);
  flux.energy = select(between, flux.energy + traction * tangential + ratio * work - tau * v, flux.energy);
  return flux;
}

}  // namespace mortise
