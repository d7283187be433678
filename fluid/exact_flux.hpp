// Godunov's flux from the exact Riemann solution (exact_riemann.hpp) at a moving face with area vector S: (ρ, q, p̃) is
// the state on the ray x/t = w·n in the direction n = S/|S|, the tangential velocity that of the side K upwind of the
// contact, u = u_K + (q − q_K) S/|S|²,
//   F = (ρq̂, ρq̂u + p̃S, Ẽq̂ + p̃q).
// Vacuum between the two states is allowed.
#pragma once

#include <cmath>
#include <limits>

#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/fluid/face.hpp"

namespace mortise {

struct ExactRiemann {
  /// Flux from L to R through the face. T is double or Pack; a state with ρ or p̃ not positive gives NaN.
  template <int Dim, class T, class Face>
  __attribute__((noinline)) static Conserved<Dim, T> flux(const Primitive<Dim, T>& L, const Primitive<Dim, T>& R,
                                                          const Face& face, double gamma) {
    const T length = face.scaled(T{} + 1.0), swept = face.absolute(T{});
    const T ql = face.normal(L.velocity), qr = face.normal(R.velocity);
    Primitive<1, T> star;
    T from_left{};
    for (int k = 0; k < lanes<T>; ++k) {
      const double size = lane(length, k);
      const Upwind at_face =
          solve({lane(L.density, k), {lane(ql, k) / size}, lane(L.pressure, k)},
                {lane(R.density, k), {lane(qr, k) / size}, lane(R.pressure, k)}, lane(swept, k) / size, gamma);
      set_lane(star.density, k, at_face.state.density);
      set_lane(star.velocity[0], k, at_face.state.velocity[0] * size);
      set_lane(star.pressure, k, at_face.state.pressure);
      set_lane(from_left, k, at_face.left ? 1.0 : 0.0);
    }
    const auto left = from_left > 0;
    std::array<T, Dim> velocity;
    for (std::size_t d = 0; d < Dim; ++d) velocity[d] = select(left, L.velocity[d], R.velocity[d]);
    face.add_normal(velocity, face.over_area2(star.velocity[0] - select(left, ql, qr)));
    return physical_flux<Dim, T>(star, velocity, face, gamma);
  }

 private:
  struct Upwind {
    Primitive<1> state;  // on the ray of the face
    bool left;           // the contact passes the face to the right
  };

  static Upwind solve(const Primitive<1>& L, const Primitive<1>& R, double speed, double gamma) {
    if (!(L.density > 0 && L.pressure > 0 && R.density > 0 && R.pressure > 0) ||
        !std::isfinite(L.velocity[0] + R.velocity[0] + L.pressure + R.pressure)) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      return {{nan, {nan}, nan}, true};
    }
    const StarState star = exact_star_state(L, R, gamma);
    return {sample(star, L, R, gamma, speed), speed <= star.velocity};
  }

  template <int Dim, class T, class Face>
  static Conserved<Dim, T> physical_flux(const Primitive<1, T>& star, const std::array<T, Dim>& velocity,
                                         const Face& face, double gamma) {
    const T advection = face.relative(star.velocity[0]);
    T speed2 = velocity[0] * velocity[0];
    for (std::size_t d = 1; d < Dim; ++d) speed2 = speed2 + velocity[d] * velocity[d];
    const T energy = (1 / (gamma - 1)) * star.pressure + (0.5 * star.density) * speed2;
    Conserved<Dim, T> F;
    F.density = star.density * advection;
    for (std::size_t d = 0; d < Dim; ++d) F.momentum[d] = F.density * velocity[d];
    face.add_normal(F.momentum, star.pressure);
    F.energy = energy * advection + star.pressure * star.velocity[0];
    return F;
  }
};

}  // namespace mortise
