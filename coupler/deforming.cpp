#include "mortise/coupler/deforming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/coupler/curve_parameters.hpp"
#include "mortise/fluid/wall_areas.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr double wrinkles_taken = 0.25;  // per step of the structure (interface_nodes.hpp)
constexpr double most_smoothing = 64;  // of grids grown anew, as of the first ones

FluidTrace fluid_trace(const Primitive<2>& W) { return {W.density, Point<2>(W.velocity[0], W.velocity[1]), W.pressure}; }

/// W0 + 2θ (W_half − W0) at t + θ Δt, or W_half where that has no positive density and pressure.
FluidTrace fluid_trace(const WallTrace<2>& trace, double theta) {
  const auto line = [theta](double start, double half) { return start + 2 * theta * (half - start); };
  Primitive<2> W{line(trace.now.density, trace.half.density),
                 {line(trace.now.velocity[0], trace.half.velocity[0]), line(trace.now.velocity[1], trace.half.velocity[1])},
                 line(trace.now.pressure, trace.half.pressure)};
  return fluid_trace(W.density > 0 && W.pressure > 0 ? W : trace.half);
}

Point<2> zero_of(const Point<2>&) { return Point<2>::Zero(); }
double zero_of(double) { return 0; }

/// sum += weight · values; an empty sum is zero.
template <class Value>
void add(std::vector<Value>& sum, const std::vector<Value>& values, double weight) {
  sum.resize(values.size(), zero_of(values.front()));
  for (std::size_t k = 0; k < values.size(); ++k) sum[k] += weight * values[k];
}

std::vector<Point<2>> moved(const std::vector<Point<2>>& from, const std::vector<Point<2>>& velocity, double dt) {
  std::vector<Point<2>> to = from;
  add(to, velocity, dt);
  return to;
}

const double* take(const double* next, std::vector<Point<2>>& points) {
  for (Point<2>& p : points) {
    p = Point<2>(next[0], next[1]);
    next += 2;
  }
  return next;
}

void put(std::vector<double>& state, const std::vector<Point<2>>& points) {
  for (const Point<2>& p : points) state.insert(state.end(), {p[0], p[1]});
}

}  // namespace

DeformingInterface::DeformingInterface(InterfaceSetup setup, Structure& structure, const FittedBody<2>& grid, PhaseTimers& timers)
    : setup_(std::move(setup)), structure_(structure), timers_(timers), scheme_(&interface_schemes().at(setup_.scheme)), overlaps_(!grid.mesh), curve_{structure.interface_nodes(), structure.periodic(), structure.period()} {
  const GrownGrid& fluid = grid.mesh ? *grid.mesh : grid.shape.atlas->grid();
  for (int i = 0; i < fluid.row(); ++i) fluid_reference_.push_back(fluid.node(i, 0));
  growth_ = {.spacing = fluid.spacing, .layers = fluid.layers, .inward = setup_.inward, .thickness = fluid.thickness};
  smoothing_ = fluid.smoothing;
  period_ = fluid.period;
  fluid_periodic_ = fluid.periodic;
  const CurveParameters parameters = curve_parameters(curve_.nodes, curve_.periodic, curve_.period, fluid_reference_, fluid.periodic);
  if (parameters.farthest > 0.1 * fluid.spacing)
    throw InputError("the grids of solid \"" + setup_.name + "\" and of the gas around it do not begin at the same curve: a node of the gas is " +
                     std::to_string(parameters.farthest) + " away from the solid's surface");
  transfer_ = std::make_unique<Transfer>(parameters.structure, parameters.fluid, curve_.periodic);
  lengths_ = parameters.lengths;
  for (const CurveParameters::Place& place : parameters.places) stencils_.push_back({place.node, place.weight});
  displacement_.assign(curve_.nodes.size(), Point<2>::Zero());
  velocity_ = displacement_;
  for (std::size_t k = 0; k < curve_.nodes.size(); ++k) {
    if (setup_.displacement) displacement_[k] = setup_.displacement(curve_.nodes[k]);
    if (setup_.velocity) velocity_[k] = setup_.velocity(curve_.nodes[k]);
  }
  previous_displacement_ = displacement_;
  mesh_ = follow(displacement_);
  tabulate();
  pressure_.assign(static_cast<std::size_t>(transfer_->fluid_faces()), setup_.options.reference_pressure);
}

std::vector<Point<2>> DeformingInterface::fluid_curve(const std::vector<Point<2>>& displacement) const {
  std::vector<Point<2>> curve = fluid_reference_;
  for (std::size_t i = 0; i < curve.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (stencils_[i].weight[k] != 0) curve[i] += stencils_[i].weight[k] * displacement[stencils_[i].node[k]];
  return curve;
}

/// The fluid's grid for an interface. Where it folds with the smoothing of the first grid, more is tried.
std::shared_ptr<const GrownGrid> DeformingInterface::follow(const std::vector<Point<2>>& displacement) const {
  const auto scope = timers_("grids");
  const std::vector<Point<2>> curve = fluid_curve(displacement);
  for (double smoothing = smoothing_;; smoothing *= 2) {
    try {
      if (setup_.far.empty()) return std::make_shared<GrownGrid>(grow_from(curve, growth_, smoothing));
      return std::make_shared<GrownGrid>(stretch_between(curve, setup_.far, growth_.layers, growth_.spacing, fluid_periodic_, period_));
    } catch (const NumericalError& error) {
      if (setup_.far.empty() && smoothing < most_smoothing) continue;
      throw NumericalError("the gas around solid " + setup_.name + " has no grid any more: " + error.what());
    }
  }
}

/// The atlas of the present grid, where others lie over it.
void DeformingInterface::tabulate() {
  const auto scope = timers_("grids");
  if (overlaps_) atlas_ = std::make_shared<BodyAtlas>(*mesh_, setup_.inward);
}

BodyPath<2> DeformingInterface::present() const { return {Pose<2>{}, Pose<2>{}, mesh_, atlas_}; }

BodyPath<2> DeformingInterface::path(const Step& step) const { return {Pose<2>{}, Pose<2>{}, step.mesh, nullptr}; }

/// The nodes keep the velocity they had; before the first step the grid follows the initial velocity.
BodyPath<2> DeformingInterface::predicted(double dt) const {
  if (!previous_mesh_) return {Pose<2>{}, Pose<2>{}, follow(moved(displacement_, velocity_, dt)), nullptr};
  auto mesh = std::make_shared<GrownGrid>(*mesh_);
  const double ratio = dt / last_step_;
  for (std::size_t k = 0; k < mesh->nodes.size(); ++k) mesh->nodes[k] += ratio * (mesh_->nodes[k] - previous_mesh_->nodes[k]);
  return {Pose<2>{}, Pose<2>{}, mesh, nullptr};
}

/// Area vectors of the fluid's wall faces a time from now, if the interface moves on as in the last step.
std::vector<Point<2>> DeformingInterface::predicted_areas(double from_now) const {
  const std::vector<Point<2>> curve = fluid_curve(moved(displacement_, velocity_, from_now));
  std::vector<Point<2>> areas(static_cast<std::size_t>(transfer_->fluid_faces()));
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const Point<2> next = i + 1 < curve.size() ? curve[i + 1] : Point<2>(curve[0] + period_);
    areas[i] = Point<2>(curve[i][1] - next[1], next[0] - curve[i][0]);
  }
  return areas;
}

/// The scheme's answer to the fluid's data and the structure's (traces_), a time from now.
InterfaceSolution DeformingInterface::ask(std::span<const FluidTrace> fluid, const WallLaw& law, double from_now, InterfaceProblem& problem) {
  areas_ = predicted_areas(from_now);
  problem = {traces_, fluid, areas_, lengths_, transfer_.get(), &law};
  return (*scheme_)(problem, history_, setup_.options);
}

void DeformingInterface::start(std::span<const WallTrace<2>> fluid, const WallLaw& law) {
  std::vector<FluidTrace> now;
  for (const WallTrace<2>& trace : fluid) now.push_back(fluid_trace(trace.now));
  InterfaceProblem problem;
  traces_ = structure_.traces(0, 0);
  const InterfaceSolution solution = ask(now, law, 0, problem);
  velocity_ = node_velocities(solution.wall_velocity, curve_.periodic);
  pressure_ = solution.pressure;
}

/// A step that leaves the interface without an answer or the fluid without a grid is not admissible: a shorter one may be.
DeformingInterface::Step DeformingInterface::solve(std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt, const Pace& pace) {
  Step step;
  step.pace = pace;
  step.displacement = displacement_;
  try {
    answer(step, fluid, law, time, dt);
  } catch (const NumericalError& error) {
    step.admissible = false;
    step.trouble = error.what();
    step.node_velocity = velocity_;
  }
  return step;
}

void DeformingInterface::answer(Step& step, std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt) {
  const Pace& pace = step.pace;
  InterfaceProblem problem;
  if (pace.substeps > 1) {
    take_substeps(step, fluid, law, time, dt, problem);
  } else {
    std::vector<FluidTrace> data;
    for (const WallTrace<2>& trace : fluid) data.push_back(fluid_trace(trace.half));
    traces_ = structure_.traces(pace.size, pace.size == dt ? 0.5 : (pace.begun + 0.5 * dt) / pace.size);
    step.solution = ask(data, law, 0.5 * dt, problem);
    move_nodes(step.displacement, step.solution, dt, dt / pace.size);
  }
  for (std::size_t k = 0; k < displacement_.size(); ++k) step.node_velocity.push_back((step.displacement[k] - displacement_[k]) / dt);
  for (const Point<2>& u : step.displacement)
    if (!u.allFinite()) throw NumericalError("the interface of solid " + setup_.name + " has no finite velocity");
  if (!step.admissible) return;
  step.mesh = follow(step.displacement);
  areas_ = wall_areas(*mesh_, *step.mesh);
  problem.area = areas_;
  for (std::size_t i = 0; i < areas_.size(); ++i) step.force -= (step.solution.load[i] - setup_.options.reference_pressure) * areas_[i];
  if (pace.substeps == 1) step.solution.traction = tractions(problem, step.solution.load, setup_.options);
  account(step, dt);
}

double DeformingInterface::work_on_structure(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) const {
  double power = 0;
  for (std::size_t k = 0; k < lengths_.size(); ++k) power += lengths_[k] * traction[k].dot(velocity[k]);
  return dt * power;
}

/// The works on both sides (InterfaceState); take_substeps() has already summed those of the substeps. areas_: mean ones.
void DeformingInterface::account(Step& step, double dt) const {
  const std::size_t row = static_cast<std::size_t>(mesh_->row());
  const auto moved_by = [&](std::size_t i) { return Point<2>(step.mesh->nodes[i] - mesh_->nodes[i]); };
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const Point<2> mean = 0.5 * (moved_by(i) + moved_by((i + 1) % row));
    step.work_on_fluid += (step.solution.pressure[i] - setup_.options.reference_pressure) * areas_[i].dot(mean);
  }
  if (step.pace.substeps > 1 || !step.pace.finishes) return;
  const auto [traction, velocity] = means(step, dt);
  step.work_on_structure = work_on_structure(traction, velocity, impulse_.empty() ? dt : step.pace.size);
}

/// Moves the nodes over `dt`, the part `share` of a step of the structure, of which traces_ are the middle.
void DeformingInterface::move_nodes(std::vector<Point<2>>& displacement, const InterfaceSolution& solution, double dt, double share) const {
  std::vector<Point<2>> tangents;
  for (const StructureTrace& trace : traces_) tangents.push_back(trace.tangent);
  const std::vector<Point<2>> velocity = node_velocities(solution.wall_velocity, curve_.periodic);
  const std::vector<Point<2>> correction = wrinkle_correction(curve_, moved(displacement, velocity, 0.5 * dt), tangents, wrinkles_taken * share);
  add(displacement, velocity, dt);
  add(displacement, correction, 1);
}

/// The structure's steps within the fluid's, and the means over them.
void DeformingInterface::take_substeps(Step& step, std::span<const WallTrace<2>> fluid, const WallLaw& law, double time, double dt,
                                       InterfaceProblem& problem) {
  const int substeps = step.pace.substeps;
  const double share = 1.0 / substeps;
  std::vector<FluidTrace> data(fluid.size());
  structure_.remember();
  for (int k = 0; k < substeps && step.admissible; ++k) {
    const double theta = (k + 0.5) * share;
    for (std::size_t i = 0; i < data.size(); ++i) data[i] = fluid_trace(fluid[i], theta);
    traces_ = structure_.traces(dt * share, 0.5);
    const InterfaceSolution part = ask(data, law, theta * dt, problem);
    step.admissible = structure_.step(part.traction, part.velocity, dt * share);
    step.work_on_structure += work_on_structure(part.traction, part.velocity, dt * share);
    move_nodes(step.displacement, part, dt * share, 1);
    if (step.admissible) structure_.commit(time + (k + 1) * share * dt);
    add(step.solution.pressure, part.pressure, share);
    add(step.solution.load, part.load, share);
    add(step.solution.traction, part.traction, share);
    add(step.solution.velocity, part.velocity, share);
    add(step.solution.wall_velocity, part.wall_velocity, share);
  }
}

/// Mean traction and velocity of the structure's step that ends with this one of the fluid.
std::pair<std::vector<Point<2>>, std::vector<Point<2>>> DeformingInterface::means(const Step& step, double dt) const {
  if (impulse_.empty()) return {step.solution.traction, step.solution.velocity};
  std::vector<Point<2>> traction = moved(impulse_, step.solution.traction, dt), velocity = moved(advance_, step.solution.velocity, dt);
  for (std::vector<Point<2>>* mean : {&traction, &velocity})
    for (Point<2>& value : *mean) value /= step.pace.size;
  return {std::move(traction), std::move(velocity)};
}

bool DeformingInterface::advance(const Step& step, double dt) {
  if (step.pace.substeps > 1) return step.admissible;
  if (!step.pace.finishes) return true;
  const auto [traction, velocity] = means(step, dt);
  return structure_.step(traction, velocity, impulse_.empty() ? dt : step.pace.size);
}

void DeformingInterface::reject(const Step& step) {
  if (step.pace.substeps > 1) structure_.go_back();
}

void DeformingInterface::accept(const Step& step, double time, double dt) {
  if (step.pace.substeps == 1 && step.pace.finishes) {
    structure_.commit(time);
    impulse_.clear();
    advance_.clear();
  } else if (step.pace.substeps == 1) {
    add(impulse_, step.solution.traction, dt);
    add(advance_, step.solution.velocity, dt);
  }
  history_.remember(step.solution);
  previous_displacement_ = displacement_;
  displacement_ = step.displacement;
  velocity_ = step.node_velocity;
  previous_mesh_ = mesh_;
  mesh_ = step.mesh;
  tabulate();
  pressure_ = step.solution.pressure;
  force_ = step.force;
  work_on_fluid_ = step.work_on_fluid;
  work_on_structure_ = step.work_on_structure;
  last_step_ = dt;
  half_time_ = time - 0.5 * dt;
}

double DeformingInterface::change_of_velocity(const Step& step) const {
  double change = 0;
  for (std::size_t k = 0; k < velocity_.size(); ++k) change = std::max(change, (step.node_velocity[k] - velocity_[k]).lpNorm<1>());
  return change;
}

double DeformingInterface::fastest_node(const Step& step) {
  double speed = 0;
  for (const Point<2>& w : step.node_velocity) speed = std::max(speed, w.norm());
  return speed;
}

InterfaceState DeformingInterface::state() const {
  InterfaceState state{setup_.name, curve_.periodic, curve_.nodes, velocity_, pressure_, fluid_curve(displacement_), force_, half_time_};
  add(state.nodes, displacement_, 1);
  state.period = curve_.period;
  state.work_on_fluid = work_on_fluid_;
  state.work_on_structure = work_on_structure_;
  return state;
}

std::vector<double> DeformingInterface::motion_state() const {
  std::vector<double> state = {last_step_, half_time_, previous_mesh_ ? 1.0 : 0.0, static_cast<double>(history_.pressure.size()), impulse_.empty() ? 0.0 : 1.0,
                               force_[0], force_[1], work_on_fluid_, work_on_structure_};
  for (const std::vector<Point<2>>* points : {&displacement_, &previous_displacement_, &velocity_}) put(state, *points);
  state.insert(state.end(), pressure_.begin(), pressure_.end());
  for (const std::vector<Point<2>>* points : {&impulse_, &advance_})
    put(state, points->empty() ? std::vector<Point<2>>(lengths_.size(), Point<2>::Zero()) : *points);
  for (std::size_t k = 0; k < 2; ++k) {  // of fixed length, whatever has been remembered so far
    const bool there = k < history_.pressure.size();
    put(state, there ? history_.wall_velocity[k] : std::vector<Point<2>>(lengths_.size(), Point<2>::Zero()));
    const std::vector<double> none(pressure_.size(), 0.0), &pressure = there ? history_.pressure[k] : none;
    state.insert(state.end(), pressure.begin(), pressure.end());
  }
  return state;
}

const double* DeformingInterface::resume(const double* next) {
  last_step_ = *next++;
  half_time_ = *next++;
  const bool moved_before = *next++ != 0;
  const auto remembered = static_cast<std::size_t>(*next++);
  const bool waits = *next++ != 0;
  force_ = Point<2>(next[0], next[1]);
  next += 2;
  work_on_fluid_ = *next++;
  work_on_structure_ = *next++;
  for (std::vector<Point<2>>* points : {&displacement_, &previous_displacement_, &velocity_}) next = take(next, *points);
  for (double& p : pressure_) p = *next++;
  for (std::vector<Point<2>>* points : {&impulse_, &advance_}) {
    points->resize(lengths_.size());
    next = take(next, *points);
    if (!waits) points->clear();
  }
  history_ = {};
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<Point<2>> velocity(lengths_.size());
    next = take(next, velocity);
    std::vector<double> pressure(next, next + pressure_.size());
    next += pressure_.size();
    if (k >= remembered) continue;
    history_.wall_velocity.push_back(std::move(velocity));
    history_.pressure.push_back(std::move(pressure));
  }
  if (!moved_before) return next;
  mesh_ = follow(displacement_);
  previous_mesh_ = follow(previous_displacement_);
  tabulate();
  return next;
}

}  // namespace mortise
