#include "mortise/cases/driver/run_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "mortise/cases/driver/agreement.hpp"
#include "mortise/cases/driver/flow_run.hpp"
#include "mortise/cases/driver/initial_check.hpp"
#include "mortise/cases/driver/output_directory.hpp"
#include "mortise/cases/driver/progress.hpp"
#include "mortise/cases/driver/recorder.hpp"
#include "mortise/cases/driver/report.hpp"
#include "mortise/cases/driver/schedule.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

template <int Dim>
Scene<Dim> agreed_scene(const CaseDescription& description, const Communicator& comm) {
  Scene<Dim> scene;
  agree(comm, [&] { scene = build_scene<Dim>(description); });
  return scene;
}

/// One run of one case.
template <int Dim>
class Run {
 public:
  Run(CaseDescription description, const RunOptions& options, const Communicator& comm)
      : description_(std::move(description)), options_(options), comm_(comm), scene_(agreed_scene<Dim>(description_, comm)), simulation_(comm, scene_.setup) {}

  int operator()() {
    start();
    Recorder<Dim> recorder(description_, simulation_, directory_, comm_, resume_time_);
    Progress progress(simulation_.time(), end_, options_.quiet || comm_.rank() != 0);
    RunReport<Dim> report(description_, scene_, simulation_, comm_);
    int status = 0;
    try {
      begin(recorder, report);
      loop(recorder, progress, report);
    } catch (const NumericalError& error) {
      report.failed("unstable", error.what());
      status = 3;
    } catch (const AgreedFailure& failure) {
      report.failed("failed", failure.what());
      status = failure.status;
    }
    progress.finish();
    try {
      report.write(directory_ + "/summary.json", progress.seconds());
    } catch (const AgreedFailure&) {
      if (status == 0) throw;
    }
    if (comm_.rank() == 0) announce(recorder, report);
    return status;
  }

 private:
  void start() {
    directory_ = !options_.output.empty() ? options_.output : !options_.restart.empty() ? options_.restart : description_.output;
    end_ = options_.until ? std::min(*options_.until, description_.time_end) : description_.time_end;
    std::error_code ignored;
    const bool restart = !options_.restart.empty();
    const bool continued = restart && (directory_ == options_.restart || std::filesystem::equivalent(directory_, options_.restart, ignored));
    agree(comm_, [&] {
      if (comm_.rank() == 0) check_output_directory(directory_, options_.overwrite, continued);
    });
    agree(comm_, [&] { simulation_.initialize(); });  // refuses what cannot begin, on all ranks alike
    agree(comm_, [&] { check_initial_state(description_, simulation_); });
    if (restart) {
      Checkpoint checkpoint;
      agree(comm_, [&] { checkpoint = read_checkpoint(options_.restart, simulation_); });
      simulation_.resume(checkpoint.motion);  // cuts the holes, so that the tiles to be filled are there
      scatter_tiles(checkpoint.tiles, simulation_);
      simulation_.resume(checkpoint.motion);
      earlier_totals_ = checkpoint.totals;
      resume_time_ = simulation_.time();
      next_frame_ = next_frame(description_, simulation_.time());
    }
    agree(comm_, [&] {
      if (comm_.rank() == 0) prepare_output_directory(directory_, options_.overwrite && !continued);
    });
  }

  /// What is written and summed up at t = 0.
  void begin(Recorder<Dim>& recorder, RunReport<Dim>& report) {
    if (resume_time_) {
      report.resume(earlier_totals_);
    } else {
      report.track();
      recorder.histories(simulation_);
      if (description_.frames > 0) recorder.frame(simulation_, 0);
    }
    recorder.settle();
  }

  void loop(Recorder<Dim>& recorder, Progress& progress, RunReport<Dim>& report) {
    const double interval = description_.checkpoint_interval;
    double next_checkpoint = next_multiple(simulation_.time(), interval);
    bool cut_short = false;  // steps are no longer those of the whole run
    while (simulation_.time() < end_) {
      const double event = frame_time(description_, next_frame_);
      if (end_ < event && !cut_short && !simulation_.same_step(end_, event)) {
        cut_short = true;
        recorder.checkpoint(simulation_, report.totals_so_far());
      }
      const double dt = simulation_.advance(std::min(event, end_));
      report.track();
      {
        const auto scope = simulation_.timers()("output");
        recorder.histories(simulation_);
        if (description_.frames > 0 && simulation_.time() >= event) recorder.frame(simulation_, next_frame_++);
        if (!cut_short && simulation_.time() >= next_checkpoint) {
          next_checkpoint = next_multiple(simulation_.time(), interval);
          recorder.checkpoint(simulation_, report.totals_so_far());
        }
        recorder.settle();
      }
      progress.step(simulation_.time(), simulation_.steps(), dt, simulation_.cell_updates());
    }
    if (description_.frames > 0 && cut_short) recorder.frame(simulation_, next_frame_);
    if (end_ < description_.time_end && !cut_short) recorder.checkpoint(simulation_, report.totals_so_far());
    recorder.settle();
  }

  void announce(const Recorder<Dim>& recorder, const RunReport<Dim>& report) const {
    if (!report.finished()) std::fprintf(stderr, "mortise: %s\n", report.reason().c_str());
    if (options_.quiet) return;
    std::printf("%s: %s\n", description_.name.c_str(), report.headline().c_str());
    std::printf("summary   %s/summary.json\n", directory_.c_str());
    if (description_.frames > 0 && description_.hdf5) std::printf("fields    %s/mortise.xdmf (ParaView, VisIt)\n", directory_.c_str());
    if (!recorder.last_picture().empty()) std::printf("picture   %s\n", recorder.last_picture().c_str());
  }

  CaseDescription description_;
  RunOptions options_;
  Communicator comm_;
  Scene<Dim> scene_;
  Simulation<Dim> simulation_;
  std::string directory_;
  double end_ = 0;
  int next_frame_ = 1;
  std::optional<double> resume_time_;
  std::vector<double> earlier_totals_;
};

CaseDescription adjusted(CaseDescription description, const RunOptions& options) {
  if (options.no_skip) description.skip = false;
  if (options.frames) description.frames = *options.frames;
  return description;
}

}  // namespace

int run_case(CaseDescription description, const RunOptions& options, const Communicator& comm) {
  description = adjusted(std::move(description), options);
  if (description.incompressible()) return run_flow_case(description, options, comm);
  if (scene_dimension(description) == 1) return Run<1>(std::move(description), options, comm)();
  return Run<2>(std::move(description), options, comm)();
}

void check_case_runs(const CaseDescription& description, const Communicator& comm) {
  const auto build = [&]<int Dim>() {
    Scene<Dim> scene = agreed_scene<Dim>(description, comm);
    Simulation<Dim> simulation(comm, std::move(scene.setup));
    agree(comm, [&] { simulation.initialize(); });
    agree(comm, [&] { check_initial_state(description, simulation); });
  };
  if (description.incompressible()) return check_flow_case_runs(description, comm);
  if (scene_dimension(description) == 1)
    build.template operator()<1>();
  else
    build.template operator()<2>();
}

}  // namespace mortise
