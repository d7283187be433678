// The solids of a scene, those alone and those with an interface, and all deforming interfaces, advanced together.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mortise/coupler/deforming.hpp"
#include "mortise/coupler/elastic_structure.hpp"

namespace mortise {

/// An elastic solid, in a gas or alone.
struct SolidSetup {
  ElasticSetup elastic;
  ElasticFunction initial;                  // at t = 0
  std::optional<InterfaceSetup> interface;  // of the fitted grid's south side; without: the solid is alone
};

/// Any other structure, coupled in the same way.
struct StructureSetup {
  std::function<std::unique_ptr<Structure>(const Communicator&)> make;
  InterfaceSetup interface;
};

class DeformingScene {
 public:
  using Steps = std::vector<DeformingInterface::Step>;  // per interface
  using Traces = std::span<const std::vector<WallTrace<2>>>;  // per interface

  /// Throws InputError.
  DeformingScene(const Communicator& comm, const std::vector<SolidSetup>& solids, const std::vector<StructureSetup>& structures,
                 const EulerSetup<2>& fluid, PhaseTimers& timers);

  std::size_t interfaces() const { return interfaces_.size(); }
  const std::vector<std::unique_ptr<ElasticSolver>>& solids() const { return solids_; }

  void initialize();
  /// Velocities of the interfaces at t = 0.
  void start(Traces traces, const WallLaw& law);
  /// Δt ≤ CFL / rate of the fluid's steps: structures that take substeps do not count.
  double rate(double fluid_rate) const;
  /// Size of the structures' step that begins or runs at `time` if it may not pass `limit`, and its end: the fluid's steps
  /// may not pass that. Infinite where no structure waits for the fluid.
  struct Stride {
    double size, end;
  };
  Stride stride(double time, double limit, double fluid_rate, double cfl) const;
  /// Steps of the structures within one of the fluid, where none waits for it; per interface.
  std::vector<int> substeps(double dt, double cfl) const;

  std::vector<BodyPath<2>> present() const;
  std::vector<BodyPath<2>> predicted(double dt) const;
  /// The schemes' answers for a step of the fluid within the stride; structures whose rate needs it take substeps.
  /// Throws NumericalError.
  Steps solve(Traces traces, const WallLaw& law, double time, double dt, const Stride& stride, double cfl);
  std::vector<BodyPath<2>> paths(const Steps& steps) const;
  /// Advances solids and structures whose step ends now; nothing is final until accept(). False: not admissible.
  /// Collective.
  bool advance(const Steps& steps, double time, double dt, const Stride& stride);
  void reject(const Steps& steps);
  /// time: after the step.
  void accept(const Steps& steps, double time, double dt, const Stride& stride);
  /// Why an interface has no answer in these steps, or the first bad cell of a structure.
  std::string first_bad_cell(const Steps& steps) const;

  /// Bound of what the changes of velocity add to the fluid's wave rates.
  double extra_rate(const Steps& steps) const;
  /// The interface that moves faster than `speed`, or nothing.
  std::string faster_than(double speed, const Steps& steps) const;
  /// Fastest wave of the solids' stress-free states.
  double fastest_wave() const;
  double least_j() const;

  std::vector<InterfaceState> states() const;
  std::int64_t computed() const;  // cells in the last step, on this rank
  std::int64_t skipped() const;

  std::vector<double> motion_state() const;
  const double* resume(const double* state, double time);

 private:
  struct Member {
    std::unique_ptr<Structure> structure;
    std::unique_ptr<DeformingInterface> interface;
    double spacing = 0;  // of the fluid's grid
  };
  int substeps_of(const Member& member, double dt, double cfl) const;
  DeformingInterface::Pace pace_of(const Member& member, double time, double dt, const Stride& stride, double cfl) const;

  PhaseTimers& timers_;
  std::vector<SolidSetup> setups_;
  std::vector<std::unique_ptr<ElasticSolver>> solids_;
  std::vector<ElasticSolver*> alone_;  // without an interface
  std::vector<int> interface_of_;      // per solid; −1: alone
  std::vector<Member> interfaces_;
  double begun_ = 0, stride_ = 0, end_ = 0;  // of the structures' step that is under way; stride_ = 0: none is
  std::int64_t computed_ = 0, skipped_ = 0;
};

}  // namespace mortise
