// The numbers of one cell (or of a vector of cells) in the kernels of elastic_step.hpp: velocity and what stands for
// the deformation, σ or F; their half slopes; and the geometry of the half step.
#pragma once

#include "mortise/grids/core/limiters.hpp"
#include "mortise/solid/plane_tensors.hpp"

namespace mortise::elastic {

/// (v, σ) or (v, F).
template <class D, class T>
struct State {
  Vector<T> velocity;
  D deformation;  // SymmetricTensor σ or Tensor F
};

/// What a system without null modes keeps of them.
struct Nothing {};
MORTISE_INLINE Nothing operator-(Nothing, Nothing) { return {}; }

/// Half slopes along the two grid directions: what takes a cell's value to its faces.
template <class State>
struct Slopes {
  State xi, eta;
};

/// Area vectors of the half step: factor_d S_d = Δt/V times the mean area vector of the two faces across direction d.
template <class Xi, class Eta, class T>
struct HalfStepMetrics {
  Xi xi;
  Eta eta;
  T factor_xi, factor_eta;
};

template <class D, class T>
MORTISE_INLINE State<D, T> operator+(const State<D, T>& a, const State<D, T>& b) {
  return {a.velocity + b.velocity, a.deformation + b.deformation};
}
template <class D, class T>
MORTISE_INLINE State<D, T> operator-(const State<D, T>& a, const State<D, T>& b) {
  return {a.velocity - b.velocity, a.deformation - b.deformation};
}

/// f(a, b, c) component by component.
template <class T, class F>
MORTISE_INLINE Vector<T> each(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c, F f) {
  return {f(a.x, b.x, c.x), f(a.y, b.y, c.y)};
}
template <class T, class F>
MORTISE_INLINE SymmetricTensor<T> each(const SymmetricTensor<T>& a, const SymmetricTensor<T>& b,
                                       const SymmetricTensor<T>& c, F f) {
  return {f(a.xx, b.xx, c.xx), f(a.xy, b.xy, c.xy), f(a.yy, b.yy, c.yy)};
}
template <class T, class F>
MORTISE_INLINE Tensor<T> each(const Tensor<T>& a, const Tensor<T>& b, const Tensor<T>& c, F f) {
  return {f(a.xx, b.xx, c.xx), f(a.xy, b.xy, c.xy), f(a.yx, b.yx, c.yx), f(a.yy, b.yy, c.yy)};
}
template <class D, class T, class F>
MORTISE_INLINE State<D, T> each(const State<D, T>& a, const State<D, T>& b, const State<D, T>& c, F f) {
  return {each(a.velocity, b.velocity, c.velocity, f), each(a.deformation, b.deformation, c.deformation, f)};
}
/// a where the mask is true, b elsewhere.
template <class Mask, class D, class T>
MORTISE_INLINE State<D, T> choose(Mask m, const State<D, T>& a, const State<D, T>& b) {
  return each(a, b, b, [m](T x, T y, T) { return select(m, x, y); });
}

template <Limiter limiter, class State>
MORTISE_INLINE State half_slopes(const State& before, const State& here, const State& after) {
  return each(before, here, after, []<class T>(T a, T b, T c) {
    if constexpr (limiter == Limiter::none)
      return T(0.25 * (c - a));
    else
      return half_slope<limiter>(b - a, c - b, 0.0);
  });
}

}  // namespace mortise::elastic
