// What solids are to the incompressible flow: they are carried by its velocity, and give back a density, a viscosity,
// stresses on cell edges and a body force. The flow knows nothing else of them.
#pragma once

#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

/// Velocities on cell edges of all local tiles, at the middle of the step. In a tile of nx × ny cells:
///   x: components (u, v) on the west edges of cells, offset at(i, j), 0 ≤ i ≤ nx, 0 ≤ j < ny (i = nx: the tile's east
///   side); y: components (u, v) on the south edges of cells, offset at(i, j), 0 ≤ i < nx, 0 ≤ j ≤ ny.
/// The normal components (u of x, v of y) have the divergence of SolidFields to the tolerance of the pressure solver; the other
/// ones are upwinded and not projected.
struct EdgeVelocities {
  Field<2> x, y;
};

/// What solids contribute, on the tiles of the flow's grid. The solids write the cells of a tile (0 ≤ i < nx, 0 ≤ j <
/// ny) and the edges numbered as in EdgeVelocities, those at i = nx and j = ny included; the solver fills what lies
/// beyond the tile. Where nothing is written the last values stay.
struct SolidFields {
  Field<2> density;  // 1 component, cells: density of the blend, > 0
  Field<2> viscosity;  // 2 components: μ of the blend on west and on south edges, ≥ 0; the solver adds μ(∇v + ∇vᵀ)
  Field<2> stress_x;    // 2 components, west edges: (σ_xx, σ_xy) without the viscous part above and without pressure
  Field<2> stress_y;    // 2 components, south edges: (σ_xy, σ_yy)
  Field<2> force;       // 2 components, cells: force per area beyond gravity (which is ρ times the setup's)
  Field<2> divergence;  // 1 component, cells: ∇·v to be had, where a solid's volume has drifted and comes back; else 0
};

/// Solids in an incompressible flow. All members are called on every rank.
///
/// Sequence of a step from t to t + Δt:
///   1. the flow predicts edge velocities at t + Δt/2 with the fields as they are (time t), and projects them with the
///      densities of time t: the correction is itself O(Δt²), since the lagged pressure gradient is in the prediction,
///      so that the age of the density costs O(Δt³);
///   2. half_step();
///   3. the flow takes stresses, force and density of these fields for the momentum and the nodal projection
///      ρ (v^{n+1} − v*) = −Δt ∇p: for second order they have to be those of t + Δt/2;
///   4. full_step().
class Solids {
 public:
  virtual ~Solids() = default;

  /// Once, before the first step: writes all fields for the initial state. They hold the fluid's density and viscosity,
  /// and zeros.
  virtual void begin(SolidFields& fields) = 0;

  /// Carries the solids from `time` to time + dt with the edge velocities, and writes the fields for time + dt/2.
  virtual void half_step(const EdgeVelocities& edges, double time, double dt, SolidFields& fields) = 0;

  /// After the velocities (components u, v at cell centres, two ghost layers filled) have come to `time`: may write the
  /// fields for `time`, which the prediction of the next step uses. Without it the prediction uses those of the last
  /// half step, which costs stability of stiff solids before it costs order.
  virtual void full_step(const Field<2>& velocity, double time, SolidFields& fields) {
    (void)velocity, (void)time, (void)fields;
  }

  /// The fastest rate of the solids: a step is at most cfl/rate() (stress waves: c/h). Not negative; 0: no limit.
  virtual double rate() const = 0;
};

}  // namespace mortise
