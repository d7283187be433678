// HLLC Riemann solver (Toro, Spruce & Speares 1994; Toro, Riemann Solvers, 3rd ed., section 10.4) at a moving face with
// un-normalised area vector S (face.hpp), with Davis' signal speeds in the frame of the face,
//   s_L = min(q̂_L − c_L|S|, q̂_R − c_R|S|),   s_R = max(q̂_L + c_L|S|, q̂_R + c_R|S|).
// With a_K = ρ_K(s_K − q̂_K), the contact moves with ŝ = N/D,
//   D = a_L − a_R < 0,   N = (a_L q̂_L − p_L|S|²) − (a_R q̂_R − p_R|S|²).
// The state K upwind of the contact is L if N ≤ 0, else R. Replacing s_K by min(s_L, 0) or max(s_R, 0) makes the star
// formulas return the plain upwind flux in supersonic flow, so that one branch-free formula serves every regime:
// with r = (ŝ − q̂_K)/|S|², k = ŝ/(s_K − ŝ), l = s_K/(s_K − ŝ) = 1 + k (supersonic: k = −1, l = 0) and
// p* = p_K + a_K r,
//   ρ*ŝ                 = a_K k
//   (ρu)*ŝ + p*S        = a_K k u_K + (p_K + l a_K r) S
//   E*ŝ + p*(ŝ + w·S)   = k (E_K(s_K − q̂_K) − p_K q_K) + l p*(ŝ + w·S).
// All quotients come from the one reciprocal 1/(D Q), Q = s_K D − N. A contact at rest relative to the face is exact
// to the bit; the mirror image of a problem has the mirror image of its flux, to the bit.
#pragma once

#include "mortise/fluid/face.hpp"

namespace mortise {

struct Hllc {
  /// Flux from L to R through the face, ρ > 0 and p̃ > 0 on both sides. T is double or Pack.
  template <int Dim, class T, class Face>
  MORTISE_INLINE static Conserved<Dim, T> flux(const Primitive<Dim, T>& L, const Primitive<Dim, T>& R, const Face& face,
                                               double gamma) {
    const T cl = face.scaled(sound_speed(L, gamma)), cr = face.scaled(sound_speed(R, gamma));
    const T ql = face.relative(face.normal(L.velocity)), qr = face.relative(face.normal(R.velocity));
    const T sl = min(ql - cl, qr - cr), sr = max(ql + cl, qr + cr);
    const T al = L.density * (sl - ql), ar = R.density * (sr - qr);
    const T D = al - ar;
    const T N = (al * ql - face.times_area2(L.pressure)) - (ar * qr - face.times_area2(R.pressure));

    const auto left = N <= 0;
    Primitive<Dim, T> K;
    K.density = select(left, L.density, R.density);
    for (std::size_t d = 0; d < Dim; ++d) K.velocity[d] = select(left, L.velocity[d], R.velocity[d]);
    K.pressure = select(left, L.pressure, R.pressure);
    const T s = select(left, min(sl, T{}), max(sr, T{}));
    const T q = select(left, ql, qr);
    return upwind_flux(K, q, s, D, N, face, gamma);
  }

 private:
  template <int Dim, class T, class Face>
  MORTISE_INLINE static Conserved<Dim, T> upwind_flux(const Primitive<Dim, T>& K, T q, T s, T D, T N, const Face& face,
                                                      double gamma) {
    const T sD = s * D;
    const T Q = sD - N;
    const T inverse = 1.0 / (D * Q);
    const T over_q = D * inverse;
    const T contact = N * (Q * inverse), k = N * over_q, l = sD * over_q;
    const T d = s - q;
    const T a = K.density * d;
    const T rise = a * face.over_area2(contact - q);  // p* − p
    T speed2 = K.velocity[0] * K.velocity[0];
    for (std::size_t i = 1; i < Dim; ++i) speed2 = speed2 + K.velocity[i] * K.velocity[i];
    const T energy = (1 / (gamma - 1)) * K.pressure + (0.5 * K.density) * speed2;

    Conserved<Dim, T> flux;
    flux.density = a * k;
    for (std::size_t i = 0; i < Dim; ++i) flux.momentum[i] = flux.density * K.velocity[i];
    face.add_normal(flux.momentum, K.pressure + l * rise);
    flux.energy = k * (energy * d - K.pressure * face.absolute(q)) + (l * (K.pressure + rise)) * face.absolute(contact);
    return flux;
  }
};

}  // namespace mortise
