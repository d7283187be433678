// Incompressible Navier-Stokes equations with variable density on one uniform grid, second order in space and time:
//   ρ (v_t + (v·∇)v) = −∇p + ∇·(σ + μ(∇v + ∇vᵀ)) + f + ρ g,   ∇·v = 0.
// Per step (Rycroft, Wu, Yu & Kamrin, J. Fluid Mech. 898 (2020) A9):
//   1. predict edge velocities at t + Δt/2 (edge_prediction.hpp) with the last pressure;
//   2. MAC projection of the edge-normal velocities, density of time t;
//   3. solids, if any, are carried with them and give density and stresses at t + Δt/2 (solids.hpp);
//   4. v* = v + Δt(−∇·(v v) + (∇·σ + f)/ρ + g) at t + Δt/2, without pressure. Viscous stress by the explicit midpoint
//   rule: of
//      v + ½Δt(−∇·(v v) + all forces with the last pressure). It needs no history and allows Δt ≤ 1/(2ν(h_x⁻² +
//      h_y⁻²)), twice the limit of an Adams-Bashforth step;
//   5. v = v* − (Δt/ρ)∇p, p at nodes from bilinear elements. The whole p is found anew each step, not an increment: the
//      projection is approximate, and what it leaves of ∇·v is projected again instead of adding up in p.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "mortise/coupler/reference_map/flow_grid.hpp"
#include "mortise/coupler/reference_map/incompressible_setup.hpp"
#include "mortise/coupler/reference_map/momentum.hpp"
#include "mortise/coupler/reference_map/pressure_solver.hpp"
#include "mortise/coupler/reference_map/projection.hpp"
#include "mortise/coupler/reference_map/solids.hpp"
#include "mortise/grids/core/timers.hpp"

namespace mortise {

/// Velocity and pressure at a point.
struct FlowSample {
  Point<2> velocity;
  double pressure;
};

/// What a flow has taken so far.
struct FlowCounts {
  std::int64_t steps = 0;
  std::int64_t edge_iterations = 0, node_iterations = 0;  // of the pressure solvers, MAC and nodal
};

class IncompressibleSolver {
 public:
  /// solids: nullptr or to outlive the solver. Without solids the density is constant: there is no density field, and
  /// the pressure solver "transform" does not iterate. Throws InputError, see check(IncompressibleSetup). Collective.
  IncompressibleSolver(const IncompressibleSetup& setup, const Communicator& comm, Solids* solids = nullptr);

  /// The initial state: velocities of the setup made free of divergence, and the pressure that belongs to them (of the
  /// accelerations at t = 0, so that the first step is second order). To be called once before advance(). Collective.
  void initialize();

  /// 1/Δt of the largest step allowed by advection, viscosity, acceleration from rest and solids; 0 without any limit.
  double rate() const;

  /// One step of at most `limit` (finite, > 0). Returns Δt. Throws NumericalError when velocities are not finite or a
  /// pressure solver fails. Collective.
  double advance(double limit);

  double time() const { return time_; }
  const ComponentGrid<2>& grid() const { return flow_.grid(); }
  const Field<2>& velocity() const { return velocity_; }  // u, v at cell centres, two ghost layers filled
  const Field<2>& pressure() const { return pressure_; }  // at nodes, numbered as in PressureSolver; of t − Δt/2
  const Field<2>* density() const { return fields_ ? &fields_->density : nullptr; }  // nullptr: constant
  const EdgeVelocities& edges() const { return edges_; }                             // of the last step
  const FlowCounts& counts() const { return counts_; }
  PhaseTimers& timers() { return timers_; }

  /// Bilinear between cell centres (v) and nodes (p). Empty on ranks that do not own the point's cell.
  std::optional<FlowSample> sample(const Point<2>& place) const;

  /// What a continued run needs of a local tile: u and v (cells), p (nodes 0 … nx by 0 … ny), MAC correction (cells).
  std::vector<double> state(int tile) const;
  /// The inverse for all local tiles, in place of initialize(): the run goes on bit by bit. states[t]: of local tile t.
  /// Solids must have been brought to their own state before; their full_step() is called. Throws InputError on wrong
  /// sizes.
  void restore(double time, const std::vector<std::vector<double>>& states);

 private:
  void predict(double dt);
  void project_edges();
  void carry_solids(double dt);
  void advance_star(double dt);
  void find_pressure(double dt, bool inflow);
  void project_velocity(double dt);
  void complete_fields();
  void measure_flow();
  void prepare_stress(const Field<2>& velocity);
  ForceTile force_tile(int tile, const Field<2>& velocity) const;
  ProjectionTile projection_tile(int tile) const;

  IncompressibleSetup setup_;
  FlowGrid flow_;
  Solids* solids_;
  double time_ = 0;
  Point<2> largest_ = Point<2>::Zero();  // |u|, |v| anywhere
  double energy_ = 0;                  // ∫ρ|v|² with the fluid's density: what errors of pressures are measured by
  Point<2> given_ = Point<2>::Zero();  // the same of velocities given at sides
  double largest_viscosity_ = 0;       // kinematic
  Field<2> velocity_, slopes_, acceleration_, advection_, middle_, star_;
  Field<2> pressure_, nodal_right_, correction_, edge_right_;
  EdgeVelocities edges_;
  std::unique_ptr<SolidFields> fields_;            // with solids
  std::unique_ptr<Field<2>> stress_x_, stress_y_;  // with solids: all of the stress but the pressure
  std::unique_ptr<PressureSolver> edge_solver_, node_solver_;
  FlowCounts counts_;
  PhaseTimers timers_;
};

}  // namespace mortise
