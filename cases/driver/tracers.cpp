#include "mortise/cases/driver/tracers.hpp"

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {

Tracers::Tracers(const std::vector<ProbeDescription>& probes, const std::vector<MappedSolid>& solids,
                 const IncompressibleSolver& flow, bool keep_history)
    : probes_(probes), solids_(solids), flow_(flow), keep_history_(keep_history), history_(probes.size()) {
  for (const ProbeDescription& probe : probes_) {
    positions_.emplace_back(probe.position[0], probe.position[1]);
    int holder = -1;
    for (std::size_t b = 0; b < solids_.size() && holder < 0; ++b)
      if (solids_[b].map->level_set()(probe.position[0], probe.position[1]) < 0) holder = static_cast<int>(b);
    solid_of_.push_back(holder);
  }
  follow_solids();
}

void Tracers::follow_solids() {
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    if (solid_of_[p] < 0) continue;
    const Point<2> X(probes_[p].position[0], probes_[p].position[1]);
    if (const auto point = material_point(solids_[static_cast<std::size_t>(solid_of_[p])], X)) positions_[p] = point->x;
  }
}

Point<2> Tracers::velocity_at(Point<2> x) const {
  const ComponentGrid<2>& grid = flow_.grid();
  for (int d = 0; d < 2; ++d) {
    const double length = grid.cells[static_cast<std::size_t>(d)] * grid.spacing[d];
    if (grid.periodic[static_cast<std::size_t>(d)])
      x[d] -= length * std::floor((x[d] - grid.origin[d]) / length);  // the image in the domain
  }
  std::vector<std::array<double, 2>> mine;
  if (const std::optional<FlowSample> sample = flow_.sample(x))
    mine.push_back({sample->velocity.x(), sample->velocity.y()});
  const auto all = grid.forest.communicator().gather_all(mine);
  return all.empty() ? Point<2>(0, 0) : Point<2>(all.front()[0], all.front()[1]);
}

void Tracers::move(double dt) {
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    if (solid_of_[p] >= 0) continue;
    const Point<2> half = 0.5 * dt * velocity_at(positions_[p]);
    positions_[p] += dt * velocity_at(positions_[p] + half);
  }
  follow_solids();
}

void Tracers::record() {
  if (!keep_history_) return;
  times_.push_back(flow_.time());
  for (std::size_t p = 0; p < probes_.size(); ++p)
    for (std::size_t c = 0; c < 2; ++c) history_[p][c].push_back(positions_[p][static_cast<Eigen::Index>(c)]);
}

std::vector<double> Tracers::state() const {
  std::vector<double> all{static_cast<double>(probes_.size())};
  for (const Point<2>& x : positions_) all.insert(all.end(), {x.x(), x.y()});
  all.insert(all.end(), times_.begin(), times_.end());
  for (const auto& of_probe : history_)
    for (const std::vector<double>& component : of_probe) all.insert(all.end(), component.begin(), component.end());
  return all;
}

void Tracers::restore(const std::vector<double>& state) {
  const std::size_t head = 1 + 2 * probes_.size(), columns = head;  // number, places; t, x and y of each
  if (state.size() < head || state.front() != static_cast<double>(probes_.size()) ||
      (state.size() - head) % columns != 0)
    throw EnvironmentError("cannot read the restart: it is of a run with other probes");
  const std::size_t rows = (state.size() - head) / columns;
  const double* next = state.data() + 1;
  for (Point<2>& x : positions_) x = {next[0], next[1]}, next += 2;
  const auto take = [&](std::vector<double>& column) {
    column.assign(next, next + rows);
    next += rows;
  };
  take(times_);
  for (auto& of_probe : history_)
    for (std::vector<double>& component : of_probe) take(component);
}

std::vector<OscillationSummary> Tracers::oscillations(const std::array<double, 2>& window) const {
  std::vector<OscillationSummary> all;
  const double slack = 1e-9 * (window[1] - window[0]);
  if (times_.empty() || times_.front() > window[0] + slack || times_.back() < window[1] - slack) return all;
  for (std::size_t p = 0; p < probes_.size(); ++p)
    for (std::size_t c = 0; c < 2; ++c)
      all.push_back({probes_[p].name, c == 0 ? "x" : "y", oscillation_of(times_, history_[p][c], window)});
  return all;
}

}  // namespace mortise
