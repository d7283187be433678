// The Euler equations on component grids: either an overlapping set of a Cartesian background and grids fitted to bodies,
// or, without background, meshes that each fill the gas between a body and its own outer sides. Grids fitted to bodies
// move with them, rigidly or with every node on its own straight line. Owns grids, overlap and fields. Knows paths, not
// bodies: what moves the bodies is the coupler's affair.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mortise/fluid/boundary.hpp"
#include "mortise/fluid/godunov_step.hpp"
#include "mortise/fluid/tile_stepper.hpp"
#include "mortise/grids/core/timers.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/geometry/cell_mean.hpp"
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
  Index<Dim> tile{};        // cells of a background tile; divides `cells`. Without background: of a mesh's, 0: chosen
  OverlapOptions overlap;
  bool skip = true;         // leave out quiet and hole tiles
  bool smooth = false;      // the initial state: cells get its mean, not the value at the centre
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

/// Bodies that stay where they are.
template <int Dim>
std::vector<BodyPath<Dim>> resting(const std::vector<Pose<Dim>>& poses) {
  std::vector<BodyPath<Dim>> paths;
  for (const Pose<Dim>& pose : poses) paths.push_back({pose, pose});
  return paths;
}

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

  /// Throws InputError when cells and tiles, or meshes and their sides, do not fit.
  EulerSolver(const Communicator& comm, EulerSetup<Dim> setup, PhaseTimers& timers);

  /// Tiles of the background that `stepper` covers are advanced by it; not owned.
  void set_stepper(TileStepper<Dim>* stepper) { stepper_ = stepper; }

  /// Sets every cell from a function of position (ρ, u, p̃); cuts holes for bodies at the ends of the paths `at`. Throws
  /// NumericalError for orphans.
  void initialize(const StateFunction<Dim>& initial, const std::vector<BodyPath<Dim>>& at, double time);

  /// max over all ranks of Σ_d (|u_d − w_d| + c)/h_d for the present state; Δt = CFL / rate.
  double rate() const;
  /// Recomputes the rates of all tiles (at the start).
  void measure_rates(const std::vector<BodyPath<Dim>>& paths, double dt);

  /// Fluid at the wall faces of every body (per body, in the order of its faces), the walls moving from path.start
  /// with the velocity of `paths` over dt. Collective; the same on every rank.
  std::vector<std::vector<WallTrace<Dim>>> wall_traces(const std::vector<BodyPath<Dim>>& paths, double dt);

  /// Advances every grid by dt while bodies follow `paths`; `pressure` holds p̃ on the wall faces of every body. The new
  /// state is kept aside until commit(). Returns false when a density or pressure is not positive: that can be where gas
  /// is next to nothing, and then a step of first order gets over it. Collective.
  bool step(const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure, double dt, bool first_order = false);
  /// Accepts the last step: bodies at the ends of its paths, time after the step. Cuts, interpolates, fills ghosts.
  void commit(const std::vector<BodyPath<Dim>>& paths, double time);
  /// Grid, index, position and state of the first inadmissible cell of the rejected step; empty if there is none. Collective.
  std::string first_bad_cell(const std::vector<BodyPath<Dim>>& paths) const;

  const std::vector<ComponentGrid<Dim>>& grids() const { return grids_; }
  std::vector<Field<Dim>>& fields() { return now_; }
  const std::vector<Field<Dim>>& fields() const { return now_; }
  std::vector<std::vector<double>>& rates() { return rates_; }
  const Communicator& communicator() const { return comm_; }
  bool has_overlap() const { return overlap_ != nullptr; }
  const Overlap<Dim>& overlap() const { return *overlap_; }  // only where has_overlap()
  const EulerSetup<Dim>& setup() const { return setup_; }
  /// After values of cells were changed from outside: refills ghosts.
  void refresh(double time) { settle(time); }
  const StepCount& last_count() const { return count_; }
  std::size_t memory_bytes() const;
  /// After fields and rates were replaced from outside (restart): cuts without exposing anything, refills ghosts.
  void resume(const std::vector<BodyPath<Dim>>& at, double time);

  // What follows is about the present: the nodes and values since the last initialize(), commit() or resume().

  /// Node of a grid by its grid-wide index, on every rank; body grids are continued beyond their edges.
  Point<Dim> present_node(int grid, const Index<Dim>& node) const;
  /// Centre of cell (local index) of a local tile.
  Point<Dim> cell_center(int grid, int tile, const Index<Dim>& cell) const;
  /// The same were the grid's body at another pose.
  Point<Dim> cell_center(int grid, int tile, const Index<Dim>& cell, const Pose<Dim>& pose) const;
  double cell_volume(int grid, int tile, const Index<Dim>& cell) const;
  Corners<Dim> cell_corners(int grid, int tile, const Index<Dim>& cell) const;
  /// Nodes of a local tile of a body grid for a pose, indexed by node_shape(grid).at().
  void place_nodes(int grid, int tile, const Pose<Dim>& pose, std::array<std::vector<double>, Dim>& nodes) const;
  const TileShape<Dim>& node_shape(int grid) const { return node_shapes_[static_cast<std::size_t>(grid)]; }

  /// (ρ, u, p̃) at arbitrary points; NaN where there is no gas. Collective; all ranks pass the same points and get all values.
  std::vector<Values> sample(std::span<const Point<Dim>> points) const;
  /// Share of point x that a cell of `grid` stands for when cells of all grids are summed; 1 without overlap.
  double share(int grid, const Point<Dim>& x) const { return overlap_ ? overlap_->share(grid, x) : 1.0; }
  /// The overlap's report, or zeros without overlap. With census: also what is counted on request only; collective.
  OverlapReport overlap_report() const { return overlap_ ? overlap_->report() : OverlapReport{}; }
  OverlapReport overlap_census() const { return overlap_ ? overlap_->census() : OverlapReport{}; }

 private:
  bool special(int grid, int tile) const { return stepper_ && grids_[static_cast<std::size_t>(grid)].background() && stepper_->covers(tile); }
  bool has_background() const { return setup_.cells[0] > 0; }
  void append_background();
  void settle(double time);
  void move_bodies(const std::vector<BodyPath<Dim>>& paths);
  void fill_ghosts(double time);
  void fill_sides(int grid, double time);
  void fill_inner_edges(int grid, double time);
  void cut(bool fresh);
  void interpolate();
  void blank_holes();
  bool quiet(int grid, int tile) const;
  std::string bad_cell_of_tile(int grid, int tile, const std::vector<BodyPath<Dim>>& paths) const;
  bool uniform(int grid, int tile, const TileBlock& block) const;
  bool carries_wall(int grid, int tile) const;
  void build_reference_nodes();
  void read_nodes(const GrownGrid& mesh, int grid, int tile, std::array<std::vector<double>, Dim>& nodes) const;
  void place(int grid, int tile, const BodyPath<Dim>& path, double dt, double theta);
  Point<Dim> end_center(int grid, int tile, const Index<Dim>& cell, const BodyPath<Dim>& path) const;
  Pose<Dim> pose_of(int grid) const;
  Values value_in(int grid, int tile, const Index<Dim>& cell, const Point<Dim>& within) const;
  StepResult step_tile(int grid, int tile, const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure, double dt,
                       const StepOptions& options);
  StepResult restore_pressure(int grid, int tile);
  CartesianTile<Dim> cartesian(int grid, int tile);
  FittedTile<Dim> fitted(int grid, int tile);

  Communicator comm_;
  EulerSetup<Dim> setup_;
  PhaseTimers& timers_;
  std::vector<ComponentGrid<Dim>> grids_;
  std::vector<Field<Dim>> now_, next_;
  std::vector<GhostExchange<Dim>> exchanges_;
  std::unique_ptr<Overlap<Dim>> overlap_;            // nullptr: no background
  std::vector<std::shared_ptr<const GrownGrid>> meshes_;                      // per body (2D): its present grid, body frame
  std::vector<std::vector<std::array<std::vector<double>, Dim>>> reference_;  // per grid, tile: the same, nodes by direction
  std::vector<TileShape<Dim>> node_shapes_;                                   // per grid
  std::array<std::vector<double>, Dim> positions_, velocities_;               // of the nodes of the tile at hand
  std::vector<std::vector<double>> rates_;           // per grid, tile
  std::vector<std::vector<double>> new_rates_;
  std::vector<std::vector<std::uint8_t>> uniform_;   // per grid, tile: all cells hold one state
  std::vector<std::vector<std::uint8_t>> computed_;  // per grid, tile: in the last step
  std::vector<Pose<Dim>> poses_;
  Values filler_{};                                  // what holes contain
  StepCount count_;
  TileStepper<Dim>* stepper_ = nullptr;
};

}  // namespace mortise
