#include "mortise/coupler/deforming_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/grids/core/error.hpp"

namespace mortise {

namespace {

// A structure takes substeps when it would slow the fluid down by more than this factor.
constexpr double substep_gain = 1.25;

// A stride is that much shorter than its whole steps of the fluid, whose waves may become faster meanwhile.
constexpr double stride_margin = 0.96;

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

DeformingScene::DeformingScene(const Communicator& comm, const std::vector<SolidSetup>& solids, const std::vector<StructureSetup>& structures,
                               const EulerSetup<2>& fluid, PhaseTimers& timers)
    : timers_(timers), setups_(solids) {
  const auto couple = [&](std::unique_ptr<Structure> structure, const InterfaceSetup& setup) {
    const FittedBody<2>& grid = fluid.bodies.at(setup.body);
    Member member{std::move(structure), nullptr, grid.shape.spacing};
    member.interface = std::make_unique<DeformingInterface>(setup, *member.structure, grid, timers_);
    interfaces_.push_back(std::move(member));
  };
  for (const SolidSetup& solid : solids) {
    solids_.push_back(std::make_unique<ElasticSolver>(comm, solid.elastic, timers));
    interface_of_.push_back(solid.interface ? static_cast<int>(interfaces_.size()) : -1);
    if (solid.interface)
      couple(std::make_unique<ElasticStructure>(*solids_.back()), *solid.interface);
    else
      alone_.push_back(solids_.back().get());
  }
  for (const StructureSetup& structure : structures) couple(structure.make(comm), structure.interface);
}

void DeformingScene::initialize() {
  for (std::size_t s = 0; s < solids_.size(); ++s) solids_[s]->initialize(setups_[s].initial, 0);
}

void DeformingScene::start(Traces traces, const WallLaw& law) {
  for (std::size_t k = 0; k < interfaces_.size(); ++k) interfaces_[k].interface->start(traces[k], law);
}

double DeformingScene::rate(double fluid_rate) const {
  double fastest = 0;
  for (const ElasticSolver* solid : alone_) fastest = std::max(fastest, solid->rate());
  for (const Member& member : interfaces_) {
    const double rate = member.structure->rate();
    const bool by_substeps = member.interface->setup().substeps && member.structure->can_return() && rate > substep_gain * fluid_rate;
    if (!by_substeps) fastest = std::max(fastest, rate);
  }
  return fastest;
}

int DeformingScene::substeps_of(const Member& member, double dt, double cfl) const {
  if (!member.interface->setup().substeps || !member.structure->can_return()) return 1;
  return std::max(1, static_cast<int>(std::ceil(dt * member.structure->rate() / cfl * (1 - 1e-9))));
}

std::vector<int> DeformingScene::substeps(double dt, double cfl) const {
  std::vector<int> all;
  for (const Member& member : interfaces_) all.push_back(substeps_of(member, dt, cfl));
  return all;
}

/// The structures wait over as many whole steps of the fluid as their own rate allows, if that is two at least.
DeformingScene::Stride DeformingScene::stride(double time, double limit, double fluid_rate, double cfl) const {
  if (stride_ > 0) return {stride_, end_};
  double fastest = 0;
  for (const ElasticSolver* solid : alone_) fastest = std::max(fastest, solid->rate());
  for (const Member& member : interfaces_) {
    if (!member.interface->setup().substeps) return {never, never};
    fastest = std::max(fastest, member.structure->rate());
  }
  const double steps = fastest > 0 ? std::floor(fluid_rate / fastest) : 0;
  if (interfaces_.empty() || steps < 2) return {never, never};
  const double size = stride_margin * steps * cfl / fluid_rate, left = limit - time;
  if (size >= left * (1 - 1e-12)) return {left, limit};
  const double chosen = 2 * size > left ? 0.5 * left : size;
  return {chosen, time + chosen};
}

DeformingInterface::Pace DeformingScene::pace_of(const Member& member, double time, double dt, const Stride& stride, double cfl) const {
  if (stride.size == never) return {substeps_of(member, dt, cfl), dt, 0, true};
  return {1, stride.size, stride_ > 0 ? time - begun_ : 0.0, dt == stride.end - time};
}

std::vector<BodyPath<2>> DeformingScene::present() const {
  std::vector<BodyPath<2>> paths;
  for (const Member& member : interfaces_) paths.push_back(member.interface->present());
  return paths;
}

std::vector<BodyPath<2>> DeformingScene::predicted(double dt) const {
  std::vector<BodyPath<2>> paths;
  for (const Member& member : interfaces_) paths.push_back(member.interface->predicted(dt));
  return paths;
}

DeformingScene::Steps DeformingScene::solve(Traces traces, const WallLaw& law, double time, double dt, const Stride& stride, double cfl) {
  const auto scope = timers_("coupling");
  Steps steps;
  for (std::size_t k = 0; k < interfaces_.size(); ++k)
    steps.push_back(interfaces_[k].interface->solve(traces[k], law, time, dt, pace_of(interfaces_[k], time, dt, stride, cfl)));
  return steps;
}

std::vector<BodyPath<2>> DeformingScene::paths(const Steps& steps) const {
  std::vector<BodyPath<2>> paths;
  for (std::size_t k = 0; k < interfaces_.size(); ++k) paths.push_back(interfaces_[k].interface->path(steps[k]));
  return paths;
}

bool DeformingScene::advance(const Steps& steps, double time, double dt, const Stride& stride) {
  const auto scope = timers_("solid");
  computed_ = skipped_ = 0;
  const bool waits = stride.size != never && dt != stride.end - time;
  bool admissible = true;
  if (!waits)
    for (ElasticSolver* solid : alone_) admissible = solid->step({}, {}, stride.size == never ? dt : stride.size) && admissible;
  for (std::size_t k = 0; k < interfaces_.size(); ++k) admissible = interfaces_[k].interface->advance(steps[k], dt) && admissible;
  if (waits) return admissible;
  for (std::size_t s = 0; s < solids_.size(); ++s) {
    const int substeps = interface_of_[s] < 0 ? 1 : steps[static_cast<std::size_t>(interface_of_[s])].pace.substeps;
    computed_ += substeps * solids_[s]->last_count().computed;
    skipped_ += substeps * solids_[s]->last_count().skipped;
  }
  return admissible;
}

void DeformingScene::reject(const Steps& steps) {
  for (std::size_t k = 0; k < steps.size(); ++k) interfaces_[k].interface->reject(steps[k]);
}

void DeformingScene::accept(const Steps& steps, double time, double dt, const Stride& stride) {
  const auto scope = timers_("solid");
  const bool waits = stride.size != never && time != stride.end;
  if (!waits)
    for (ElasticSolver* solid : alone_) solid->commit(time);
  for (std::size_t k = 0; k < steps.size(); ++k) interfaces_[k].interface->accept(steps[k], time, dt);
  if (waits && stride_ == 0) begun_ = time - dt;
  stride_ = waits ? stride.size : 0;
  end_ = waits ? stride.end : 0;
}

std::string DeformingScene::first_bad_cell(const Steps& steps) const {
  for (const DeformingInterface::Step& step : steps)
    if (!step.trouble.empty()) return step.trouble;
  for (const ElasticSolver* solid : alone_) {
    const std::string bad = solid->first_bad_cell();
    if (!bad.empty()) return bad;
  }
  for (const Member& member : interfaces_) {
    const std::string bad = member.structure->first_bad_cell();
    if (!bad.empty()) return bad;
  }
  return "";
}

double DeformingScene::extra_rate(const Steps& steps) const {
  double extra = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) extra = std::max(extra, interfaces_[k].interface->change_of_velocity(steps[k]) / interfaces_[k].spacing);
  return extra;
}

std::string DeformingScene::faster_than(double speed, const Steps& steps) const {
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double fastest = DeformingInterface::fastest_node(steps[k]);
    if (!(fastest <= speed)) return "the surface of solid " + interfaces_[k].interface->setup().name + " moves at " + std::to_string(fastest);
  }
  return "";
}

double DeformingScene::fastest_wave() const {
  double fastest = 0;
  for (const SolidSetup& solid : setups_) fastest = std::max(fastest, solid.elastic.options.material.pressure_wave_speed());
  return fastest;
}

double DeformingScene::least_j() const {
  double least = 1;
  for (const auto& solid : solids_) least = std::min(least, solid->least_j());
  return least;
}

std::vector<InterfaceState> DeformingScene::states() const {
  std::vector<InterfaceState> states;
  for (const Member& member : interfaces_) states.push_back(member.interface->state());
  return states;
}

std::int64_t DeformingScene::computed() const { return computed_; }
std::int64_t DeformingScene::skipped() const { return skipped_; }

std::vector<double> DeformingScene::motion_state() const {
  std::vector<double> state = {begun_, stride_, end_};
  for (const Member& member : interfaces_) {
    const std::vector<double> of_member = member.interface->motion_state();
    state.insert(state.end(), of_member.begin(), of_member.end());
  }
  return state;
}

const double* DeformingScene::resume(const double* state, double time) {
  begun_ = *state++;
  stride_ = *state++;
  end_ = *state++;
  for (const Member& member : interfaces_) state = member.interface->resume(state);
  for (const auto& solid : solids_) solid->resume(time);
  return state;
}

}  // namespace mortise
