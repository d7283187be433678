#include "mortise/cases/driver/report.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mortise/cases/driver/agreement.hpp"

namespace mortise {
namespace {

template <int Dim>
bool closed(const Boundaries<Dim>& boundaries) {
  return std::all_of(boundaries.kind.begin(), boundaries.kind.end(),
                     [](BoundaryKind kind) { return kind == BoundaryKind::wall || kind == BoundaryKind::periodic; });
}

template <int Dim>
bool all_periodic(const Boundaries<Dim>& boundaries) {
  return std::all_of(boundaries.kind.begin(), boundaries.kind.end(), [](BoundaryKind kind) { return kind == BoundaryKind::periodic; });
}

/// Totals of gas and bodies: mass, momentum, energy.
template <int Dim>
std::array<double, static_cast<std::size_t>(euler_components<Dim>)> scene_totals(const Simulation<Dim>& simulation) {
  auto sum = totals(simulation);
  for (const RigidBody<Dim>& body : simulation.bodies()) {
    for (int d = 0; d < Dim; ++d) sum[static_cast<std::size_t>(1 + d)] += body.mass * body.y[d];
    sum[Dim + 1] += body.kinetic_energy();
  }
  return sum;
}

}  // namespace

template <int Dim>
RunReport<Dim>::RunReport(const CaseDescription& description, const Scene<Dim>& scene, Simulation<Dim>& simulation, const Communicator& comm)
    : description_(description), scene_(scene), simulation_(simulation), comm_(comm), last_time_(simulation.time()) {
  if (closed(simulation_.fluid().setup().boundaries)) initial_totals_ = scene_totals(simulation_);
}

template <int Dim>
void RunReport<Dim>::failed(const std::string& status, const std::string& reason) {
  status_ = status;
  reason_ = reason;
}

template <int Dim>
std::vector<double> RunReport<Dim>::totals_so_far() const {
  std::vector<double> totals(initial_totals_.begin(), initial_totals_.end());
  for (const std::int64_t count : {tight_, earlier_contacts_ + simulation_.contacts(), earlier_repeated_steps_ + simulation_.repeats()})
    totals.push_back(static_cast<double>(count));
  totals.push_back(tracked_time_);
  for (const ErrorNorms& norms : {interface_velocity_, interface_position_}) totals.insert(totals.end(), {norms.l1, norms.l2, norms.max});
  return totals;
}

template <int Dim>
void RunReport<Dim>::resume(const std::vector<double>& totals) {
  const double* next = totals.data();
  for (double& total : initial_totals_) total = *next++;
  for (std::int64_t* count : {&tight_, &earlier_contacts_, &earlier_repeated_steps_}) *count = static_cast<std::int64_t>(*next++);
  tracked_time_ = *next++;
  for (ErrorNorms* norms : {&interface_velocity_, &interface_position_})
    for (double* norm : {&norms->l1, &norms->l2, &norms->max}) *norm = *next++;
}

template <int Dim>
void RunReport<Dim>::track() {
  tight_ += simulation_.fluid().overlap().report().tight;
  if (!scene_.exact) return;
  const auto motions = scene_.exact->bodies(simulation_.time());
  if (!motions || simulation_.time() > scene_.exact->valid_until()) return;
  const double dt = simulation_.time() - last_time_;
  last_time_ = simulation_.time();
  tracked_time_ += dt;
  double velocity = 0, position = 0;
  for (std::size_t b = 0; b < motions->size(); ++b) {
    const RigidBody<Dim>& body = simulation_.bodies()[b];
    velocity = std::max(velocity, (body.y.template head<Dim>() - (*motions)[b].velocity).norm());
    position = std::max(position, (body.pose.position - (*motions)[b].pose.position).norm());
  }
  const auto add = [dt](ErrorNorms& norms, double error) {
    norms.l1 += error * dt;
    norms.l2 += error * error * dt;
    norms.max = std::max(norms.max, error);
  };
  add(interface_velocity_, velocity);
  add(interface_position_, position);
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
  for (const ComponentGrid<Dim>& grid : simulation_.fluid().grids()) {
    std::int64_t cells = 1;
    for (const int n : grid.cells) cells *= n;
    summary.cells.emplace_back(grid.name, cells);
  }
  for (const RigidBody<Dim>& body : simulation_.bodies()) {
    BodySummary out{.name = body.name, .position = {}, .velocity = {}, .angle = body.pose.angle, .angular_velocity = Dim == 2 ? body.y[degrees_of_freedom<Dim> - 1] : 0.0};
    for (int d = 0; d < Dim; ++d) {
      out.position.push_back(body.pose.position[d]);
      out.velocity.push_back(body.y[d]);
    }
    summary.bodies.push_back(out);
  }
  const OverlapReport overlap = simulation_.fluid().overlap().census();
  summary.overlap = {overlap.orphans, overlap.fringe, overlap.holes, tight_};
  summary.contacts = earlier_contacts_ + simulation_.contacts();
  summary.repeated_steps = earlier_repeated_steps_ + simulation_.repeats();
  summary.provenance = provenance();
  summary.case_text = description_.text;
  return summary;
}

template <int Dim>
void RunReport<Dim>::write(const std::string& path, double wall_seconds) {
  RunSummary summary = collect(wall_seconds);
  if (scene_.exact && finished() && simulation_.time() <= scene_.exact->valid_until()) {
    if (scene_.exact->describes_fluid())
      for (const auto& [name, norms] : fluid_errors(simulation_, *scene_.exact)) summary.errors.emplace_back(name, norms);
    if (tracked_time_ > 0)
      for (auto [name, norms] : {std::pair("interface.position", interface_position_), std::pair("interface.velocity", interface_velocity_)})
        summary.errors.emplace_back(name, ErrorNorms{norms.l1 / tracked_time_, std::sqrt(norms.l2 / tracked_time_), norms.max});
  }
  const Boundaries<Dim>& boundaries = simulation_.fluid().setup().boundaries;
  if (finished() && closed(boundaries)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto now = scene_totals(simulation_);
    const auto change = [&](std::size_t k, double scale) { return (now[k] - initial_totals_[k]) / scale; };
    double momentum = 0;
    for (std::size_t d = 0; d < Dim; ++d) momentum = std::max(momentum, std::fabs(change(1 + d, std::sqrt(initial_totals_[0] * initial_totals_[Dim + 1]))));
    summary.conservation = {change(0, initial_totals_[0]), all_periodic(boundaries) ? momentum : nan, change(Dim + 1, initial_totals_[Dim + 1])};
  }
  char line[256];
  std::snprintf(line, sizeof line, "%s at t = %.6g, %lld steps, %.3g s, %.1f million cell updates/s, %.0f %% skipped", summary.status.c_str(),
                summary.time, static_cast<long long>(summary.steps), wall_seconds, 1e-6 * summary.cell_updates / std::max(wall_seconds, 1e-9),
                100 * summary.skipped_fraction);
  headline_ = line;
  for (const auto& [name, norms] : summary.errors) {
    std::snprintf(line, sizeof line, "\n  error %-22s L1 %.3e  L2 %.3e  max %.3e", name.c_str(), norms.l1, norms.l2, norms.max);
    headline_ += line;
  }
  agree(comm_, [&] {
    if (comm_.rank() == 0) write_summary(summary, path);
  });
}

template class RunReport<1>;
template class RunReport<2>;

}  // namespace mortise
