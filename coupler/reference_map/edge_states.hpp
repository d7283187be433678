// States on cell edges: Taylor expansion from a cell's centre over half an edge distance and half a step, and the
// choice between the two sides. Pure functions of double or Pack. Source: Rycroft, Wu, Yu & Kamrin, J. Fluid Mech. 898
// (2020) A9.
#pragma once

#include "mortise/grids/core/simd.hpp"

namespace mortise {

/// Velocity at an edge, split along the edge's normal and tangent (both in the positive direction of their axis).
template <class T>
struct EdgeState {
  T normal, tangential;
};

/// q + ½(1 − C) δ: the value at the edge in the positive direction half a step later, as far as the normal derivative
/// tells; δ is the undivided slope, C = v Δt/h the signed Courant number.
template <class T>
MORTISE_INLINE T ahead(T q, T slope, T courant) {
  return q + 0.5 * (1.0 - courant) * slope;
}
/// q − ½(1 + C) δ: the same at the edge in the negative direction.
template <class T>
MORTISE_INLINE T behind(T q, T slope, T courant) {
  return q - 0.5 * (1.0 + courant) * slope;
}

/// Godunov's choice between the state on the low and on the high side of an edge: the side the fluid comes from; where
/// the two sides part or meet, no normal velocity and the mean of the tangential ones.
template <class T>
MORTISE_INLINE EdgeState<T> upwind(const EdgeState<T>& low, const EdgeState<T>& high) {
  const T sum = low.normal + high.normal;
  const auto from_low = (low.normal > 0) & (sum > 0);
  const auto from_high = (high.normal < 0) & (sum < 0);
  return {select(from_low, low.normal, select(from_high, high.normal, T{})),
          select(from_low, low.tangential,
                 select(from_high, high.tangential, T(0.5 * (low.tangential + high.tangential))))};
}

}  // namespace mortise
