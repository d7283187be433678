// Gas and elastic solids as one continuum on the background: the monolithic alternative to coupling at interfaces. The
// fluid's solver advances tiles without solids, skips quiet ones and fills ghosts; tiles near a body are advanced here.
//
// One step, t → t + Δt:
//   begin   maps at t + Δt/2, with the velocities at t
//   step    mixture_step.hpp, tile by tile (called by the fluid's solver)
//   finish  maps at t + Δt from those at the half, with the velocities at t + Δt; what solids take of the cells
#pragma once

#include <memory>
#include <vector>

#include "mortise/coupler/reference_map/mixture_step.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/core/timers.hpp"

namespace mortise {

/// A solid of a reference-map scene.
struct MappedBody {
  std::string name;
  Material material;
  std::shared_ptr<const LevelSet> level_set;             // of its outline in the reference frame
  std::function<Point<2>(const Point<2>& x)> reference;  // ξ at t = 0; NaN where it is not defined
  std::function<Point<2>(const Point<2>& X)> velocity;   // at t = 0, by reference position
};

struct ReferenceMapSetup {
  std::vector<MappedBody> bodies;
  double blur = 0;      // half width of the blur zone, a length
  double pressure = 0;  // p̃_e: the solids are free of stress in gas of this pressure
};

class ReferenceMapScene : public TileStepper<2> {
 public:
  /// Attaches itself to the fluid's solver, which is not owned. Throws InputError for laws other than hyperelastic
  /// ones.
  ReferenceMapScene(ReferenceMapSetup setup, EulerSolver<2>& fluid, PhaseTimers& timers);

  /// The fluid holds gas everywhere: puts the solids into it. Throws InputError where they overlap. Collective.
  void initialize(const StateFunction<2>& gas);
  /// False: a solid would turn inside out. Collective.
  bool begin(double dt);
  /// After the fluid has committed the step. Throws NumericalError. Collective.
  void finish(double dt, double time);
  /// After fields were replaced from outside (restart). Collective.
  void resume(double time);

  bool covers(int tile) const override;
  StepResult step(const CartesianTile<2>& cells, int tile, double dt, const StepOptions& options) override;
  StepResult rate(const CartesianTile<2>& cells, int tile, const StepOptions& options) override;

  const ReferenceMapSetup& setup() const { return setup_; }
  const std::vector<std::unique_ptr<BodyMap>>& maps() const { return maps_; }
  /// composition::Component planes at present, on the tiles that are covered.
  const Field<2>& composition() const { return composition_; }
  /// Energy per depth that was given to gas squeezed beside solids since the start, on this rank.
  double restored_energy() const { return restored_; }
  /// Cells beside bodies without enough neighbours to continue the map into, in the last step, on this rank.
  std::int64_t orphans() const;
  std::size_t memory_bytes() const;

 private:
  const ComponentGrid<2>& grid() const { return fluid_.grids().front(); }
  BodyMap::Velocity velocities();
  std::vector<TileBody> bodies_on(int tile, bool half) const;
  void compose_all();
  void settle(double time);
  CartesianTile<2> view(int tile);
  MixtureTile mixture(const CartesianTile<2>& cells, int tile, std::span<const TileBody> bodies) const;

  ReferenceMapSetup setup_;
  EulerSolver<2>& fluid_;
  PhaseTimers& timers_;
  std::vector<std::unique_ptr<BodyMap>> maps_;
  Field<2> composition_;
  GhostExchange<2> exchange_;
  std::vector<double> velocity_[2];  // of the tile at hand
  double restored_ = 0;
};

}  // namespace mortise
