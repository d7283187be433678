// One deforming interface: a structure on one side, on the other a fluid grid whose layer 0 follows it.
//
// One step, t → t + Δt:
//   predict   the fluid's grid moves on as in the last step; half-time data of the fluid at its wall faces
//   solve     the scheme: pressures of the fluid's faces, tractions and velocities of the structure's
//   move      nodes x^{n+1} = x^n + Δt w of the interface, less wrinkles (interface_nodes.hpp); the fluid's grid grown anew from
//             it, or stretched
//   load      tractions from the pressures on the mean area vectors of the step: action = reaction to round-off
// The faster side may take several steps within one of the slower's, whose data are then linear in time, and the slower
// gets the mean of what the faster one got: second order, and the same impulse on both sides.
// * structure faster: its substeps are taken within the fluid's step; the fluid gets their mean pressure, its wall
//   their mean motion.
// * fluid faster: the structure waits over several steps of the fluid; its step then gets their mean traction.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mortise/coupler/interface_nodes.hpp"
#include "mortise/coupler/schemes.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/core/timers.hpp"

namespace mortise {

/// How an interface is coupled and how the fluid's grid follows it.
struct InterfaceSetup {
  std::string name;                 // in output: that of the structure
  std::size_t body = 0;             // of EulerSetup::bodies: the grid whose layer 0 is the interface at t = 0 (undeformed)
  std::string scheme = "projection";  // key of interface_schemes()
  InterfaceOptions options;
  bool inward = false;              // the fluid's grid was grown into the outline
  std::vector<Point<2>> far;        // not empty: the fluid's last layer stays here, the grid is stretched (its row() nodes)
  bool substeps = true;             // let the faster side take several steps within one of the slower's
  std::function<Point<2>(const Point<2>& X)> displacement;  // of the interface at t = 0; empty: none
  std::function<Point<2>(const Point<2>& X)> velocity;      // of the interface at t = 0; empty: at rest
};

/// The interface as it is now, for output. Nodes and faces in the structure's order.
struct InterfaceState {
  std::string name;
  bool periodic = true;
  std::vector<Point<2>> nodes, node_velocities;  // present positions; velocity of the last step (mean over it)
  std::vector<double> pressure;                  // p̃ per *fluid* face, mean over the last step
  std::vector<Point<2>> fluid_nodes;             // present positions of the fluid's layer 0, in its order
  Point<2> force = Point<2>::Zero();             // of the fluid on the structure, mean over the last step
  double half_time = 0;                          // node velocities and pressure are those of this time
  Point<2> period = Point<2>::Zero();            // periodic: node n + faces is node n + period
  /// Work of p̃ − p̃_e in the last step: Σ dt (p̃ − p̃_e) S̄·w̄ over the fluid's faces, S̄ and w̄ their mean area vectors and
  /// velocities, and Σ dt L t_I·v_I over the structure's, for its steps that ended then (none: 0). With loads per current
  /// area the impulses are opposite to round-off, but not the works: their sum over a run is O(h²) in smooth motions.
  double work_on_fluid = 0, work_on_structure = 0;
};

/// One interface between a structure and the fluid grid around it, from step to step. Holds no fluid and no solid state.
class DeformingInterface {
 public:
  /// How the structure's step relates to the fluid's.
  struct Pace {
    int substeps = 1;    // of the structure within the fluid's step
    double size = 0;     // of the structure's step, if it has no substeps
    double begun = 0;    // part of it that is over at t
    bool finishes = true;  // the structure's step ends with the fluid's
  };

  /// One attempted step.
  struct Step {
    InterfaceSolution solution;          // means over the step
    std::vector<Point<2>> displacement;  // of the interface's nodes at t + Δt
    std::vector<Point<2>> node_velocity;
    std::shared_ptr<const GrownGrid> mesh;  // of the fluid at t + Δt
    Point<2> force = Point<2>::Zero();
    double work_on_fluid = 0, work_on_structure = 0;  // InterfaceState
    Pace pace;
    bool admissible = true;  // of the interface and of the substeps already taken
    std::string trouble;     // why the interface is not
  };

  /// `grid`: the fluid's at t = 0, before any displacement. The structure is not owned. Throws InputError when the nodes
  /// of the two sides do not lie on one curve.
  DeformingInterface(InterfaceSetup setup, Structure& structure, const FittedBody<2>& grid, PhaseTimers& timers);

  /// Where the fluid's grid is now: for EulerSolver::initialize() and resume().
  BodyPath<2> present() const;
  /// As if it moved on as in the last step.
  BodyPath<2> predicted(double dt) const;
  /// The velocity at t = 0 from data of both sides at rest in time.
  void start(std::span<const WallTrace<2>> fluid, const WallLaw& law);

  /// The scheme's answer for a step of the fluid; with substeps the structure has already taken them.
  Step solve(std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt, const Pace& pace);
  /// Advances the structure if its step ends now. False: not admissible.
  bool advance(const Step& step, double dt);
  /// Undoes what solve() did to the structure.
  void reject(const Step& step);
  void accept(const Step& step, double time, double dt);
  BodyPath<2> path(const Step& step) const;

  /// Largest change of a node's velocity from the last step to this one (sum norm), and the fastest node.
  double change_of_velocity(const Step& step) const;
  static double fastest_node(const Step& step);

  const InterfaceSetup& setup() const { return setup_; }
  Structure& structure() const { return structure_; }
  InterfaceState state() const;
  /// All that a restart needs; the length depends on the scene only.
  std::vector<double> motion_state() const;
  const double* resume(const double* state);

 private:
  struct Stencil {  // of a fluid node on the interface's nodes
    std::array<std::size_t, 4> node{};
    std::array<double, 4> weight{};
  };

  std::vector<Point<2>> fluid_curve(const std::vector<Point<2>>& displacement) const;
  std::shared_ptr<const GrownGrid> follow(const std::vector<Point<2>>& displacement) const;
  void tabulate();
  std::vector<Point<2>> predicted_areas(double from_now) const;
  InterfaceSolution ask(std::span<const FluidTrace> fluid, const WallLaw& law, double from_now, InterfaceProblem& problem);
  void move_nodes(std::vector<Point<2>>& displacement, const InterfaceSolution& solution, double dt, double share) const;
  void answer(Step& step, std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt);
  void account(Step& step, double dt) const;
  double work_on_structure(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) const;
  std::pair<std::vector<Point<2>>, std::vector<Point<2>>> means(const Step& step, double dt) const;
  void take_substeps(Step& step, std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt, InterfaceProblem& problem);

  InterfaceSetup setup_;
  Structure& structure_;
  PhaseTimers& timers_;
  const InterfaceScheme* scheme_;
  bool overlaps_;
  InterfaceCurve curve_;                               // of the structure's faces
  std::vector<Point<2>> fluid_reference_;              // nodes of the fluid's faces
  std::vector<double> lengths_;                        // of the structure's faces
  std::vector<Stencil> stencils_;                      // per fluid node
  GrowthOptions growth_{};
  double smoothing_ = 0;
  bool fluid_periodic_ = true;
  Point<2> period_ = Point<2>::Zero();  // of the fluid's nodes
  std::unique_ptr<Transfer> transfer_;
  std::vector<StructureTrace> traces_;
  std::vector<Point<2>> areas_;

  std::vector<Point<2>> displacement_, previous_displacement_, velocity_;  // of the interface's nodes
  double last_step_ = 0, half_time_ = 0;
  std::shared_ptr<const GrownGrid> mesh_, previous_mesh_;
  std::shared_ptr<const BodyAtlas> atlas_;
  std::vector<Point<2>> impulse_, advance_;  // ∫t_I dt and ∫v_I dt per structure face since its step began; empty: it begins now
  InterfaceHistory history_;
  std::vector<double> pressure_;
  Point<2> force_ = Point<2>::Zero();
  double work_on_fluid_ = 0, work_on_structure_ = 0;
};

}  // namespace mortise
