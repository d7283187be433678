// One MUSCL-Hancock step of an elastic solid on one tile, in the reference frame, second order.
//
//   linear        ρ v_t = div σ,    σ_t = C : ∇v,   u_t = v        components v_x v_y σ_xx σ_xy σ_yy u_x u_y
//   hyperelastic  ρ0 v_t = Div P(F), F_t = ∇_X v,   u_t = v        components v_x v_y F_xx F_xy F_yx F_yy u_x u_y
//
// slopes (limited, or the plain central difference) → half step with the cell's own fluxes → Riemann problem of the
// linearised waves at every face: with traction t = σN or PN and Z = √(ρ0 Γ) of the mean of the two sides,
//   t* = ½(t_L + t_R) + ½ Z (v_R − v_L),   v* = ½(v_L + v_R) + ½ Z⁻¹ (t_R − t_L),
// and for (v, F) the flux of F gets the upwinding of what no wave carries, without which sawtooth null modes of F grow:
//   k (c_p/2) ([F] − Γ⁻¹ (dP/dF : [F]) N ⊗ N),
// [·] = right − left face state at t. With face states at t the jump is O(h³) in smooth flow; with those at t + ½Δt it
// is O(hΔt), for the half step changes all of a cell alike, and since prescribed faces have no such flux F would be
// first-order in the cells next to them. Then the update; u with the half-time v.
// * Stencil |di| + |dj| ≤ 2 as in the fluid. Ghosts (2 layers) are filled by the caller everywhere.
// * Where a side of the tile is a physical boundary the caller may prescribe (t*, v*) per face instead (SideFlux).
// * Reproducible: the same cells give the same bits whatever the tile and their place in it; uniform states stay so on
//   Cartesian tiles to the bit.
// * CFL: Δt · rate ≤ 1.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mortise/grids/forest/field.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Slope limiters in a solid; none is the plain central difference (linear waves stay stable with it).
enum class ElasticLimiter { none, minmod, mc };

struct ElasticOptions {
  Material material;
  ElasticLimiter limiter = ElasticLimiter::none;
  double null_mode_upwinding = 0.5;  // k above, for (v, F)
};

/// Number of components of the field: 7 for StressLaw::linear, 8 otherwise.
int elastic_components(StressLaw law);
/// Component numbers of the displacement u_x (u_y is the next one).
int displacement_component(StressLaw law);

/// West, east, south, north side of a tile.
enum class Side { west, east, south, north };

/// Prescribed solution at the faces of one side of a tile, indexed by the cell along the side: traction on the
/// *outward* reference normal per reference area, and velocity. nullptr: not prescribed.
struct SideFlux {
  const Point<2>* traction = nullptr;
  const Point<2>* velocity = nullptr;
  bool present() const { return traction != nullptr; }
};

/// One tile for one step. Pointers are to component planes (`plane` doubles apart, see TileShape). Cells with
/// active == 0 keep their value. Cartesian when x == nullptr; otherwise x, y are reference node positions, indexed by
/// nodes->at(i, j), nodes = TileShape<2>({cells[0] + 1, cells[1] + 1}), ghost nodes −2 … cells + 2 included. Tiles are
/// an even number of cells wide. Ghosts and slack of the rows of `next` are overwritten with what `now` has there.
struct ElasticTile {
  const TileShape<2>* shape = nullptr;
  const TileShape<2>* nodes = nullptr;
  const double* now = nullptr;
  double* next = nullptr;
  std::array<double, 2> spacing{};
  const double *x = nullptr, *y = nullptr;
  const std::uint8_t* active = nullptr;  // indexed by shape->at(); nullptr: all cells active
  std::array<SideFlux, 4> sides{};       // by Side
};

struct ElasticStepResult {
  double rate = 0;         // max over active cells of Σ_d c_p(direction d)/h_d after the step; Δt = CFL/rate; ∞ if
                           // not admissible. Curvilinear: Σ_d c_p|S_d|/V, S_d the mean of two opposite faces
  bool admissible = true;  // finite, and J > 0 for (v, F), in all active cells after the step
  double least_j = 1;      // smallest J of the active cells after the step (1 for linear); ∞ if none is active
};

ElasticStepResult elastic_step(const ElasticTile& tile, double dt, const ElasticOptions& options);

/// rate, admissible and least_j of the state `now`.
ElasticStepResult elastic_rate(const ElasticTile& tile, const ElasticOptions& options);

/// The solid at one boundary face, at t and at t + ½Δt by the same slopes and half step as in elastic_step().
struct ElasticTrace {
  Point<2> velocity, traction;          // at t + ½Δt; traction on the outward reference normal
  Point<2> velocity_now, traction_now;  // the same at t
  Point<2> tangent, tangent_now;        // F T, T the unit tangent with the solid on its left; zero: linear elasticity does not know it
  Eigen::Matrix2d admittance;           // Z⁻¹ at t + ½Δt
};

/// traces: one per cell along the side (cells[0] for south and north, cells[1] for west and east).
void elastic_traces(const ElasticTile& tile, Side side, double dt, const ElasticOptions& options, ElasticTrace* traces);

/// Fills the two ghost layers beyond one side of the tile so that the slope normal to it is the second-order one-sided
/// difference of the three cells next to it: a₋₁ = 3a₀ − 3a₁ + a₂, a₋₂ = 3a₋₁ − 3a₀ + a₁. With a limiter other than
/// none a₋₁ = a₀ − d, a₋₂ = a₋₁ − d with the same d limited by the inner differences (ghost_extrapolation.cpp).
/// `along_low`, `along_high`: range of the cells along the side (may include ghosts, −2 … cells + 2).
void extrapolate_ghosts(const TileShape<2>& shape, TileBlock& block, Side side, int along_low, int along_high,
                        const ElasticOptions& options);

}  // namespace mortise
