// One MUSCL-Hancock step of the Euler equations on one tile (the only hot loop of the fluid solver), second order:
// limited slopes of (ρ, u, p̃) → positivity → half step → Riemann problems at the (moving) faces → update
// (reconstruction.hpp, hllc.hpp, hlle.hpp, exact_flux.hpp; *_kernel.hpp for the loops).
// * Stencil: the new value of cell (i, j) depends on the cells (i + a, j + b) with |a| + |b| ≤ 2 and on no others; on a
// line
//   on |a| ≤ 2; next to a wall also on (i ± 1, 2). Ghosts behind a wall are not read.
// * Reproducible: the same cells give the same bits whatever the size of the tile and their place in it; uniform flow
// on
//   Cartesian tiles and lines stays uniform to the bit, on moving curvilinear ones to round-off; mirrored flow on them
//   has the mirrored answer to the bit with Hllc.
// * CFL: Δt · rate ≤ 1, usually 0.9. Limiter::none is for smooth flow only: it is not positive at strong shocks.
#pragma once

#include <cstdint>

#include "mortise/grids/core/limiters.hpp"
#include "mortise/fluid/state.hpp"
#include "mortise/grids/forest/field.hpp"

namespace mortise {

enum class RiemannSolver { hllc, exact, hlle };

struct StepOptions {
  double gamma = 1.4;
  Limiter limiter = Limiter::mc;
  RiemannSolver riemann = RiemannSolver::hllc;
  std::array<double, 4> van_albada_floor{};  // ε² = K h³ q_ref² for ρ, u, v, p̃ (Limiter::van_albada only)
};

struct StepResult {
  double rate = 0;  // max over active cells of Σ_d (|u_d − w_d| + c)/h_d after the step; Δt = CFL / rate; ∞ if
                    // not admissible. Curvilinear: Σ_d (|(u − w)·S_d| + c|S_d|)/V, S at half time, V after it
  bool admissible = true;  // ρ > 0 and p̃ > 0 (and finite) in all active cells after the step
};

/// A side of a tile that is a solid wall whose flux is (0, p n, p w·n), p given per face (shifted pressure p̃ ... the
/// caller passes the physical p + p∞). Slopes normal to the wall come from the three cells next to it (wall_slope.hpp),
/// so between two walls there are at least three cells.
struct WallSide {
  bool present = false;
  const double* pressure = nullptr;  // p̃ per wall face, indexed by the cell along the wall (1D: one number)
};

/// Data of one tile for one step. Pointers are to the tile's component planes (`plane` doubles apart, see TileShape);
/// ghost cells (2 layers, corners included) are filled. `next` and `now` do not overlap. Cells with active == 0 keep
/// their value: next = now. Only active cells count in the result. Tiles are an even number of cells wide. Ghosts and
/// slack of the rows of `next` are overwritten with what `now` has there. May be called from several threads at once.
template <int Dim>
struct CartesianTile {
  const TileShape<Dim>* shape;
  const double* now;
  double* next;
  std::array<double, Dim> spacing;
  const std::uint8_t* active = nullptr;  // indexed by shape->at(); nullptr: all cells active
};
template <int Dim>
StepResult godunov_step(const CartesianTile<Dim>& tile, double dt, const StepOptions& options);

/// 1D only: uniform cells that move together with velocity w; either end may be a wall (cell 0 / last cell).
struct MovingLineTile {
  CartesianTile<1> line;
  double velocity = 0;  // w of all faces, constant over the step
  WallSide left, right;
};
StepResult godunov_step(const MovingLineTile& tile, double dt, const StepOptions& options);

/// 2D curvilinear cells, nodes moving on straight lines during the step. Node arrays are indexed by
/// nodes->at(i, j), nodes = TileShape<2>({cells[0] + 1, cells[1] + 1}): node (i, j) is the lower left corner of cell
/// (i, j), ghost nodes −2 … cells + 2 included. x, y: positions at t + Δt/2; wx, wy: velocities (nullptr both: at
/// rest). South side (j = 0) may be a wall; the others may be mirrors: walls whose pressure is that of the Riemann problem
/// with the mirror image of the gas, through which no mass passes (north: to the bit, west and east: but for round-off).
/// Ghosts beyond mirrors are read and should hold mirror images.
struct CurvilinearTile {
  const TileShape<2>* shape;
  const TileShape<2>* nodes;
  const double* now;
  double* next;
  const double *x, *y;
  const double *wx, *wy;
  const std::uint8_t* active = nullptr;
  WallSide south;
  bool west_mirror = false, east_mirror = false, north_mirror = false;
};
StepResult godunov_step(const CurvilinearTile& tile, double dt, const StepOptions& options);

/// max over active cells of Σ_d (|u_d − w_d| + c)/h_d of the state `now` (for the first Δt and after a restart);
/// 0 / inadmissible reported as in StepResult. x, y at t, wx, wy as above.
template <int Dim>
StepResult wave_rate(const CartesianTile<Dim>& tile, const StepOptions& options);
StepResult wave_rate(const MovingLineTile& tile, const StepOptions& options);
StepResult wave_rate(const CurvilinearTile& tile, const StepOptions& options);

/// Fluid state at the wall faces of the cells along a wall: extrapolated to the face at t, and at t + Δt/2 by the
/// Hancock half step in the frame of the moving face. Where an extrapolated state has ρ or p̃ ≤ 0 the cell average is
/// used.
struct WallTrace2 {
  Primitive<2> now, half;
};
struct WallTrace1 {
  Primitive<1> now, half;
};
/// x, y here are node positions at time t. traces: cells[0] entries. Uses the limiter of the options along the wall.
void wall_traces(const CurvilinearTile& tile, double dt, const StepOptions& options, WallTrace2* traces);
/// Left or right end of a 1D tile.
WallTrace1 wall_trace(const MovingLineTile& tile, bool right_end, double dt, const StepOptions& options);

}  // namespace mortise
