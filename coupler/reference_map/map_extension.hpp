// Continuation of a reference map beyond its body, one layer of cells after the other: a cell next to one that holds ξ
// gets the value of a weighted least-squares plane through those of its 24 neighbours that hold ξ already.
#pragma once

#include "mortise/coupler/reference_map/tile_window.hpp"
#include "mortise/grids/core/simd.hpp"

namespace mortise {

/// Components of a map's field: ξ_x, ξ_y, φ(ξ), and the layer: 0 inside, 1, 2, … in the band around, `unknown_layer`
/// elsewhere.
inline constexpr double unknown_layer = 99;

/// det ∂ξ/∂x of the cells from offset k on, by central differences; stride: of the map's rows.
MORTISE_INLINE Pack map_determinant(const TileBlock& map, std::size_t k, std::ptrdiff_t stride,
                                    const Point<2>& spacing) {
  const double *const x = map.component(0) + k, *const y = map.component(1) + k;
  const Pack twice = (load(x + 1) - load(x - 1)) * (load(y + stride) - load(y - stride)) -
                     (load(x + stride) - load(x - stride)) * (load(y + 1) - load(y - 1));
  return (0.25 / (spacing[0] * spacing[1])) * twice;
}

/// Fills the cells of layer `number` in the window (without ghosts) of a tile: ξ and the layer. Cells that have a
/// neighbour of a lower layer but too few neighbours for a plane are left, and counted: the return value.
/// `largest_jump` > 0 (0: all count): only neighbours count whose ξ differs from that of the nearest one by at most so
/// much times their distance in cells (map_branches.hpp).
int extend_layer(const TileShape<2>& shape, const TileWindow& window, int number, TileBlock& map, double largest_jump);

}  // namespace mortise
