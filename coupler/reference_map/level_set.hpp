// Signed distance from the outline of a body in its reference frame, tabulated, and the share of the solid in a blur
// zone around it.
#pragma once

#include <numbers>

#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// φ < 0 inside. Exact at the nodes of a table, bilinear between them.
class LevelSet {
 public:
  /// `spacing` of the table, which reaches `margin` beyond the outline; lengths.
  LevelSet(const Outline& outline, double spacing, double margin);

  /// φ(X); beyond the table that of the nearest point in it, and the distance to that on top.
  double operator()(double x, double y) const;
  const Box<2>& box() const { return box_; }  // of the table
  std::size_t memory_bytes() const { return values_.size() * sizeof(double); }

 private:
  Box<2> box_;
  double inverse_spacing_;
  Index<2> cells_;
  std::vector<double> values_;  // at nodes, x fastest
};

/// 1 − H_w(φ), H_w(φ) = ½ (1 + φ/w + sin(πφ/w)/π) for |φ| < w, 0 below and 1 above: the share of the solid (Rycroft,
/// Wu, Yu & Kamrin, Journal of Fluid Mechanics 898, A9, 2020).
inline double solid_share(double phi, double inverse_width) {
  const double s = phi * inverse_width;
  if (s <= -1) return 1;
  if (s >= 1) return 0;
  return 0.5 * (1 - s - std::sin(std::numbers::pi * s) / std::numbers::pi);
}

}  // namespace mortise
