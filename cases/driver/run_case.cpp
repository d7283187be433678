#include "mortise/cases/driver/run_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mortise/cases/driver/output_directory.hpp"
#include "mortise/cases/driver/progress.hpp"
#include "mortise/cases/driver/recorder.hpp"
#include "mortise/cases/driver/report.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// One run of one case. The times of frames are those of the whole case, whatever --until says, so that a run in pieces
/// takes the same steps as a run in one go.
template <int Dim>
class Run {
 public:
  Run(CaseDescription description, const RunOptions& options, const Communicator& comm)
      : description_(std::move(description)), options_(options), comm_(comm), scene_(build_scene<Dim>(description_)), simulation_(comm, scene_.setup) {}

  int operator()() {
    start();
    Recorder<Dim> recorder(description_, directory_, comm_, resume_time_);
    Progress progress(simulation_.time(), end_, options_.quiet || comm_.rank() != 0);
    RunReport<Dim> report(description_, scene_, simulation_, comm_);
    if (!resume_time_) {
      recorder.histories(simulation_);
      if (description_.frames > 0) recorder.frame(simulation_, 0);
    }
    report.track();
    try {
      loop(recorder, progress, report);
    } catch (const NumericalError& error) {
      report.failed(error.what());
    }
    progress.finish();
    report.write(directory_ + "/summary.json", progress.seconds());
    if (comm_.rank() == 0) announce(recorder, report);
    return report.finished() ? 0 : 3;
  }

 private:
  void start() {
    directory_ = !options_.output.empty() ? options_.output : !options_.restart.empty() ? options_.restart : description_.output;
    end_ = options_.until ? std::min(*options_.until, description_.time_end) : description_.time_end;
    const bool restart = !options_.restart.empty();
    if (comm_.rank() == 0) check_output_directory(directory_, options_.overwrite, restart);
    simulation_.initialize();
    if (restart) {
      next_frame_ = read_checkpoint(options_.restart, simulation_);
      resume_time_ = simulation_.time();
    }
    if (comm_.rank() == 0) prepare_output_directory(directory_, options_.overwrite && !restart);
    comm_.barrier();
  }

  double frame_time(int number) const { return description_.time_end * number / description_.frames; }

  void loop(Recorder<Dim>& recorder, Progress& progress, RunReport<Dim>& report) {
    double next_checkpoint = simulation_.time() + description_.checkpoint_interval;
    bool cut_short = false;  // steps are no longer those of the whole run
    while (simulation_.time() < end_) {
      const double event = description_.frames > 0 ? frame_time(next_frame_) : description_.time_end;
      if (end_ < event && !cut_short && simulation_.next_step(end_) != simulation_.next_step(event)) {
        cut_short = true;
        recorder.checkpoint(simulation_, next_frame_);
      }
      const double dt = simulation_.advance(std::min(event, end_));
      {
        const auto scope = simulation_.timers()("output");
        recorder.histories(simulation_);
        if (description_.frames > 0 && simulation_.time() >= event) recorder.frame(simulation_, next_frame_++);
        if (description_.checkpoint_interval > 0 && !cut_short && simulation_.time() >= next_checkpoint) {
          next_checkpoint += description_.checkpoint_interval;
          recorder.checkpoint(simulation_, next_frame_);
        }
      }
      report.track();
      progress.step(simulation_.time(), simulation_.steps(), dt, simulation_.cell_updates());
    }
    if (description_.frames > 0 && cut_short) recorder.frame(simulation_, next_frame_);
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
};

CaseDescription adjusted(CaseDescription description, const RunOptions& options) {
  if (options.no_skip) description.skip = false;
  if (options.frames) description.frames = *options.frames;
  return description;
}

}  // namespace

int run_case(CaseDescription description, const RunOptions& options, const Communicator& comm) {
  description = adjusted(std::move(description), options);
  if (description.dimension == 1) return Run<1>(std::move(description), options, comm)();
  return Run<2>(std::move(description), options, comm)();
}

void check_case_runs(const CaseDescription& description, const Communicator& comm) {
  const auto build = [&]<int Dim>() {
    Scene<Dim> scene = build_scene<Dim>(description);
    Simulation<Dim> simulation(comm, std::move(scene.setup));
    simulation.initialize();
  };
  if (description.dimension == 1)
    build.template operator()<1>();
  else
    build.template operator()<2>();
}

}  // namespace mortise
