#include "mortise/coupler/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/coupler/gaps.hpp"
#include "mortise/fluid/wall_pressure.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

// Patience with steps that have to be repeated is for schemes that are stable by design and for steps chosen by the
// program: explicit coupling of light bodies, or Δt too long for the waves, must not hide behind ever shorter steps.
//
// A step that is repeated with more than this part of its Δt was only adjusted to walls that gain speed: with a Courant
// number near 1 that may happen in every step, and tells nothing of the coupling. Bodies of next to no mass in contact
// change their speed at once, however short the step: of walls that are too fast half as much counts.
constexpr double adjusted = 0.75;

// What looks like a runaway in a step that is not admissible may be the step's fault: so often a shorter one is tried.
constexpr int runaway_tries = 6;

/// Wall faces of a body in its own frame: unit normals into the fluid, centres, measures.
template <int Dim>
struct FaceGeometry {
  Point<Dim> normal, center;
  double measure;
};

std::vector<FaceGeometry<2>> face_geometry(const BodyAtlas& atlas) {
  std::vector<FaceGeometry<2>> faces;
  const GrownGrid& grid = atlas.grid();
  for (int i = 0; i < grid.along; ++i) {
    const Point<2> edge = grid.node(i + 1, 0) - grid.node(i, 0);
    faces.push_back({Point<2>(-edge[1], edge[0]) / edge.norm(), 0.5 * (grid.node(i, 0) + grid.node(i + 1, 0)), edge.norm()});
  }
  return faces;
}

std::vector<FaceGeometry<1>> face_geometry(const LineAtlas& atlas) {
  std::vector<FaceGeometry<1>> faces;
  if (std::isfinite(atlas.left())) faces.push_back({Point<1>(-1), Point<1>(atlas.left()), 1});
  if (std::isfinite(atlas.right())) faces.push_back({Point<1>(1), Point<1>(atlas.right()), 1});
  return faces;
}

DeformingScene deforming_scene(const Communicator& comm, const SimulationSetup<2>& setup, PhaseTimers& timers) {
  return {comm, setup.solids, setup.structures, setup.fluid, timers};
}
DeformingScene deforming_scene(const Communicator& comm, const SimulationSetup<1>&, PhaseTimers& timers) {
  const EulerSetup<2> none;
  return {comm, {}, {}, none, timers};
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(const Communicator& comm, SimulationSetup<Dim> setup)
    : comm_(comm),
      setup_(std::move(setup)),
      fluid_(comm_, setup_.fluid, timers_),
      deforming_(deforming_scene(comm_, setup_, timers_)),
      scheme_(&body_schemes<Dim>().at(setup_.scheme)) {
  for (const BodySetup<Dim>& body : setup_.bodies) {
    bodies_.push_back(body.body);
    initial_poses_.push_back(body.body.pose);
    round_.push_back(body.outline && is_round(*body.outline));
  }
  patient_ = setup_.time_step <= 0 && (bodies_.empty() || !scheme_->needs_mass) &&
             std::none_of(setup_.solids.begin(), setup_.solids.end(), [](const SolidSetup& solid) {
               return solid.interface && (solid.interface->scheme == "traditional" || solid.interface->scheme == "anti-traditional");
             });
  if constexpr (Dim == 2)
    if (setup_.reference_map) reference_map_ = std::make_unique<ReferenceMapScene>(*setup_.reference_map, fluid_, timers_);
  mean_velocity_.resize(bodies_.size(), BodyVector<Dim>::Zero());
  loads_.resize(bodies_.size());
}

template <int Dim>
std::vector<Pose<Dim>> Simulation<Dim>::poses() const {
  std::vector<Pose<Dim>> all;
  for (const RigidBody<Dim>& body : bodies_) all.push_back(body.pose);
  return all;
}

/// Where all grids of bodies and interfaces are: paths without motion.
template <int Dim>
std::vector<BodyPath<Dim>> Simulation<Dim>::present() const {
  std::vector<BodyPath<Dim>> paths;
  for (const RigidBody<Dim>& body : bodies_) paths.push_back({body.pose, body.pose});
  if constexpr (Dim == 2)
    for (BodyPath<2>& path : deforming_.present()) paths.push_back(std::move(path));
  return paths;
}

template <int Dim>
WallLaw Simulation<Dim>::wall_law() const {
  return [gamma = setup_.fluid.gas.gamma](double density, double pressure, double d) {
    const WallResponse response = wall_response(density, pressure, d, gamma);
    return WallPressure{response.pressure, response.impedance};
  };
}

/// A time in which nothing happens, long enough that round-off in positions does not count as motion.
template <int Dim>
double Simulation<Dim>::a_moment() const {
  const Box<Dim>& domain = setup_.fluid.domain;
  const Primitive<Dim> W = setup_.initial(0.5 * (domain.low + domain.high), 0);
  const double crossing = (domain.high - domain.low).maxCoeff() / std::sqrt(setup_.fluid.gas.gamma * W.pressure / W.density);
  return 1e-6 * setup_.cfl * (std::isfinite(crossing) && crossing > 0 ? crossing : 1.0);
}

template <int Dim>
void Simulation<Dim>::initialize() {
  try {
    deforming_.initialize();
    fluid_.initialize(setup_.initial, present(), time_);
    if constexpr (Dim == 2)
      if (reference_map_) {
        reference_map_->initialize(setup_.initial);
        fluid_.refresh(time_);
      }
  } catch (const NumericalError& error) {  // nothing has been computed yet
    throw InputError(std::string("at t = 0 ") + error.what() + ": use finer cells (grid.factor), wider gaps or thicker solids");
  }
  const double instant = a_moment();
  for (std::size_t b = 0; b < bodies_.size(); ++b) mean_velocity_[b] = held_velocity(b, instant);
  const auto moving = [&] {
    std::vector<BodyPath<Dim>> paths;
    for (std::size_t b = 0; b < bodies_.size(); ++b) paths.push_back(path(b, mean_velocity_[b], instant));
    if constexpr (Dim == 2)
      for (BodyPath<2>& path : deforming_.predicted(instant)) paths.push_back(std::move(path));
    return paths;
  };
  if constexpr (Dim == 2)
    if (deforming_.interfaces() > 0) {
      const auto traces = fluid_.wall_traces(moving(), 0);
      deforming_.start(std::span(traces).subspan(bodies_.size()), wall_law());
    }
  fluid_.measure_rates(moving(), instant);
  if (!fluid_.grids().empty()) fastest_wave_ = fluid_.rate() * fluid_.grids().front().spacing.maxCoeff();
  fastest_wave_ = std::max(fastest_wave_, deforming_.fastest_wave());
  least_j_ = deforming_.least_j();
}

/// y^n, with the mean velocity over the coming step in place of held degrees of freedom.
template <int Dim>
BodyVector<Dim> Simulation<Dim>::held_velocity(std::size_t b, double dt) const {
  BodyVector<Dim> y = bodies_[b].y;
  for (int k = 0; k < degrees_of_freedom<Dim>; ++k) {
    const auto degree = static_cast<std::size_t>(k);
    if (!bodies_[b].held[degree]) continue;
    const TimeFunction& motion = setup_.bodies[b].motion[degree];
    y[k] = motion ? (motion(time_ + dt) - motion(time_)) / dt : 0.0;
  }
  return y;
}

template <int Dim>
BodyPath<Dim> Simulation<Dim>::path(std::size_t b, const BodyVector<Dim>& mean, double dt) const {
  BodyPath<Dim> path{bodies_[b].pose, advanced<Dim>(bodies_[b].pose, mean, dt)};
  for (int k = 0; k < degrees_of_freedom<Dim>; ++k) {  // prescribed displacements do not accumulate errors
    const TimeFunction& motion = setup_.bodies[b].motion[static_cast<std::size_t>(k)];
    if (!motion) continue;
    if (k < Dim)
      path.end.position[k] = initial_poses_[b].position[k] + motion(time_ + dt);
    else
      path.end.angle = initial_poses_[b].angle + motion(time_ + dt);
  }
  return path;
}

template <int Dim>
std::vector<WallFace<Dim>> Simulation<Dim>::wall_faces(std::size_t b, const std::vector<WallTrace<Dim>>& traces, const Pose<Dim>& pose) const {
  const std::vector<FaceGeometry<Dim>> geometry = face_geometry(*setup_.fluid.bodies[b].shape.atlas);
  const Frame<Dim> frame(pose);
  std::vector<WallFace<Dim>> faces(geometry.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Point<Dim> normal = frame.turn(geometry[i].normal);
    const auto along = [&](const std::array<double, Dim>& u) {
      double sum = 0;
      for (std::size_t d = 0; d < Dim; ++d) sum += u[d] * normal[static_cast<int>(d)];
      return sum;
    };
    const Primitive<Dim>&now = traces[i].now, &half = traces[i].half;
    faces[i] = {normal,       frame.turn(geometry[i].center), geometry[i].measure,  now.density,  along(now.velocity),
                now.pressure, half.density,                   along(half.velocity), half.pressure};
  }
  return faces;
}

template <int Dim>
CoupledBody<Dim> Simulation<Dim>::coupled_body(std::size_t b, const BodyPath<Dim>& predicted, const std::vector<WallTrace<Dim>>& traces, double dt) const {
  const RigidBody<Dim>& body = bodies_[b];
  CoupledBody<Dim> coupled;
  coupled.step = {.name = body.name, .mass = body.mass_diagonal(), .velocity = held_velocity(b, dt), .held = body.held, .length = body.length,
                  .dt = dt, .p_inf = setup_.fluid.gas.p_inf};
  for (std::size_t stage = 0; stage < 2; ++stage) {
    const double t = time_ + (stage == 0 ? sdirk2_gamma : 1.0) * dt;
    for (int k = 0; k < degrees_of_freedom<Dim>; ++k) {
      const TimeFunction& force = setup_.bodies[b].force[static_cast<std::size_t>(k)];
      coupled.step.external[stage][k] = (force ? force(t) : 0.0) + (k < Dim ? body.mass * setup_.gravity[k % Dim] : 0.0);
    }
  }
  const Pose<Dim> middle{0.5 * (predicted.start.position + predicted.end.position), 0.5 * (predicted.start.angle + predicted.end.angle)};
  if (setup_.fluid.bodies[b].wall) coupled.faces = wall_faces(b, traces, middle);  // else the gas passes through
  coupled.position = body.pose.position;
  coupled.round = round_[b];
  return coupled;
}

/// Closest points of bodies, and of bodies and the edge of the domain, at t.
template <int Dim>
std::vector<ContactPoint<Dim>> Simulation<Dim>::near_contacts(double within) const {
  std::vector<GapBody<Dim>> shapes;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    shapes.push_back({setup_.fluid.bodies[b].shape.atlas.get(), setup_.bodies[b].outline.get(), bodies_[b].pose});
  return find_gaps<Dim>(shapes, setup_.fluid.domain, fluid_.grids().front().periodic, within);
}

/// What the coupling schemes make of the walls in a step of dt.
template <int Dim>
typename Simulation<Dim>::Motion Simulation<Dim>::move(const Plan& plan) {
  const double dt = plan.dt;
  std::vector<BodyPath<Dim>> predicted;
  std::vector<std::vector<WallTrace<Dim>>> traces;
  {
    const auto scope = timers_("bodies");
    for (std::size_t b = 0; b < bodies_.size(); ++b) predicted.push_back(path(b, held_velocity(b, dt), dt));
    if constexpr (Dim == 2)
      for (BodyPath<2>& path : deforming_.predicted(dt)) predicted.push_back(std::move(path));
    traces = fluid_.wall_traces(predicted, dt);
  }
  Motion motion;
  if (!bodies_.empty()) move_bodies(motion, predicted, traces, dt);
  if constexpr (Dim == 2) {
    motion.deforming = deforming_.solve(std::span(traces).subspan(bodies_.size()), wall_law(), time_, dt, plan.stride, setup_.cfl);
    for (const DeformingInterface::Step& step : motion.deforming) motion.pressure.push_back(step.solution.pressure);
    for (BodyPath<2>& path : deforming_.paths(motion.deforming)) motion.paths.push_back(std::move(path));
  }
  return motion;
}

template <int Dim>
void Simulation<Dim>::move_bodies(Motion& motion, const std::vector<BodyPath<Dim>>& predicted, const std::vector<std::vector<WallTrace<Dim>>>& traces,
                                  double dt) {
  const auto scope = timers_("bodies");
  std::vector<CoupledBody<Dim>> coupled;
  for (std::size_t b = 0; b < bodies_.size(); ++b) coupled.push_back(coupled_body(b, predicted[b], traces[b], dt));
  GapSearch<Dim> gaps;
  if (setup_.contact) gaps = [this](double within) { return near_contacts(within); };
  const ContactStep<Dim> step = advance_bodies<Dim>(std::move(coupled), scheme_->advance, wall_law(), gaps,
                                                    {.restitution = setup_.restitution, .distance = setup_.contact_gap, .dt = dt});
  motion.contacts = step.count;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyMotion<Dim>& moved = step.motions[b];
    motion.end.push_back(moved.velocity);
    motion.mean.push_back(moved.mean);
    motion.pressure.push_back(moved.pressure);
    motion.loads.push_back({moved.force.template head<Dim>(), Dim == 2 ? moved.force[degrees_of_freedom<Dim> - 1] : 0.0});
    motion.paths.push_back(path(b, moved.mean, dt));
  }
}

/// Bound of what the change of the walls' velocity adds to the wave rates, which were measured with the last one.
template <int Dim>
double Simulation<Dim>::extra_rate(const Motion& motion) const {
  double extra = deforming_.extra_rate(motion.deforming);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyVector<Dim> change = motion.mean[b] - mean_velocity_[b];
    double speed = change.template head<Dim>().template lpNorm<1>();
    if constexpr (Dim == 2) speed += std::fabs(change[2]) * setup_.fluid.bodies[b].shape.atlas->reach().high.norm();
    extra = std::max(extra, speed / setup_.fluid.bodies[b].shape.spacing);
  }
  return extra;
}

/// The body or surface that runs away in this motion, or nothing. Bodies with a prescribed force may be as fast as they are made.
template <int Dim>
std::string Simulation<Dim>::runaway(const Motion& motion) const {
  const std::string beyond = ", more than " + std::to_string(static_cast<int>(runaway_factor)) + " times the fastest wave of the initial state";
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (int k = 0; k < degrees_of_freedom<Dim>; ++k) {
      const auto degree = static_cast<std::size_t>(k);
      const double speed = motion.end[b][k] * (k < Dim ? 1 : bodies_[b].length);  // of the surface, if it turns
      if (!bodies_[b].held[degree] && !setup_.bodies[b].force[degree] && !(std::fabs(speed) <= runaway_factor * fastest_wave_))
        return "body " + bodies_[b].name + (k < Dim ? " moves at " : " turns at ") + std::to_string(speed) + beyond;
    }
  const std::string surface = deforming_.faster_than(runaway_factor * fastest_wave_, motion.deforming);
  return surface.empty() ? "" : surface + beyond;
}

/// The half space whose surface leaves the domain on its own side in this motion, or nothing: there is no gas beside it.
template <int Dim>
std::string Simulation<Dim>::departed(const Motion& motion) const {
  if constexpr (Dim == 1)
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const LineAtlas& atlas = *setup_.fluid.bodies[b].shape.atlas;
      const double x = motion.paths[b].end.position[0];
      const bool beyond_low = !std::isfinite(atlas.left()) && x + atlas.right() <= setup_.fluid.domain.low[0];
      const bool beyond_high = !std::isfinite(atlas.right()) && x + atlas.left() >= setup_.fluid.domain.high[0];
      if (beyond_low || beyond_high) return "the surface of " + bodies_[b].name + " leaves the domain at x = " + std::to_string(x);
    }
  return "";
}

template <int Dim>
typename Simulation<Dim>::Plan Simulation<Dim>::next_step(double limit) const {
  static constexpr double ramp[] = {0.1, 0.2, 0.4, 0.6, 0.8};  // the first steps, while waves form at discontinuities
  const double of_fluid = fluid_.rate(), rate = std::max(of_fluid, deforming_.rate(of_fluid));
  Plan plan{setup_.time_step > 0 ? setup_.time_step : setup_.cfl / rate, limit, {}};
  plan.stride = deforming_.stride(time_, limit, setup_.time_step > 0 ? 0 : of_fluid, setup_.cfl);
  plan.limit = std::min(limit, plan.stride.end);
  if (setup_.time_step <= 0 && step_ < 5) plan.dt *= ramp[step_];
  plan.dt = step_towards(plan.dt, plan.limit - time_);
  return plan;
}

template <int Dim>
typename Simulation<Dim>::Pace Simulation<Dim>::pace() const {
  const double of_fluid = fluid_.rate(), dt = setup_.time_step > 0 ? setup_.time_step : setup_.cfl / std::max(of_fluid, deforming_.rate(of_fluid));
  return {dt, deforming_.substeps(dt, setup_.cfl), deforming_.stride(time_, std::numeric_limits<double>::infinity(), setup_.time_step > 0 ? 0 : of_fluid, setup_.cfl).size};
}

template <int Dim>
double Simulation<Dim>::advance(double limit) {
  try {
    Plan plan = next_step(limit);
    const Motion motion = attempt(plan);
    accept(motion, plan);
    return plan.dt;
  } catch (const NumericalError& error) {
    throw NumericalError("the computation failed at t = " + std::to_string(time_) + ", step " + std::to_string(step_) + ": " + error.what());
  }
}

template <int Dim>
void Simulation<Dim>::follow(const Simulation& leader) {
  try {
    Plan plan = leader.last_plan_;
    const Motion motion = attempt(plan);
    if (!(plan == leader.last_plan_)) throw NumericalError("a step of " + std::to_string(leader.last_plan_.dt) + " is too long here");
    accept(motion, plan);
  } catch (const NumericalError& error) {
    throw NumericalError("the computation failed at t = " + std::to_string(time_) + ", step " + std::to_string(step_) + ": " + error.what());
  }
}

/// Bodies and fluid over dt, which is made smaller until the step is admissible. Where gas with next to no pressure
/// stays inadmissible, the fluid's step is of first order; that tells nothing of the coupling.
template <int Dim>
typename Simulation<Dim>::Motion Simulation<Dim>::attempt(Plan& plan) {
  double& dt = plan.dt;
  const int unrest = restless_;
  bool first_order = false;
  for (int tries = 0;; ++tries) {
    Motion motion = move(plan);
    const std::string lost = runaway(motion);
    const double fastest = dt * (fluid_.rate() + extra_rate(motion));
    const bool too_fast = lost.empty() && setup_.time_step <= 0 && fastest > 1 && tries < 20;
    const bool admissible = !too_fast && step(motion, plan, first_order);
    if (admissible && lost.empty()) {
      if (const std::string gone = departed(motion); !gone.empty()) throw NumericalError(gone + ": the domain must reach farther");
      if (first_order) restless_ = unrest;
      first_order_steps_ += first_order;
      return motion;
    }
    const bool judged = !too_fast && !admissible;
    const std::string bad_gas = judged ? fluid_.first_bad_cell(motion.paths) : "";
    const std::string bad = judged && bad_gas.empty() ? deforming_.first_bad_cell(motion.deforming) : bad_gas;
    deforming_.reject(motion.deforming);
    if (!lost.empty() && (admissible || !patient_ || tries >= runaway_tries))
      throw NumericalError("the coupling is unstable, " + lost + (bad.empty() ? "" : "; first bad cell: " + bad));
    const double shorter = too_fast ? std::max(0.5, std::min(0.95, setup_.cfl / fastest)) : 0.5;
    ++repeats_;
    if (!patient_ || shorter < adjusted) restless_ += too_fast && patient_ ? 1 : 2;
    if (restless_ > 2 * repeat_limit)
      throw NumericalError(std::string(setup_.fluid.bodies.empty() ? "" : "the coupling is unstable, ") + "steps have to be repeated again and again" + (bad.empty() ? "" : ", last for " + bad));
    if (tries >= 30 || dt < 1e-14 * std::fabs(time_)) throw NumericalError(bad.empty() ? "no time step is short enough" : bad);
    if (patient_ && tries > 0 && !bad_gas.empty()) first_order = true;
    dt *= shorter;
  }
}

template <int Dim>
bool Simulation<Dim>::step(const Motion& motion, const Plan& plan, bool first_order) {
  for (const DeformingInterface::Step& interface : motion.deforming)
    if (!interface.admissible) return false;  // found on every rank alike
  if (reference_map_ && !reference_map_->begin(plan.dt)) return false;
  const bool fluid = fluid_.step(motion.paths, motion.pressure, plan.dt, first_order);
  return deforming_.advance(motion.deforming, time_, plan.dt, plan.stride) && fluid;
}

template <int Dim>
void Simulation<Dim>::accept(const Motion& motion, const Plan& plan) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b].pose = motion.paths[b].end;
    bodies_[b].y = motion.end[b];
  }
  mean_velocity_ = motion.mean;
  loads_ = motion.loads;
  contacts_ += motion.contacts;
  const bool last = plan.dt == plan.limit - time_;
  time_ = last ? plan.limit : time_ + plan.dt;
  last_step_ = plan.dt;
  last_plan_ = plan;
  ++step_;
  restless_ = std::max(0, restless_ - 1);
  cell_updates_ += fluid_.last_count().computed + deforming_.computed();
  cells_skipped_ += fluid_.last_count().skipped + deforming_.skipped();
  deforming_.accept(motion.deforming, time_, plan.dt, plan.stride);
  least_j_ = std::min(least_j_, deforming_.least_j());
  fluid_.commit(present(), time_);
  if (reference_map_) reference_map_->finish(plan.dt, time_);
}

template <int Dim>
std::vector<double> Simulation<Dim>::motion_state() const {
  std::vector<double> state = {time_, last_step_, static_cast<double>(step_), static_cast<double>(restless_), fastest_wave_, least_j_};
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (int d = 0; d < Dim; ++d) state.push_back(bodies_[b].pose.position[d]);
    state.push_back(bodies_[b].pose.angle);
    for (const BodyVector<Dim>* y : {&bodies_[b].y, &mean_velocity_[b]})
      for (int k = 0; k < degrees_of_freedom<Dim>; ++k) state.push_back((*y)[k]);
    for (int d = 0; d < Dim; ++d) state.push_back(loads_[b].force[d]);
    state.push_back(loads_[b].torque);
  }
  const std::vector<double> interfaces = deforming_.motion_state();
  state.insert(state.end(), interfaces.begin(), interfaces.end());
  return state;
}

template <int Dim>
void Simulation<Dim>::resume(const std::vector<double>& state) {
  const double* next = state.data();
  time_ = *next++;
  last_step_ = *next++;
  step_ = static_cast<std::int64_t>(*next++);
  restless_ = static_cast<int>(*next++);
  fastest_wave_ = *next++;
  least_j_ = *next++;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    for (int d = 0; d < Dim; ++d) bodies_[b].pose.position[d] = *next++;
    bodies_[b].pose.angle = *next++;
    for (BodyVector<Dim>* y : {&bodies_[b].y, &mean_velocity_[b]})
      for (int k = 0; k < degrees_of_freedom<Dim>; ++k) (*y)[k] = *next++;
    for (int d = 0; d < Dim; ++d) loads_[b].force[d] = *next++;
    loads_[b].torque = *next++;
  }
  deforming_.resume(next, time_);
  fluid_.resume(present(), time_);
  if (reference_map_) reference_map_->resume(time_);
}

template class Simulation<1>;
template class Simulation<2>;

}  // namespace mortise
