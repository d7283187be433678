// Geometry of a face as a Riemann solver sees it. Area vectors S are not normalised: with q = u·S, the face velocity w
// and q̂ = q − w·S all speeds are multiplied by |S|, and a flux is the flux through the whole face,
//   F = (ρq̂, ρq̂u + p̃S, Ẽq̂ + p̃q).
// Every face type has
//   normal(u) = u·S           relative(q) = q − w·S      absolute(s) = s + w·S
//   scaled(c) = c|S|          times_area2(x) = x|S|²     over_area2(x) = x/|S|²
//   add_normal(m, x): m += x S
#pragma once

#include <array>

#include "mortise/fluid/state.hpp"

namespace mortise {

/// Unit face normal to a coordinate axis, at rest: of a Cartesian cell.
template <int axis>
struct AxisFace {
  template <class T, std::size_t Dim>
  MORTISE_INLINE T normal(const std::array<T, Dim>& u) const {
    return u[axis];
  }
  template <class T>
  MORTISE_INLINE T relative(T q) const {
    return q;
  }
  template <class T>
  MORTISE_INLINE T absolute(T s) const {
    return s;
  }
  template <class T>
  MORTISE_INLINE T scaled(T c) const {
    return c;
  }
  template <class T>
  MORTISE_INLINE T times_area2(T x) const {
    return x;
  }
  template <class T>
  MORTISE_INLINE T over_area2(T x) const {
    return x;
  }
  template <class T, std::size_t Dim>
  MORTISE_INLINE void add_normal(std::array<T, Dim>& m, T x) const {
    m[axis] = m[axis] + x;
  }
};

/// Unit face on a line, moving with velocity w.
struct SlidingFace : AxisFace<0> {
  explicit SlidingFace(double velocity_) : velocity(velocity_) {}
  template <class T>
  MORTISE_INLINE T relative(T q) const {
    return q - velocity;
  }
  template <class T>
  MORTISE_INLINE T absolute(T s) const {
    return s + velocity;
  }
  double velocity;
};

/// Straight face in the plane with area vector S = (sx, sy) ≠ 0, sweeping the area `swept` = w·S per unit time.
template <class T>
struct PlaneFace {
  MORTISE_INLINE PlaneFace(T sx_, T sy_, T swept_) : sx(sx_), sy(sy_), swept(swept_), area2(sx * sx + sy * sy) {
    const T inverse = inverse_sqrt(area2);
    area = area2 * inverse;
    inverse_area2 = inverse * inverse;
  }
  MORTISE_INLINE T normal(const std::array<T, 2>& u) const { return u[0] * sx + u[1] * sy; }
  MORTISE_INLINE T relative(T q) const { return q - swept; }
  MORTISE_INLINE T absolute(T s) const { return s + swept; }
  MORTISE_INLINE T scaled(T c) const { return c * area; }
  MORTISE_INLINE T times_area2(T x) const { return x * area2; }
  MORTISE_INLINE T over_area2(T x) const { return x * inverse_area2; }
  MORTISE_INLINE void add_normal(std::array<T, 2>& m, T x) const {
    m[0] = m[0] + sx * x;
    m[1] = m[1] + sy * x;
  }
  T sx, sy, swept;
  T area2, area, inverse_area2;  // |S|², |S|, 1/|S|²
};

/// c = √(γp̃/ρ), computed as γp̃/√(γp̃ρ): no division.
template <int Dim, class T>
MORTISE_INLINE T sound_speed(const Primitive<Dim, T>& W, double gamma) {
  const T stiffness = gamma * W.pressure;
  return stiffness * inverse_sqrt(stiffness * W.density);
}

/// The state with its velocity relative to a plane face reflected.
template <class T>
MORTISE_INLINE Primitive<2, T> mirrored(const Primitive<2, T>& W, const PlaneFace<T>& face) {
  Primitive<2, T> image = W;
  face.add_normal(image.velocity, -2.0 * face.over_area2(face.relative(face.normal(W.velocity))));
  return image;
}

/// Flux through a solid wall that exerts the pressure p̃: (0, p̃S, p̃ w·S).
template <int Dim, class T, class Face>
MORTISE_INLINE Conserved<Dim, T> wall_flux(T pressure, const Face& face) {
  Conserved<Dim, T> flux{};
  face.add_normal(flux.momentum, pressure);
  flux.energy = pressure * face.absolute(T{});
  return flux;
}

}  // namespace mortise
