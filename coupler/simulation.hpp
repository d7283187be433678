// A scene of gas, rigid bodies and elastic solids, advanced in time.
//
// One step, t → t + Δt:
//   predict walls   fluid at the wall faces at t and t + Δt/2, walls moving as in the last step
//   move bodies     rigid: the coupling scheme solves M y' = F(y), contacts; deforming: the fluid-structure Riemann problem of
//                   every interface (deforming.hpp)
//   advance         fluid: every grid, body grids along the path of their body, wall faces with the scheme's pressure;
//                   solids with the scheme's tractions
//   correct grids   cut holes for the new poses, interpolate fringe and exposed cells, fill ghosts
// A step whose state is not admissible, or whose walls turn out faster than Δt allows, is repeated with a smaller Δt, and
// where gas of next to no pressure stays inadmissible with first order in the fluid. The
// coupling counts as unstable when a body that nothing but gas pushes moves faster than runaway_factor times the fastest wave of the initial
// state, which no gas can make it do, and when steps repeated with a much smaller Δt outnumber half the others by more than
// repeat_limit: small Δt would then only hide that the coupling does not hold.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mortise/coupler/body_schemes.hpp"
#include "mortise/coupler/contact_step.hpp"
#include "mortise/coupler/deforming_scene.hpp"
#include "mortise/coupler/reference_map/reference_map_scene.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/solid/rigid_body.hpp"

namespace mortise {

/// A function of time, non-dimensional; empty: not given.
using TimeFunction = std::function<double(double)>;

template <int Dim>
struct BodySetup {
  RigidBody<Dim> body;
  std::array<TimeFunction, degrees_of_freedom<Dim>> motion;  // prescribed displacement from the initial pose
  std::array<TimeFunction, degrees_of_freedom<Dim>> force;   // external force and torque
  std::shared_ptr<const Outline> outline;                    // 2D: for contact
};

template <int Dim>
struct SimulationSetup {
  EulerSetup<Dim> fluid;
  std::vector<BodySetup<Dim>> bodies;    // rigid: the first entries of fluid.bodies, in their order
  std::vector<SolidSetup> solids;        // Dim = 2; their interfaces are the next entries of fluid.bodies
  std::vector<StructureSetup> structures;  // Dim = 2; and theirs the last
  std::optional<ReferenceMapSetup> reference_map;  // Dim = 2; in place of bodies, solids and structures
  StateFunction<Dim> initial;            // (ρ, u, p̃) at t = 0
  std::string scheme = "rigid";          // key of body_schemes()
  Point<Dim> gravity = Point<Dim>::Zero();
  double cfl = 0.9;                      // in (0, 1]
  double time_step = 0;                  // fixed Δt; 0: from cfl
  bool contact = true;
  double restitution = 1;
  double contact_gap = 0;                // bodies closer than this touch; length
};

/// What happened to one body in the last step.
template <int Dim>
struct BodyLoad {
  Point<Dim> force = Point<Dim>::Zero();  // of the gas on the body, mean over the step
  double torque = 0;
};

/// The next step of size dt at most towards a time that is `left` away, so that no step before it is much shorter.
inline double step_towards(double dt, double left) {
  if (dt >= left * (1 - 1e-12)) return left;
  return 2 * dt > left ? 0.5 * left : dt;
}

/// See the head of this file.
inline constexpr double runaway_factor = 20;
inline constexpr int repeat_limit = 40;

template <int Dim>
class Simulation {
 public:
  Simulation(const Communicator& comm, SimulationSetup<Dim> setup);

  void initialize();
  /// One step that does not pass `limit`; returns Δt. Throws NumericalError naming the first bad cell.
  double advance(double limit);
  /// The step that `leader`, which started from the same time, has just made, whatever rates there are here: for runs that
  /// are compared step by step. Throws NumericalError like advance(), and when that step is not admissible here.
  void follow(const Simulation& leader);
  /// advance() takes the same steps for either limit, this time at least.
  bool same_step(double limit, double other) const { return next_step(limit) == next_step(other); }

  /// How the scene is stepped while its rates stay as they are, beyond the short first steps.
  struct Pace {
    double dt;                // of the gas
    std::vector<int> solid_substeps;  // within a step of the gas, per interface
    double solid_step;        // of solids that wait over several steps of the gas; ∞: none waits
  };
  Pace pace() const;

  double time() const { return time_; }
  std::int64_t steps() const { return step_; }
  const std::vector<RigidBody<Dim>>& bodies() const { return bodies_; }
  const std::vector<BodyLoad<Dim>>& loads() const { return loads_; }
  std::vector<Pose<Dim>> poses() const;
  const std::vector<std::unique_ptr<ElasticSolver>>& solids() const { return deforming_.solids(); }
  /// Of the solids and structures with an interface, in the order of fluid.bodies.
  std::vector<InterfaceState> interfaces() const { return deforming_.states(); }
  /// nullptr unless the scene is a continuum of gas and solids.
  ReferenceMapScene* reference_map() { return reference_map_.get(); }
  const ReferenceMapScene* reference_map() const { return reference_map_.get(); }
  /// Smallest J seen in any solid since the start (1: none, or linear elasticity only).
  double least_j() const { return least_j_; }
  EulerSolver<Dim>& fluid() { return fluid_; }
  const EulerSolver<Dim>& fluid() const { return fluid_; }
  const SimulationSetup<Dim>& setup() const { return setup_; }
  PhaseTimers& timers() { return timers_; }
  std::int64_t cell_updates() const { return cell_updates_; }   // computed, on this rank
  std::int64_t cells_skipped() const { return cells_skipped_; }  // left out, on this rank
  std::int64_t contacts() const { return contacts_; }           // contacts with an impulse, summed over the steps
  std::int64_t repeats() const { return repeats_; }             // steps repeated with a smaller Δt
  std::int64_t first_order_steps() const { return first_order_steps_; }  // of the fluid, where it would have lost its pressure

  /// What a restart needs beside the fields and rates of the fluid: time, step, Δt and the motion of the bodies.
  std::vector<double> motion_state() const;
  /// Continues from motion_state(), fields and rates already being in place.
  void resume(const std::vector<double>& state);

 private:
  struct Motion {  // of one attempted step
    std::vector<BodyVector<Dim>> end, mean;
    std::vector<std::vector<double>> pressure;
    std::vector<BodyLoad<Dim>> loads;
    std::vector<BodyPath<Dim>> paths;
    int contacts = 0;
    DeformingScene::Steps deforming;  // of the interfaces, whose pressures and paths come after those of the bodies
  };

  struct Plan {  // of a step
    double dt, limit;
    DeformingScene::Stride stride;  // of the structures
    bool operator==(const Plan& other) const { return dt == other.dt && stride.size == other.stride.size; }
  };
  Plan next_step(double limit) const;
  WallLaw wall_law() const;
  std::vector<BodyPath<Dim>> present() const;
  BodyPath<Dim> path(std::size_t body, const BodyVector<Dim>& mean, double dt) const;
  BodyVector<Dim> held_velocity(std::size_t body, double dt) const;
  Motion move(const Plan& plan);
  void move_bodies(Motion& motion, const std::vector<BodyPath<Dim>>& predicted, const std::vector<std::vector<WallTrace<Dim>>>& traces, double dt);
  std::vector<WallFace<Dim>> wall_faces(std::size_t body, const std::vector<WallTrace<Dim>>& traces, const Pose<Dim>& pose) const;
  CoupledBody<Dim> coupled_body(std::size_t body, const BodyPath<Dim>& predicted, const std::vector<WallTrace<Dim>>& traces, double dt) const;
  std::vector<ContactPoint<Dim>> near_contacts(double within) const;
  double extra_rate(const Motion& motion) const;
  double a_moment() const;
  std::string runaway(const Motion& motion) const;
  std::string departed(const Motion& motion) const;
  Motion attempt(Plan& plan);
  bool step(const Motion& motion, const Plan& plan, bool first_order);
  void accept(const Motion& motion, const Plan& plan);

  Communicator comm_;
  SimulationSetup<Dim> setup_;
  PhaseTimers timers_;
  EulerSolver<Dim> fluid_;
  std::vector<RigidBody<Dim>> bodies_;
  std::vector<Pose<Dim>> initial_poses_;
  std::vector<bool> round_;                     // the body is a circle
  std::vector<BodyVector<Dim>> mean_velocity_;  // of the last step: the velocity the grids had
  std::vector<BodyLoad<Dim>> loads_;
  DeformingScene deforming_;  // empty for Dim = 1
  std::unique_ptr<ReferenceMapScene> reference_map_;
  double least_j_ = 1;
  const BodyScheme<Dim>* scheme_;
  Plan last_plan_{};  // of the last step
  double time_ = 0, last_step_ = 0;
  double fastest_wave_ = 0;  // |u| + c of the initial state, at most
  std::int64_t step_ = 0, cell_updates_ = 0, cells_skipped_ = 0, contacts_ = 0, repeats_ = 0, first_order_steps_ = 0;
  bool patient_ = true;  // with steps that have to be repeated (simulation.cpp)
  int restless_ = 0;  // 2 × repeated steps (but for adjusted ones) − others, at least 0
};

}  // namespace mortise
