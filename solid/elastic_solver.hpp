// An elastic solid in the reference frame: a Cartesian grid, a grid fitted to one curve, or both overlapping, donors
// being found once. Owns grids, overlap and fields. The south side (layer 0) of the fitted grid may be an interface:
// what happens there the coupler decides.
//
// The composite of a disk, an ellipse or a stick is a Cartesian core and a grid grown inward from the outline; that of
// a plate with a hole a Cartesian plate and a grid grown outward from the hole.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mortise/grids/core/timers.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/geometry/cell_mean.hpp"
#include "mortise/grids/overlap/overlap.hpp"
#include "mortise/solid/cell_finder.hpp"
#include "mortise/solid/elastic_boundary.hpp"

namespace mortise {

/// (v, σ or F, u) as a function of reference position and time; as many numbers as the field has components.
using ElasticState = std::array<double, 8>;
using ElasticFunction = std::function<ElasticState(const Point<2>& X, double t)>;

struct ElasticSetup {
  std::string name;
  ElasticOptions options;
  // Cartesian grid; cells {0, 0}: none
  Box<2> domain;
  Index<2> cells{}, tile{};
  std::array<ElasticSide, 4> sides;  // of the Cartesian grid, by Side
  // Fitted grid; nullptr: none. Layer 0 lies on the curve.
  std::shared_ptr<const GrownGrid> fitted;
  std::array<ElasticSide, 4> fitted_sides;  // of the fitted grid, by Side; west and east only if it is open
  // How the two overlap; nullptr when there is only one. Its grid is *fitted.
  std::shared_ptr<const BodyAtlas> atlas;
  OverlapOptions overlap;
  ElasticFunction exact;  // for ElasticBoundary::exact
  bool skip = true;       // leave out tiles in which nothing changes
  bool smooth = false;    // initial and exact states: cells get their mean, not the value at the centre
};

struct ElasticStepCount {
  std::int64_t computed = 0, skipped = 0;  // active cells, on this rank
};

class ElasticSolver {
 public:
  /// Throws InputError when cells and tiles do not fit, or the fitted grid is folded.
  ElasticSolver(const Communicator& comm, ElasticSetup setup, PhaseTimers& timers);

  /// Sets every cell from a function of reference position. Throws NumericalError for orphans and for J ≤ 0.
  void initialize(const ElasticFunction& initial, double time);

  /// max over ranks of Σ_d c_p/h_d; Δt = CFL / rate.
  double rate() const;
  /// Smallest J in the solid (1 for linear elasticity). Collective.
  double least_j() const;

  /// The solid at the interface faces (fitted grid, south side), in the order of the grid's cells, on every rank.
  /// Collective.
  std::vector<ElasticTrace> interface_traces(double dt);

  /// Advances by dt; the interface faces have traction (on the outward reference normal, per reference area) and
  /// velocity. The new state is kept aside until commit(). Returns false when it is not admissible. Collective.
  bool step(const std::vector<Point<2>>& traction, const std::vector<Point<2>>& velocity, double dt);
  /// Accepts the last step; `time` after it. Interpolates, fills ghosts.
  void commit(double time);
  /// Remembers the present state, and goes back to it, whatever has been committed since.
  void remember();
  void go_back();
  /// Grid, index, reference position and state of the first inadmissible cell of the rejected step. Collective.
  std::string first_bad_cell() const;

  const ElasticSetup& setup() const { return setup_; }
  StressLaw law() const { return setup_.options.material.law; }
  int components() const;
  const std::vector<ComponentGrid<2>>& grids() const { return grids_; }
  std::vector<Field<2>>& fields() { return now_; }
  const std::vector<Field<2>>& fields() const { return now_; }
  std::vector<std::vector<double>>& rates() { return rates_; }
  /// After fields and rates were replaced from outside (restart): refills ghosts.
  void resume(double time);
  const ElasticStepCount& last_count() const { return count_; }
  std::size_t memory_bytes() const;

  /// Reference position of the centre of a cell (index in its local tile), and its reference area.
  Point<2> cell_center(int grid, int tile, const Index<2>& cell) const;
  double cell_volume(int grid, int tile, const Index<2>& cell) const;
  Corners<2> cell_corners(int grid, int tile, const Index<2>& cell) const;
  /// Grid-wide reference node (i, j) of a grid.
  Point<2> node(int grid, int i, int j) const;
  /// Share of a cell when overlapping cells are summed; 1 where there is one grid.
  double share(int grid, const Point<2>& X) const;
  /// All components at reference points; NaN outside the solid. Collective.
  std::vector<ElasticState> sample(std::span<const Point<2>> points) const;

 private:
  using PerTile = std::vector<std::vector<double>>;  // per grid, tile

  // elastic_solver.cpp
  void append_grids();
  void interpolate();
  void fill_holes();
  Field<2>& field(int grid) { return now_[static_cast<std::size_t>(grid)]; }
  const ComponentGrid<2>& grid_of(int grid) const { return grids_[static_cast<std::size_t>(grid)]; }
  template <class Visit>
  void for_each_tile(Visit&& visit) const {
    for (std::size_t g = 0; g < grids_.size(); ++g)
      for (int t = 0; t < now_[g].tiles(); ++t) visit(static_cast<int>(g), t);
  }

  // elastic_ghosts.cpp
  void fill_ghosts(double time);
  void extrapolate(int grid, int tile);
  void fill_exact(int grid, int tile, double time);
  bool at_edge(int grid, int tile, Side side) const;
  const ElasticSide* boundary(int grid, int tile, Side side) const;

  // elastic_advance.cpp
  ElasticTile view(int grid, int tile);
  void solve_boundaries(int grid, int tile, ElasticTile& view, double dt);
  void solve_boundary(int grid, int tile, Side side, const ElasticSide& what, ElasticTile& view, double dt);
  bool quiet(int grid, int tile, const ElasticTile& view) const;
  std::string bad_cell_of_tile(int grid, int tile, const TileBlock& block) const;
  std::string first_bad_cell(const std::vector<Field<2>>& fields, bool computed_only) const;

  // elastic_geometry.cpp
  void build_nodes();
  Point<2> tile_node(int grid, int tile, int i, int j) const;
  ElasticState state_of_cell(const ElasticFunction& of, int grid, int tile, const Index<2>& cell, double time) const;
  bool find_stencil(const Point<2>& X, Index<2>& center, std::array<double, 2>& offset) const;
  ElasticState interpolated(const TileBlock& block, const TileShape<2>& shape, const Index<2>& center,
                            const std::array<double, 2>& offset) const;

  Communicator comm_;
  ElasticSetup setup_;
  PhaseTimers& timers_;
  std::vector<ComponentGrid<2>> grids_;
  std::vector<Field<2>> now_, next_;
  std::vector<GhostExchange<2>> exchanges_;
  std::unique_ptr<Overlap<2>> overlap_;                                 // when there are two grids
  std::unique_ptr<CellFinder> finder_;                                  // when there is only a fitted one
  std::vector<TileShape<2>> node_shapes_;                               // per grid
  std::vector<std::vector<std::array<std::vector<double>, 2>>> nodes_;  // per grid, tile; empty for the Cartesian one
  ElasticState rest_{};                                                 // of a solid at rest without stress
  double time_ = 0;
  std::array<std::vector<Point<2>>, 4> traction_, velocity_;  // at the sides of the tile at hand
  std::vector<ElasticTrace> traces_;                          // along one of them
  PerTile rates_, new_rates_;
  PerTile least_j_, new_least_j_;
  std::vector<std::vector<std::uint8_t>> computed_;  // per grid, tile: in the last step
  struct Memory {
    std::vector<Field<2>> fields;                  // per grid; of the tiles changed since
    std::vector<std::vector<std::uint8_t>> holds;  // per grid, tile: it is one of them
    PerTile rates, least_j;
    double time = 0;
  } memory_;
  ElasticStepCount count_;
};

}  // namespace mortise
