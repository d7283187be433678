#include "mortise/cases/driver/flow_run.hpp"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/driver/output_directory.hpp"
#include "mortise/cases/driver/progress.hpp"
#include "mortise/cases/driver/recorder.hpp"
#include "mortise/cases/driver/report.hpp"
#include "mortise/cases/scene/flow_scene.hpp"
#include "mortise/coupler/reference_map/flow_grid.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/csv.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {
namespace {

constexpr double most_solid_share = 0.5;  // cells with more are drawn as solid

FlowScene agreed_scene(const CaseDescription& description, const Communicator& comm) {
  FlowScene scene;
  agree(comm, [&] { scene = build_flow_scene(description); });
  return scene;
}

/// Velocity, vorticity and pressure on the cells, then the solids.
Snapshot snapshot_of(const IncompressibleSolver& flow, const std::vector<MappedSolid>& solids) {
  struct Record {
    std::int64_t index;
    std::array<double, 4> values;
    bool hole;
  };
  const ComponentGrid<2>& grid = flow.grid();
  const auto s = static_cast<std::size_t>(grid.shape.stride);
  std::vector<Record> mine;
  for_each_local_cell<2>(grid, [&](int t, const Index<2>&, std::size_t index, std::size_t k) {
    const double *u = flow.velocity().tile(t).component(0) + k, *v = flow.velocity().tile(t).component(1) + k,
                 *p = flow.pressure().tile(t).component(0) + k;
    const double curl = 0.5 * ((v[1] - *(v - 1)) / grid.spacing.x() - (u[s] - *(u - s)) / grid.spacing.y());
    double share = 0;
    for (const MappedSolid& solid : solids)
      if (solid.map->field().tile(t).allocated())
        share += solid_share(solid.map->field().tile(t).component(2)[k], 1 / solid.blur);
    mine.push_back({static_cast<std::int64_t>(index),
                    {*u, *v, curl, 0.25 * (p[0] + p[1] + p[s] + p[s + 1])},
                    share > most_solid_share});
  });
  GridSnapshot out;
  out.name = grid.name;
  out.cells = grid.cells;
  for (int j = 0; j <= out.cells[1]; ++j)
    for (int i = 0; i <= out.cells[0]; ++i) {
      out.x.push_back(grid.origin.x() + i * grid.spacing.x());
      out.y.push_back(grid.origin.y() + j * grid.spacing.y());
    }
  out.mask.assign(out.cell_count(), mask_active);
  for (const char* name : {"velocity_x", "velocity_y", "vorticity", "pressure"})
    out.fields.emplace_back(name, std::vector<double>(out.cell_count(), 0.0));
  for (const Record& record : grid.forest.communicator().gather_all(mine)) {
    const auto k = static_cast<std::size_t>(record.index);
    if (record.hole) out.mask[k] = mask_hole;
    for (std::size_t f = 0; f < 4; ++f) out.fields[f].second[k] = record.values[f];
  }
  Snapshot snapshot;
  snapshot.time = flow.time();
  snapshot.step = static_cast<int>(flow.counts().steps);
  snapshot.grids.push_back(std::move(out));
  for (const MappedSolid& solid : solids) add_mapped_solid(solid, snapshot);
  return snapshot;
}

class FlowRun {
 public:
  FlowRun(const CaseDescription& description, const RunOptions& options, const Communicator& comm)
      : description_(description),
        options_(options),
        comm_(comm),
        scene_(agreed_scene(description, comm)),
        grid_(make_flow_grid(scene_.flow, comm)),
        solids_(scene_.solids.bodies.empty() ? nullptr : std::make_unique<FlowSolids>(scene_.solids, grid_)),
        flow_(scene_.flow, comm, solids_.get()) {
    if (solids_) {
      agree(comm_, [&] { solids_->follow(flow_.velocity()); });
      mapped_ = mapped_solids(*solids_, flow_);
    }
    agree(comm_, [&] { flow_.initialize(); });
  }

  int operator()() {
    directory_ = options_.output.empty() ? description_.output : options_.output;
    if (!options_.restart.empty())
      throw InputError("runs with fluid.kind = \"incompressible\" write no checkpoints and cannot be restarted");
    end_ = options_.until ? std::min(*options_.until, description_.time_end) : description_.time_end;
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      check_output_directory(directory_, options_.overwrite, false);
      prepare_output_directory(directory_, options_.overwrite);
      if (solids_)
        solids_file_.emplace(
            directory_ + "/solids.csv",
            std::vector<std::string>{"t", "solid", "x", "y", "velocity_x", "velocity_y", "angular_momentum", "volume"});
      if (!description_.probes.empty())
        tracers_file_.emplace(directory_ + "/tracers.csv", std::vector<std::string>{"t", "probe", "x", "y"});
      if (description_.hdf5 && description_.frames > 0) series_.emplace(directory_);
    });
    for (const ProbeDescription& probe : description_.probes)
      tracers_.push_back({probe.position[0], probe.position[1]});
    Progress progress(0, end_, options_.quiet || comm_.rank() != 0);
    int status = 0;
    std::string reason;
    try {
      record();
      frame(0);
      loop(progress);
    } catch (const NumericalError& error) {
      reason = "the computation failed at t = " + std::to_string(flow_.time()) + ": " + error.what();
      status = 3;
    }
    progress.finish();
    finish(progress.seconds(), reason);
    return status;
  }

 private:
  void loop(Progress& progress) {
    int next = 1;
    while (flow_.time() < end_ * (1 - 1e-14)) {
      const double event =
          description_.frames > 0 ? std::min(end_, description_.time_end * next / description_.frames) : end_;
      const double left = event - flow_.time(), fastest = flow_.rate();
      const double wanted = std::ceil(left * fastest * (1 - 1e-12));  // so many steps of one size
      const double dt = flow_.advance(wanted > 1 && wanted < 1e9 ? left / wanted : left);
      updates_ += static_cast<double>(grid_.cells[0]) * grid_.cells[1];
      move_tracers(dt);
      const auto scope = flow_.timers()("output");
      record();
      if (description_.frames > 0 && flow_.time() >= event * (1 - 1e-13)) frame(next++);
      progress.step(flow_.time(), flow_.counts().steps, dt, static_cast<std::int64_t>(updates_));
    }
  }

  /// Points outside solids move with the fluid (explicit midpoint rule between two steps); those inside are found by
  /// their map.
  void move_tracers(double dt) {
    for (Point<2>& x : tracers_) {
      if (solid_of(&x - tracers_.data()) >= 0) continue;
      const Point<2> v = velocity_at(x);
      x += dt * velocity_at(x + 0.5 * dt * v);
    }
  }

  Point<2> velocity_at(const Point<2>& x) const {
    std::vector<std::array<double, 2>> mine;
    if (const std::optional<FlowSample> sample = flow_.sample(x))
      mine.push_back({sample->velocity.x(), sample->velocity.y()});
    const auto all = comm_.gather_all(mine);
    return all.empty() ? Point<2>(0, 0) : Point<2>(all.front()[0], all.front()[1]);
  }

  /// The solid that holds a probe at t = 0; −1: none.
  int solid_of(std::ptrdiff_t probe) const {
    const std::array<double, 2>& X = description_.probes[static_cast<std::size_t>(probe)].position;
    for (std::size_t b = 0; b < mapped_.size(); ++b)
      if (mapped_[b].map->level_set()(X[0], X[1]) < 0) return static_cast<int>(b);
    return -1;
  }

  void record() {
    std::vector<std::vector<CsvValue>> rows, points;
    for (const MappedSolid& solid : mapped_) {
      const SolidTotals sum = totals(solid, false);
      const Point<2> v = sum.momentum / sum.mass;
      rows.push_back({flow_.time(), solid.name, sum.center.x(), sum.center.y(), v.x(), v.y(), sum.angular_momentum,
                      sum.mass / solid.material.density});
    }
    for (std::size_t p = 0; p < tracers_.size(); ++p) {
      const int solid = solid_of(static_cast<std::ptrdiff_t>(p));
      if (solid >= 0) {
        const std::array<double, 2>& X = description_.probes[p].position;
        if (const auto point = material_point(mapped_[static_cast<std::size_t>(solid)], {X[0], X[1]}))
          tracers_[p] = point->x;
      }
      points.push_back({flow_.time(), description_.probes[p].name, tracers_[p].x(), tracers_[p].y()});
    }
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      for (const auto& row : rows) solids_file_->row(row);
      for (const auto& row : points) tracers_file_->row(row);
    });
  }

  void frame(int number) {
    if (description_.frames == 0) return;
    const Snapshot snapshot = snapshot_of(flow_, mapped_);
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      if (series_) series_->write(snapshot);
      last_picture_ = write_frame(snapshot, description_, directory_, number);
    });
  }

  void finish(double seconds, const std::string& reason) {
    RunSummary summary;
    summary.case_name = description_.name;
    summary.scheme = description_.scheme;
    summary.status = reason.empty() ? "finished" : "unstable";
    summary.reason = reason;
    summary.time = flow_.time();
    summary.steps = flow_.counts().steps;
    summary.ranks = comm_.size();
    summary.wall_seconds = seconds;
    summary.cell_updates = updates_;
    summary.phases = flow_.timers().seconds();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    summary.memory_bytes = comm_.sum(static_cast<std::int64_t>(usage.ru_maxrss) * 1024);
    summary.cells.emplace_back(grid_.name, static_cast<std::int64_t>(grid_.cells[0]) * grid_.cells[1]);
    for (const MappedSolid& solid : mapped_) summary.solids.push_back(summary_of(solid));
    summary.overlap.orphans = comm_.sum(solids_ ? solids_->orphans() : 0);
    summary.provenance = provenance();
    summary.case_text = description_.text;
    agree(comm_, [&] {
      if (comm_.rank() == 0) write_summary(summary, directory_ + "/summary.json");
    });
    if (comm_.rank() != 0) return;
    if (!reason.empty()) std::fprintf(stderr, "mortise: %s\n", reason.c_str());
    if (options_.quiet) return;
    std::printf("%s: %s at t = %.6g, %lld steps, %.3g s, %.1f million cell updates/s\n", description_.name.c_str(),
                summary.status.c_str(), summary.time, static_cast<long long>(summary.steps), seconds,
                1e-6 * updates_ / std::max(seconds, 1e-9));
    std::printf("summary   %s/summary.json\n", directory_.c_str());
    if (!last_picture_.empty()) std::printf("picture   %s\n", last_picture_.c_str());
  }

  const CaseDescription& description_;
  RunOptions options_;
  Communicator comm_;
  FlowScene scene_;
  ComponentGrid<2> grid_;
  std::unique_ptr<FlowSolids> solids_;
  IncompressibleSolver flow_;
  std::vector<MappedSolid> mapped_;
  std::vector<Point<2>> tracers_;
  std::string directory_, last_picture_;
  double end_ = 0, updates_ = 0;
  std::optional<CsvWriter> solids_file_, tracers_file_;
  std::optional<SeriesWriter> series_;
};

}  // namespace

int run_flow_case(const CaseDescription& description, const RunOptions& options, const Communicator& comm) {
  return FlowRun(description, options, comm)();
}

void check_flow_case_runs(const CaseDescription& description, const Communicator& comm) {
  FlowRun(description, {}, comm);
}

}  // namespace mortise
