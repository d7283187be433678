// The Euler equations on an overlapping set of component grids: a Cartesian background and grids fitted to bodies that
// move rigidly. Owns grids, overlap and fields. Knows poses, not bodies: what moves the bodies is the coupler's affair.
#pragma once

#include <memory>
#include <vector>

#include "mortise/fluid/boundary.hpp"
#include "mortise/fluid/godunov_step.hpp"
#include "mortise/grids/core/timers.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/overlap.hpp"

namespace mortise {

/// A grid fitted to a body: which body and how its inner edge is treated.
template <int Dim>
struct FittedBody {
  std::string name;
  OverlapBody<Dim> shape;
  bool wall = true;  // slip wall; otherwise exact data on the inner edge
  // 2D, in place of shape.atlas: the grid of a scene without background and overlap, whose other sides are boundaries.
  std::shared_ptr<const GrownGrid> mesh;
  std::array<BoundaryKind, 4> sides{BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::wall,
                                    BoundaryKind::wall};  // of `mesh`: west, east, south (the wall), north
};

template <int Dim>
struct EulerSetup {
  Gas gas;
  StepOptions options;
  Boundaries<Dim> boundaries;
  Box<Dim> domain;
  Index<Dim> cells{};       // of the background; 0: there is none (and no overlap)
  Index<Dim> tile{};        // cells of a background tile; divides `cells`
  OverlapOptions overlap;
  bool skip = true;         // leave out quiet and hole tiles
  std::vector<FittedBody<Dim>> bodies;
};

/// Where a body is during a step: poses at its ends.
template <int Dim>
struct BodyPath {
  Pose<Dim> start, end;
  // Deforming grids (2D; poses are the identity): nodes at the end, those at the start are the solver's own; nodes move on
  // straight lines. nullptr: rigid. `atlas`: of the same grid, for the overlap; nullptr in scenes without.
  std::shared_ptr<const GrownGrid> end_mesh = nullptr;
  std::shared_ptr<const Atlas<Dim>> end_atlas = nullptr;
};

/// Fluid at one wall face of a body.
template <int Dim>
struct WallTrace {
  Primitive<Dim> now, half;
};

struct StepCount {
  std::int64_t computed = 0;  // active cells of tiles that were computed, on this rank
  std::int64_t skipped = 0;   // cells of tiles left out
};

namespace detail {
template <int Dim>
struct FittedTileOf;
template <>
struct FittedTileOf<1> {
  using type = MovingLineTile;
};
template <>
struct FittedTileOf<2> {
  using type = CurvilinearTile;
};
}  // namespace detail

/// What the step kernel takes for a tile of a body grid.
template <int Dim>
using FittedTile = typename detail::FittedTileOf<Dim>::type;

template <int Dim>
class EulerSolver {
 public:
  static constexpr int components = euler_components<Dim>;
  using Values = std::array<double, static_cast<std::size_t>(components)>;

  /// Throws InputError when cells and tiles do not fit.
  EulerSolver(const Communicator& comm, EulerSetup<Dim> setup, PhaseTimers& timers);

  /// Sets every cell from a function of position (ρ, u, p̃); cuts holes for the poses. Throws NumericalError for orphans.
  void initialize(const StateFunction<Dim>& initial, const std::vector<Pose<Dim>>& poses, double time);

  /// max over all ranks of Σ_d (|u_d − w_d| + c)/h_d for the present state; Δt = CFL / rate.
  double rate() const;
  /// Recomputes the rates of all tiles (at the start).
  void measure_rates(const std::vector<BodyPath<Dim>>& paths, double dt);

  /// Fluid at the wall faces of every body (per body, in the order of its faces), the walls moving from path.start
  /// with the velocity of `paths` over dt. Collective; the same on every rank.
  std::vector<std::vector<WallTrace<Dim>>> wall_traces(const std::vector<BodyPath<Dim>>& paths, double dt);

  /// Advances every grid by dt while bodies follow `paths`; `pressure` holds p̃ on the wall faces of every body. The new
  /// state is kept aside until commit(). Returns false when a density or pressure is not positive. Collective.
  bool step(const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure, double dt);
  /// Accepts the last step: bodies at `poses`, time after the step. Cuts, interpolates, fills ghosts.
  void commit(const std::vector<Pose<Dim>>& poses, double time);
  /// Grid, index, position and state of the first inadmissible cell of the rejected step; empty if there is none. Collective.
  std::string first_bad_cell(const std::vector<BodyPath<Dim>>& paths) const;

  const std::vector<ComponentGrid<Dim>>& grids() const { return grids_; }
  std::vector<Field<Dim>>& fields() { return now_; }
  const std::vector<Field<Dim>>& fields() const { return now_; }
  std::vector<std::vector<double>>& rates() { return rates_; }
  const Overlap<Dim>& overlap() const { return *overlap_; }
  const EulerSetup<Dim>& setup() const { return setup_; }
  const StepCount& last_count() const { return count_; }
  std::size_t memory_bytes() const;
  /// After fields and rates were replaced from outside (restart): cuts without exposing anything, refills ghosts.
  void resume(const std::vector<Pose<Dim>>& poses, double time);
  /// Nodes of a local tile of a body grid for a pose, indexed by node_shape(grid).at().
  void place_nodes(int grid, int tile, const Pose<Dim>& pose, std::array<std::vector<double>, Dim>& nodes) const;
  const TileShape<Dim>& node_shape(int grid) const { return node_shapes_[static_cast<std::size_t>(grid)]; }
  /// Centre of cell (local index) of a tile for a pose of the grid's body.
  Point<Dim> cell_center(int grid, int tile, const Index<Dim>& cell, const Pose<Dim>& pose) const;
  double cell_volume(int grid, int tile, const Index<Dim>& cell) const;

 private:
  void fill_ghosts(double time);
  void fill_inner_edges(double time);
  void cut(const std::vector<Pose<Dim>>& poses, bool fresh);
  void interpolate();
  void blank_holes();
  bool quiet(int grid, int tile) const;
  std::string bad_cell_of_tile(int grid, int tile, const std::vector<BodyPath<Dim>>& paths) const;
  bool uniform(int grid, int tile, const TileBlock& block) const;
  void build_reference_nodes();
  void place(int grid, int tile, const BodyPath<Dim>& path, double dt, double theta);
  StepResult step_tile(int grid, int tile, const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure, double dt);
  CartesianTile<Dim> cartesian(int grid, int tile);
  FittedTile<Dim> fitted(int grid, int tile);

  Communicator comm_;
  EulerSetup<Dim> setup_;
  PhaseTimers& timers_;
  std::vector<ComponentGrid<Dim>> grids_;
  std::vector<Field<Dim>> now_, next_;
  std::vector<GhostExchange<Dim>> exchanges_;
  std::unique_ptr<Overlap<Dim>> overlap_;
  std::vector<std::vector<std::array<std::vector<double>, Dim>>> reference_;  // per grid, tile: nodes in the body frame
  std::vector<TileShape<Dim>> node_shapes_;                                   // per grid
  std::array<std::vector<double>, Dim> positions_, velocities_;               // of the nodes of the tile at hand
  std::vector<std::vector<double>> rates_;           // per grid, tile
  std::vector<std::vector<double>> new_rates_;
  std::vector<std::vector<std::uint8_t>> uniform_;   // per grid, tile: all cells hold one state
  std::vector<std::vector<std::uint8_t>> computed_;  // per grid, tile: in the last step
  std::vector<Pose<Dim>> poses_;
  Values filler_{};                                  // what holes contain
  StepCount count_;
};

}  // namespace mortise
