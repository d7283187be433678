// An elastic solid in the reference frame: a Cartesian grid, a grid fitted to one curve, or both overlapping, donors
// being found once. Owns grids, overlap and fields. The south side (layer 0) of the fitted grid may be an interface:
// what happens there the coupler decides.
//
// The composite of a disk, an ellipse or a stick is a Cartesian core and a grid grown inward from the outline; that of a
// plate with a hole a Cartesian plate and a grid grown outward from the hole.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mortise/grids/core/timers.hpp"
#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/overlap.hpp"
#include "mortise/solid/elastic_step.hpp"

namespace mortise {

/// What happens on a side that is no interface.
enum class ElasticBoundary {
  periodic,      // the ghost exchange fills it
  displacement,  // v* given (fixed: zero), traction from the solid
  traction,      // t* given (free: zero), velocity from the solid
  slip,          // v*·n = 0 and no shear traction; a plane of symmetry is the same
  exact,         // ghost cells hold the state of a given function
  interface      // (t*, v*) from the coupler; south of the fitted grid only
};

/// (v, σ or F, u) as a function of reference position and time; as many numbers as the field has components.
using ElasticState = std::array<double, 8>;
using ElasticFunction = std::function<ElasticState(const Point<2>& X, double t)>;
/// Prescribed boundary velocity or traction: a function of reference position, outward reference normal and time.
using BoundaryFunction = std::function<Point<2>(const Point<2>& X, const Point<2>& N, double t)>;

/// One side of a grid.
struct ElasticSide {
  ElasticBoundary kind = ElasticBoundary::traction;
  BoundaryFunction value;  // displacement: its velocity; traction: it. Empty: zero
};

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
  /// Grid-wide reference node (i, j) of a grid.
  Point<2> node(int grid, int i, int j) const;
  /// Share of a cell when overlapping cells are summed; 1 where there is one grid.
  double share(int grid, const Point<2>& X) const;
  /// All components at reference points; NaN outside the solid. Collective.
  std::vector<ElasticState> sample(std::span<const Point<2>> points) const;

 private:
  // the author's
  ElasticSetup setup_;
  std::vector<ComponentGrid<2>> grids_;
  std::vector<Field<2>> now_, next_;
  std::vector<std::vector<double>> rates_;
  ElasticStepCount count_;
};

}  // namespace mortise
