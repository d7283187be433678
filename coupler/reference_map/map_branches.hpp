// Where a body folds, or lies against itself, two parts of its surface are a few cells apart, and the band around one
// ends where that around the other begins: ξ jumps there. Nothing may be averaged across: what is half way between two
// parts of a body is inside it.
#pragma once

#include "mortise/coupler/reference_map/map_extension.hpp"

namespace mortise {

/// Neighbours are of the same part where their ξ differ by less than this many cells per cell between them; a body in
/// which none differ by more than `suspicious_jump` need not be asked.
inline constexpr double branch_jump = 4, suspicious_jump = 2.5;

/// ξ of the cells from offset k on, and which of their neighbours are of the same part.
class MapBranch {
 public:
  /// `spacing`: the larger one of the grid.
  MORTISE_INLINE MapBranch(const TileBlock& map, std::size_t k, double spacing)
      : x_(map.component(0) + k),
        y_(map.component(1) + k),
        layer_(map.component(3) + k),
        spacing2_(spacing * spacing) {}

  /// The squared distance of ξ to that of the neighbours `step` further, in cells.
  MORTISE_INLINE Pack jump2(std::ptrdiff_t step) const {
    const Pack dx = load(x_ + step) - load(x_), dy = load(y_ + step) - load(y_);
    return (1 / spacing2_) * (dx * dx + dy * dy);
  }
  MORTISE_INLINE PackMask known(std::ptrdiff_t step) const { return load(layer_ + step) < unknown_layer; }
  /// The neighbours `step` further, √`distance2` cells away, hold ξ and are of the same part.
  MORTISE_INLINE PackMask reaches(std::ptrdiff_t step, double distance2 = 1) const {
    return known(step) & (jump2(step) <= branch_jump * branch_jump * distance2);
  }
  /// All eight neighbours are.
  MORTISE_INLINE PackMask reaches_all(std::ptrdiff_t stride) const {
    return reaches(1) & reaches(-1) & reaches(stride) & reaches(-stride) & reaches(stride + 1, 2) &
           reaches(stride - 1, 2) & reaches(-stride + 1, 2) & reaches(-stride - 1, 2);
  }

 private:
  const double *x_, *y_, *layer_;
  double spacing2_;
};

/// Half the difference, in direction of `step`, of quantities q of neighbours on both sides that belong to the same
/// part; the whole one to that on the one side that does; 0 where none does.
MORTISE_INLINE Pack branch_slope(const MapBranch& branch, const double* q, std::ptrdiff_t step) {
  const PackMask ahead = branch.reaches(step), behind = branch.reaches(-step);
  const Pack forward = select(ahead, Pack(load(q + step) - load(q)), Pack{}),
             backward = select(behind, Pack(load(q) - load(q - step)), Pack{});
  return select(ahead & behind, broadcast(0.5), broadcast(1.0)) * (forward + backward);
}

/// The difference to the neighbour the flow comes from (from −step where `positive`), to the other one where that is of
/// another part.
MORTISE_INLINE Pack branch_upwind(const MapBranch& branch, const double* q, std::ptrdiff_t step, PackMask positive) {
  const PackMask ahead = branch.reaches(step), behind = branch.reaches(-step);
  const Pack forward = load(q + step) - load(q), backward = load(q) - load(q - step);
  const PackMask use_behind = behind & (positive | ~ahead);
  return select(use_behind, backward, select(ahead, forward, Pack{}));
}

/// det ∂ξ/∂x as map_determinant(), by branch_slope().
MORTISE_INLINE Pack branch_determinant(const TileBlock& map, std::size_t k, std::ptrdiff_t stride,
                                       const Point<2>& spacing) {
  const MapBranch branch(map, k, spacing.maxCoeff());
  const double *const x = map.component(0) + k, *const y = map.component(1) + k;
  return (1 / (spacing[0] * spacing[1])) * (branch_slope(branch, x, 1) * branch_slope(branch, y, stride) -
                                            branch_slope(branch, x, stride) * branch_slope(branch, y, 1));
}

}  // namespace mortise
