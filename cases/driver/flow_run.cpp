#include "mortise/cases/driver/flow_run.hpp"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/flow_snapshot.hpp"
#include "mortise/cases/driver/output_directory.hpp"
#include "mortise/cases/driver/progress.hpp"
#include "mortise/cases/driver/recorder.hpp"
#include "mortise/cases/driver/report.hpp"
#include "mortise/cases/driver/schedule.hpp"
#include "mortise/cases/driver/tracers.hpp"
#include "mortise/cases/scene/flow_scene.hpp"
#include "mortise/coupler/reference_map/flow_grid.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/csv.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {
namespace {

const std::vector<std::string> solid_columns = {
    "t", "solid", "x", "y", "velocity_x", "velocity_y", "angular_momentum", "volume"};
const std::vector<std::string> tracer_columns = {"t", "probe", "x", "y"};

FlowScene agreed_scene(const CaseDescription& description, const Communicator& comm) {
  FlowScene scene;
  agree(comm, [&] { scene = build_flow_scene(description); });
  return scene;
}

/// One run of one case.
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
    if (options_.restart.empty()) {
      agree(comm_, [&] { flow_.initialize(); });
      tracers_.emplace(description_.probes, mapped_, flow_, description_.oscillation.has_value());
    }
  }

  int operator()() {
    open();
    Progress progress(flow_.time(), end_, options_.quiet || comm_.rank() != 0);
    int status = 0;
    std::string reason;
    try {
      if (!resumed_) {
        record();
        frame(0);
      }
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
  /// The directory, the state that the run begins with, and the files.
  void open() {
    directory_ = !options_.output.empty()    ? options_.output
                 : !options_.restart.empty() ? options_.restart
                                             : description_.output;
    end_ = options_.until ? std::min(*options_.until, description_.time_end) : description_.time_end;
    resumed_ = !options_.restart.empty();
    std::error_code ignored;
    const bool continued = resumed_ && (directory_ == options_.restart ||
                                        std::filesystem::equivalent(directory_, options_.restart, ignored));
    agree(comm_, [&] {
      if (comm_.rank() == 0) check_output_directory(directory_, options_.overwrite, continued);
    });
    if (resumed_) resume();
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      prepare_output_directory(directory_, options_.overwrite && !continued);
      if (solids_) start(solids_file_, "/solids.csv", solid_columns);
      if (!description_.probes.empty()) start(tracers_file_, "/tracers.csv", tracer_columns);
      const double before = resumed_ ? flow_.time() : -std::numeric_limits<double>::infinity();
      if (description_.hdf5 && description_.frames > 0) series_.emplace(directory_, before);
    });
  }

  void start(std::optional<CsvWriter>& file, const char* name, const std::vector<std::string>& columns) const {
    if (resumed_)
      file.emplace(CsvWriter::truncate_after(directory_ + name, columns, flow_.time()));
    else
      file.emplace(directory_ + name, columns);
  }

  void resume() {
    Checkpoint checkpoint;
    agree(comm_, [&] {
      checkpoint = read_any_checkpoint(options_.restart);
      if (checkpoint.motion.empty() || checkpoint.totals.size() != 1 || !fits(checkpoint.tiles, flow_, solids_.get()))
        refuse_checkpoint(options_.restart);
    });
    scatter_tiles(checkpoint.tiles, checkpoint.motion.front(), flow_, solids_.get());
    tracers_.emplace(description_.probes, mapped_, flow_, description_.oscillation.has_value());
    agree(comm_, [&] { tracers_->restore({checkpoint.motion.begin() + 1, checkpoint.motion.end()}); });
    earlier_steps_ = static_cast<std::int64_t>(checkpoint.totals.front());
    next_frame_ = next_frame(description_, flow_.time());
  }

  std::int64_t steps() const { return earlier_steps_ + flow_.counts().steps; }

  /// The step from here to `event`, of as many equal ones as it takes.
  double step_to(double event) const {
    const double left = event - flow_.time(), count = std::ceil(left * flow_.rate() * (1 - 1e-12));
    return count > 1 && count < 1e9 ? left / count : left;
  }

  void loop(Progress& progress) {
    const double interval = description_.checkpoint_interval;
    double next_checkpoint = next_multiple(flow_.time(), interval);
    bool cut_short = false;  // steps are no longer those of the whole run
    while (flow_.time() < end_ * (1 - 1e-14)) {
      const double event = frame_time(description_, next_frame_);
      if (!cut_short && flow_.time() + step_to(event) > end_ * (1 + 1e-13)) {
        cut_short = true;
        checkpoint();
      }
      const double dt = flow_.advance(step_to(cut_short ? end_ : event));
      updates_ += static_cast<double>(grid_.cells[0]) * grid_.cells[1];
      tracers_->move(dt);
      const auto scope = flow_.timers()("output");
      record();
      if (description_.frames > 0 && flow_.time() >= event * (1 - 1e-13)) frame(next_frame_++);
      if (!cut_short && flow_.time() >= next_checkpoint) {
        next_checkpoint = next_multiple(flow_.time(), interval);
        checkpoint();
      }
      progress.step(flow_.time(), steps(), dt, static_cast<std::int64_t>(updates_));
    }
    if (description_.frames > 0 && cut_short) frame(next_frame_);
    if (end_ < description_.time_end && !cut_short) checkpoint();
  }

  void checkpoint() {
    Checkpoint state{gather_tiles(flow_, solids_.get()), {flow_.time()}, {static_cast<double>(steps())}};
    for (const double value : tracers_->state()) state.motion.push_back(value);
    agree(comm_, [&] {
      if (comm_.rank() == 0) write_checkpoint(state, description_.text, directory_);
    });
  }

  void record() {
    std::vector<std::vector<CsvValue>> rows, points;
    for (const MappedSolid& solid : mapped_) {
      const SolidTotals sum = totals(solid, false);
      const Point<2> v = sum.momentum / sum.mass;
      rows.push_back({flow_.time(), solid.name, sum.center.x(), sum.center.y(), v.x(), v.y(), sum.angular_momentum,
                      sum.mass / solid.material.density});
    }
    tracers_->record();
    for (std::size_t p = 0; p < tracers_->positions().size(); ++p)
      points.push_back({flow_.time(), tracers_->name(p), tracers_->positions()[p].x(), tracers_->positions()[p].y()});
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      for (const auto& row : rows) solids_file_->row(row);
      for (const auto& row : points) tracers_file_->row(row);
    });
  }

  void frame(int number) {
    if (description_.frames == 0) return;
    const Snapshot snapshot = gather_flow_snapshot(flow_, mapped_, description_.contours, steps());
    agree(comm_, [&] {
      if (comm_.rank() != 0) return;
      if (series_) series_->write(snapshot);
      last_picture_ = write_frame(snapshot, description_, directory_, number);
    });
  }

  RunSummary summary(double seconds, const std::string& reason) {
    RunSummary summary;
    summary.case_name = description_.name;
    summary.scheme = description_.scheme;
    summary.status = reason.empty() ? "finished" : "unstable";
    summary.reason = reason;
    summary.time = flow_.time();
    summary.steps = steps();
    summary.ranks = comm_.size();
    summary.wall_seconds = seconds;
    summary.cell_updates = updates_;
    summary.phases = flow_.timers().seconds();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    summary.memory_bytes = comm_.sum(static_cast<std::int64_t>(usage.ru_maxrss) * 1024);
    summary.cells.emplace_back(grid_.name, static_cast<std::int64_t>(grid_.cells[0]) * grid_.cells[1]);
    for (const MappedSolid& solid : mapped_) summary.solids.push_back(summary_of(solid));
    if (description_.oscillation) summary.oscillations = tracers_->oscillations(*description_.oscillation);
    summary.overlap.orphans = comm_.sum(solids_ ? solids_->orphans() : 0);
    summary.provenance = provenance();
    summary.case_text = description_.text;
    return summary;
  }

  void finish(double seconds, const std::string& reason) {
    const RunSummary result = summary(seconds, reason);
    agree(comm_, [&] {
      if (comm_.rank() == 0) write_summary(result, directory_ + "/summary.json");
    });
    if (comm_.rank() != 0) return;
    if (!reason.empty()) std::fprintf(stderr, "mortise: %s\n", reason.c_str());
    if (options_.quiet) return;
    std::printf("%s: %s at t = %.6g, %lld steps, %.3g s, %.1f million cell updates/s\n", description_.name.c_str(),
                result.status.c_str(), result.time, static_cast<long long>(result.steps), seconds,
                1e-6 * updates_ / std::max(seconds, 1e-9));
    for (const OscillationSummary& found : result.oscillations)
      std::printf("%s, %s: amplitude %.4g at frequency %.4g about %.4g\n", found.probe.c_str(), found.component.c_str(),
                  found.oscillation.amplitude, found.oscillation.frequency, found.oscillation.mean);
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
  std::optional<Tracers> tracers_;
  std::string directory_, last_picture_;
  double end_ = 0, updates_ = 0;
  bool resumed_ = false;
  int next_frame_ = 1;
  std::int64_t earlier_steps_ = 0;  // before the restart
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
