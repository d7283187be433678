// Row loops of the two projections over one tile. Arrays and overwriting as in momentum.hpp; 1/ρ is that of `density`
// (cells, one ghost layer), or 1/fluid_density everywhere where it is nullptr.
#pragma once

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/forest/field.hpp"

namespace mortise {

struct ProjectionTile {
  const TileShape<2>* shape = nullptr;
  Point<2> spacing{};
  const double* density = nullptr;
  const double* divergence = nullptr;  // ∇·v to be had in cells, one ghost layer, 0 beyond sides; nullptr: 0
  double fluid_density = 1;
};

/// right = ∫ divergence − ∮ v · n over the cells' edges, times the fluid's density where it is constant (the matrix has
/// density 1 then).
void fill_edge_divergence(const ProjectionTile& tile, const double* x_edges, const double* y_edges, double* right);

/// Edge-normal velocities −= (1/ρ) ∇q on all edges of the tile; q at cells with one ghost layer.
void correct_edges(const ProjectionTile& tile, const double* q, double* x_edges, double* y_edges);

/// right_a = (1/Δt) ∫ (∇φ_a · v* + φ_a divergence) at nodes 0 … nx by 0 … ny, φ_a bilinear, v* constant in cells (one
/// ghost layer); times the fluid's density where it is constant.
void fill_nodal_divergence(const ProjectionTile& tile, double dt, const double* star, double* right);

/// velocity = v* − (Δt/ρ) ∇p on the tile's cells, ∇p the mean over the cell.
void correct_velocity(const ProjectionTile& tile, double dt, const double* star, const double* p, double* velocity);

/// Of the velocities in a tile: the largest |u| and |v|, infinity if any value is not finite, and ∫ρ|v|² with the
/// fluid's density.
struct FlowMeasure {
  Point<2> largest = Point<2>::Zero();
  double energy = 0;
};
FlowMeasure measure(const ProjectionTile& tile, const double* velocity);

}  // namespace mortise
