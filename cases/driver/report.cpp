#include "mortise/cases/driver/report.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/errors.hpp"
#include "mortise/cases/driver/interface_measures.hpp"
#include "mortise/cases/driver/mapped_bodies.hpp"

namespace mortise {
namespace {

std::vector<double> numbers(const Point<2>& x) { return {x.x(), x.y()}; }

std::string key_of(StressLaw law) {
  for (const std::string& key : stress_laws().keys())
    if (stress_laws().at(key) == law) return key;
  return "";
}

SolidSummary solid_summary(const std::string& name, StressLaw law, const SolidTotals& part, double least_j) {
  return {.name = name,
          .law = key_of(law),
          .mass = part.mass,
          .position = numbers(part.center),
          .velocity = numbers(part.momentum / part.mass),
          .momentum = numbers(part.momentum),
          .angular_momentum = part.angular_momentum,
          .kinetic_energy = part.kinetic_energy,
          .strain_energy = part.strain_energy,
          .least_j = least_j,
          .max_von_mises = part.max_von_mises};
}

}  // namespace

SolidSummary summary_of(const MappedSolid& solid) {
  return solid_summary(solid.name, solid.material.law, totals(solid), least_j(solid));
}

namespace {

InterfaceSummary summary_of(const InterfaceState& interface, double p_inf) {
  const InterfaceMeasures m = measure(interface, p_inf);
  return {.name = interface.name,
          .low = numbers(m.box.low),
          .high = numbers(m.box.high),
          .area = m.area,
          .pressure = m.pressure,
          .velocity = numbers(m.velocity),
          .force = numbers(m.force)};
}

template <int Dim>
std::int64_t cell_count(const ComponentGrid<Dim>& grid) {
  std::int64_t cells = 1;
  for (const int n : grid.cells) cells *= n;
  return cells;
}

}  // namespace

template <int Dim>
RunReport<Dim>::RunReport(const CaseDescription& description, const Scene<Dim>& scene, Simulation<Dim>& simulation,
                          const Communicator& comm)
    : description_(description),
      scene_(scene),
      simulation_(simulation),
      comm_(comm),
      closure_(closure(simulation)),
      last_time_(simulation.time()) {
  if (closure_.energy) initial_totals_ = scene_totals(simulation_);
}

template <int Dim>
void RunReport<Dim>::failed(const std::string& status, const std::string& reason) {
  status_ = status;
  reason_ = reason;
}

template <int Dim>
std::vector<double> RunReport<Dim>::totals_so_far() const {
  std::vector<double> totals = initial_totals_.state();
  for (const std::int64_t count :
       {tight_, earlier_contacts_ + simulation_.contacts(), earlier_repeated_steps_ + simulation_.repeats(),
        earlier_first_order_steps_ + simulation_.first_order_steps()})
    totals.push_back(static_cast<double>(count));
  for (const TimeNorms* norms : {&interface_velocity_, &interface_position_, &interface_pressure_}) {
    const std::vector<double> state = norms->state();
    totals.insert(totals.end(), state.begin(), state.end());
  }
  return totals;
}

template <int Dim>
void RunReport<Dim>::resume(const std::vector<double>& totals) {
  const double* next = totals.data();
  initial_totals_.resume(next);
  next += SceneTotals<Dim>::size;
  for (std::int64_t* count : {&tight_, &earlier_contacts_, &earlier_repeated_steps_, &earlier_first_order_steps_})
    *count = static_cast<std::int64_t>(*next++);
  for (TimeNorms* norms : {&interface_velocity_, &interface_position_, &interface_pressure_}) {
    norms->resume(next);
    next += TimeNorms::size;
  }
}

template <int Dim>
void RunReport<Dim>::track() {
  tight_ += simulation_.fluid().overlap_report().tight;
  if (!scene_.exact || simulation_.time() > scene_.exact->valid_until()) return;
  const double dt = simulation_.time() - last_time_;
  last_time_ = simulation_.time();
  track_bodies(dt);
  const InterfaceDeviations deviations = interface_deviations(simulation_, *scene_.exact);
  interface_position_.add(deviations.position, dt);
  interface_velocity_.add(deviations.velocity, dt);
  interface_pressure_.add(deviations.pressure, dt);
}

/// Of all rigid bodies the one that is farthest off counts.
template <int Dim>
void RunReport<Dim>::track_bodies(double dt) {
  const auto motions = scene_.exact->bodies(simulation_.time());
  if (!motions) return;
  double velocity = 0, position = 0;
  for (std::size_t b = 0; b < motions->size(); ++b) {
    const RigidBody<Dim>& body = simulation_.bodies()[b];
    velocity = std::max(velocity, (body.y.template head<Dim>() - (*motions)[b].velocity).norm());
    position = std::max(position, (body.pose.position - (*motions)[b].pose.position).norm());
  }
  interface_velocity_.add(std::span(&velocity, 1), dt);
  interface_position_.add(std::span(&position, 1), dt);
}

template <int Dim>
RunSummary RunReport<Dim>::collect(double wall_seconds) {
  RunSummary summary;
  summary.case_name = description_.name;
  summary.scheme = description_.scheme;
  summary.status = status_;
  summary.reason = reason_;
  summary.time = simulation_.time();
  summary.steps = simulation_.steps();
  summary.ranks = comm_.size();
  summary.wall_seconds = wall_seconds;
  const auto updates = static_cast<double>(comm_.sum(simulation_.cell_updates()));
  const auto skipped = static_cast<double>(comm_.sum(simulation_.cells_skipped()));
  summary.cell_updates = updates;
  summary.skipped_fraction = skipped > 0 ? skipped / (updates + skipped) : 0;
  summary.phases = simulation_.timers().seconds();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  summary.memory_bytes = comm_.sum(static_cast<std::int64_t>(usage.ru_maxrss) * 1024);
  add_grids(summary);
  add_bodies(summary);
  add_solids(summary);
  summary.contacts = earlier_contacts_ + simulation_.contacts();
  summary.repeated_steps = earlier_repeated_steps_ + simulation_.repeats();
  summary.first_order_steps = earlier_first_order_steps_ + simulation_.first_order_steps();
  summary.provenance = provenance();
  summary.case_text = description_.text;
  return summary;
}

template <int Dim>
void RunReport<Dim>::add_grids(RunSummary& summary) const {
  for (const ComponentGrid<Dim>& grid : simulation_.fluid().grids())
    summary.cells.emplace_back(grid.name, cell_count(grid));
  for (const auto& solid : simulation_.solids())
    for (const ComponentGrid<2>& grid : solid->grids()) summary.cells.emplace_back(grid.name, cell_count(grid));
  const OverlapReport overlap = simulation_.fluid().overlap_census();
  summary.overlap = {overlap.orphans, overlap.fringe, overlap.holes, tight_};
}

template <int Dim>
void RunReport<Dim>::add_bodies(RunSummary& summary) const {
  for (const RigidBody<Dim>& body : simulation_.bodies()) {
    BodySummary out{.name = body.name,
                    .position = {},
                    .velocity = {},
                    .angle = body.pose.angle,
                    .angular_velocity = Dim == 2 ? body.y[degrees_of_freedom<Dim> - 1] : 0.0};
    for (int d = 0; d < Dim; ++d) {
      out.position.push_back(body.pose.position[d]);
      out.velocity.push_back(body.y[d]);
    }
    summary.bodies.push_back(out);
  }
}

template <int Dim>
void RunReport<Dim>::add_solids(RunSummary& summary) const {
  for (const auto& solid : simulation_.solids())
    summary.solids.push_back(solid_summary(solid->setup().name, solid->law(), totals(*solid), solid->least_j()));
  for (const MappedSolid& solid : mapped_solids(simulation_)) summary.solids.push_back(summary_of(solid));
  for (const InterfaceState& interface : simulation_.interfaces())
    summary.interfaces.push_back(summary_of(interface, simulation_.fluid().setup().gas.p_inf));
}

template <int Dim>
void RunReport<Dim>::add_errors(RunSummary& summary) const {
  if (!scene_.exact || !finished() || simulation_.time() > scene_.exact->valid_until()) return;
  if (scene_.exact->describes_fluid() && !simulation_.fluid().grids().empty())
    for (const auto& entry : fluid_errors(simulation_, *scene_.exact)) summary.errors.push_back(entry);
  if (scene_.exact->describes_solid() && !simulation_.solids().empty())
    for (const auto& entry : solid_errors(simulation_, *scene_.exact)) summary.errors.push_back(entry);
  for (const auto& [name, norms] :
       {std::pair("interface.position", &interface_position_), std::pair("interface.velocity", &interface_velocity_),
        std::pair("interface.pressure", &interface_pressure_)})
    if (!norms->empty()) summary.errors.emplace_back(name, norms->norms());
}

template <int Dim>
void RunReport<Dim>::add_conservation(RunSummary& summary) const {
  if (!finished() || !closure_.energy) return;
  const SceneTotals<Dim> now = scene_totals(simulation_), &then = initial_totals_;
  const double momentum = (now.momentum - then.momentum).cwiseAbs().maxCoeff() / std::sqrt(then.mass * then.energy);
  summary.conservation = {(now.mass - then.mass) / then.mass,
                          closure_.momentum ? momentum : std::numeric_limits<double>::quiet_NaN(),
                          (now.energy - now.reference_work - then.energy + then.reference_work) / then.energy};
}

template <int Dim>
void RunReport<Dim>::write_headline(const RunSummary& summary) {
  char line[256];
  std::snprintf(line, sizeof line, "%s at t = %.6g, %lld steps, %.3g s, %.1f million cell updates/s, %.0f %% skipped",
                summary.status.c_str(), summary.time, static_cast<long long>(summary.steps), summary.wall_seconds,
                1e-6 * summary.cell_updates / std::max(summary.wall_seconds, 1e-9), 100 * summary.skipped_fraction);
  headline_ = line;
  for (const auto& [name, norms] : summary.errors) {
    std::snprintf(line, sizeof line, "\n  error %-22s L1 %.3e  L2 %.3e  max %.3e", name.c_str(), norms.l1, norms.l2,
                  norms.max);
    headline_ += line;
  }
}

template <int Dim>
void RunReport<Dim>::write(const std::string& path, double wall_seconds) {
  RunSummary summary = collect(wall_seconds);
  add_errors(summary);
  add_conservation(summary);
  write_headline(summary);
  agree(comm_, [&] {
    if (comm_.rank() == 0) write_summary(summary, path);
  });
}

template class RunReport<1>;
template class RunReport<2>;

}  // namespace mortise
