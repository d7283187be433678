// HLLE Riemann solver (Harten, Lax & van Leer 1983; Einfeldt 1988) at a moving face with un-normalised area vector S:
//   F = (s_R F_L − s_L F_R + s_L s_R (U_R − U_L))/(s_R − s_L),
//   s_L = min(0, q̂_L − c_L|S|, q̃ − c̃|S|),   s_R = max(0, q̂_R + c_R|S|, q̃ + c̃|S|),
// with averages of weights √ρ (Toro, Riemann Solvers, 3rd ed., equations 10.51-10.54): q̃ that of q̂, and
// c̃² that of c² plus ½ √ρ_L√ρ_R/(√ρ_L + √ρ_R)² (q̂_R − q̂_L)²/|S|². Keeps ρ and p̃ positive; smears contacts.
#pragma once

#include "mortise/fluid/face.hpp"

namespace mortise {

struct Hlle {
  /// Flux from L to R through the face, ρ > 0 and p̃ > 0 on both sides. T is double or Pack.
  template <int Dim, class T, class Face>
  MORTISE_INLINE static Conserved<Dim, T> flux(const Primitive<Dim, T>& L, const Primitive<Dim, T>& R, const Face& face,
                                               double gamma) {
    const T cl = sound_speed(L, gamma), cr = sound_speed(R, gamma);
    const T ql = face.relative(face.normal(L.velocity)), qr = face.relative(face.normal(R.velocity));
    const T root_l = sqrt(L.density), root_r = sqrt(R.density);
    const T weight = 1.0 / (root_l + root_r);
    const T wl = root_l * weight, wr = root_r * weight;
    const T jump = qr - ql;
    const T roe_speed = wl * ql + wr * qr;
    const T spread = (0.5 * wl * wr) * face.over_area2(jump * jump);
    const T roe_sound = face.scaled(sqrt((wl * (cl * cl) + wr * (cr * cr)) + spread));
    const T sl = min(T{}, min(ql - face.scaled(cl), roe_speed - roe_sound));
    const T sr = max(T{}, max(qr + face.scaled(cr), roe_speed + roe_sound));

    const T inverse = 1.0 / (sr - sl);
    const T from_l = sr * inverse, from_r = -(sl * inverse), mixing = sl * from_l;
    return combined(weighted(L, ql, from_l, mixing, face, gamma), weighted(R, qr, from_r, -mixing, face, gamma));
  }

 private:
  /// α F − β U of one side.
  template <int Dim, class T, class Face>
  MORTISE_INLINE static Conserved<Dim, T> weighted(const Primitive<Dim, T>& W, T q, T alpha, T beta, const Face& face,
                                                   double gamma) {
    T speed2 = W.velocity[0] * W.velocity[0];
    for (std::size_t d = 1; d < Dim; ++d) speed2 = speed2 + W.velocity[d] * W.velocity[d];
    const T energy = (1 / (gamma - 1)) * W.pressure + (0.5 * W.density) * speed2;
    const T advection = alpha * q - beta;
    Conserved<Dim, T> sum;
    sum.density = W.density * advection;
    for (std::size_t d = 0; d < Dim; ++d) sum.momentum[d] = sum.density * W.velocity[d];
    face.add_normal(sum.momentum, alpha * W.pressure);
    sum.energy = energy * advection + (alpha * W.pressure) * face.absolute(q);
    return sum;
  }
  template <int Dim, class T>
  MORTISE_INLINE static Conserved<Dim, T> combined(Conserved<Dim, T> a, const Conserved<Dim, T>& b) {
    a.density = a.density + b.density;
    for (std::size_t d = 0; d < Dim; ++d) a.momentum[d] = a.momentum[d] + b.momentum[d];
    a.energy = a.energy + b.energy;
    return a;
  }
};

}  // namespace mortise
