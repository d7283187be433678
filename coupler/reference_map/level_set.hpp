// Signed distance from the outline of a body in its reference frame, tabulated, and the share of the solid in a blur
// zone around it.
#pragma once

#include "mortise/grids/core/simd.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// φ < 0 inside. Exact at the nodes of a table but for single precision, bilinear between them: what many bodies look
/// up in every step has to fit into caches.
class LevelSet {
 public:
  /// `spacing` of the table, which reaches `margin` beyond the outline; lengths.
  LevelSet(const Outline& outline, double spacing, double margin);

  /// φ(X); beyond the table that of the nearest point in it, and the distance to that on top.
  double operator()(double x, double y) const;
  Pack operator()(Pack x, Pack y) const;
  const Box<2>& box() const { return box_; }  // of the table
  std::size_t memory_bytes() const { return values_.size() * sizeof(float); }

 private:
  Box<2> box_;
  double inverse_spacing_;
  Index<2> cells_;
  std::vector<float> values_;  // at nodes, x fastest
};

/// 1 − H_w(φ), H_w(φ) = ½ (1 + φ/w + sin(πφ/w)/π) for |φ| < w, 0 below and 1 above: the share of the solid (Rycroft,
/// Wu, Yu & Kamrin, Journal of Fluid Mechanics 898, A9, 2020). T is double or Pack.
template <class T>
MORTISE_INLINE T solid_share(T phi, double inverse_width) {
  const T s = min(max(T(phi * inverse_width), T{} - 1.0), T{} + 1.0), z = s * s;
  // sin(πs)/π = s (1 − s²) q(s²), q the polynomial through its values at Chebyshev points: error < 1e-15.
  T q = T{} + 6.4218275501706846e-09;
  for (const double c : {-2.4467886945260794e-07, 6.728589143555615e-06, -1.4169814958218653e-04, 2.204381872602208e-03,
                         -2.3943465637457653e-02, 1.6680835843039404e-01, -6.449340668480547e-01, 1.0})
    q = q * z + c;
  return 0.5 * ((1.0 - s) - (s * (1.0 - z)) * q);
}

}  // namespace mortise
