// Row loops over one tile of an incompressible flow. Arrays are given by their component 0; offsets as in TileShape,
// other components `plane` doubles further. Every loop runs in whole vectors: entries around those named are
// overwritten.
#pragma once

#include <array>

#include "mortise/coupler/reference_map/slopes.hpp"
#include "mortise/grids/core/types.hpp"
#include "mortise/grids/forest/field.hpp"

namespace mortise {

/// slopes: δ_x u, δ_x v, δ_y u, δ_y v of the tile's cells from velocities with two ghost layers.
void fill_slopes(const TileShape<2>& shape, FlowSlopes kind, const double* velocity, double* slopes);

/// Forces on the fluid per mass, a = −∇p/ρ + ∇·σ/ρ + f/ρ + g.
struct ForceTile {
  const TileShape<2>* shape = nullptr;
  Point<2> spacing{}, gravity{};
  double inverse_density = 1, viscosity = 0;  // of the fluid, where there are no solids: ∇·σ = μ∇²v
  const double* velocity = nullptr;           // u, v with two ghost layers
  const double* pressure = nullptr;           // at nodes; nullptr: without ∇p
  // With solids (otherwise nullptr):
  const double* density = nullptr;     // at cells
  const double* stress_x = nullptr;    // (σ_xx, σ_xy) on west edges, all of it
  const double* stress_y = nullptr;    // (σ_xy, σ_yy) on south edges, all of it
  const double* body_force = nullptr;  // at cells
};

/// acceleration = a on the cells −1 … nx by −1 … ny.
void fill_acceleration(const ForceTile& tile, double* acceleration);

/// Stress on the edges around the cells −1 … nx by −1 … ny: given + μ(∇v + ∇vᵀ), second order. viscosity: on west (0)
/// and south edges (1).
void fill_stress(const TileShape<2>& shape, const Point<2>& spacing, const double* velocity, const double* viscosity,
                 const double* given_x, const double* given_y, double* stress_x, double* stress_y);

/// advection = −∇·(v v) of the cells from edge velocities.
void fill_advection(const TileShape<2>& shape, const Point<2>& spacing, const double* x_edges, const double* y_edges,
                    double* advection);

/// result = velocity + c (a + b), two components each, on the tile's cells.
void add_rates(const TileShape<2>& shape, const double* velocity, double c, const double* a, const double* b,
               double* result);

/// star = velocity + dt (advection + a) with the forces `a` of `tile` on the tile's cells, a from tile.velocity.
void advance_momentum(const ForceTile& tile, const double* velocity, double dt, const double* advection, double* star);

}  // namespace mortise
