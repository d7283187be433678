// What a run amounts to: summary.json and the closing line.
#pragma once

#include <string>
#include <vector>

#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/driver/time_norms.hpp"
#include "mortise/cases/driver/totals.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/cases/summary/summary.hpp"

namespace mortise {

/// A solid that lives on the cells of a fluid. Collective.
SolidSummary summary_of(const MappedSolid& solid);

template <int Dim>
class RunReport {
 public:
  /// Takes the totals at the start of the run. Collective.
  RunReport(const CaseDescription& description, const Scene<Dim>& scene, Simulation<Dim>& simulation,
            const Communicator& comm);

  /// At the start and after every step: follows the error of the motion of bodies and interfaces. Collective.
  void track();
  /// What was summed up since the beginning of the run, for checkpoints; the same for any number of ranks.
  std::vector<double> totals_so_far() const;
  /// Goes on from there.
  void resume(const std::vector<double>& totals);
  /// status: "unstable" (the computation) or "failed" (its surroundings).
  void failed(const std::string& status, const std::string& reason);
  bool finished() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }
  /// Gathers and writes the summary. Throws AgreedFailure. Collective; rank 0 writes.
  void write(const std::string& path, double wall_seconds);
  /// One line: steps, time, speed, errors.
  std::string headline() const { return headline_; }

 private:
  RunSummary collect(double wall_seconds);
  void add_grids(RunSummary& summary) const;
  void add_bodies(RunSummary& summary) const;
  void add_solids(RunSummary& summary) const;
  void add_errors(RunSummary& summary) const;
  void add_conservation(RunSummary& summary) const;
  void write_headline(const RunSummary& summary);
  void track_bodies(double dt);

  const CaseDescription& description_;
  const Scene<Dim>& scene_;
  Simulation<Dim>& simulation_;
  Communicator comm_;
  std::string status_ = "finished", reason_, headline_;
  Closure closure_;
  SceneTotals<Dim> initial_totals_;
  TimeNorms interface_velocity_, interface_position_, interface_pressure_;
  double last_time_ = 0;
  std::int64_t tight_ = 0;                                          // summed over the steps
  std::int64_t earlier_contacts_ = 0, earlier_repeated_steps_ = 0, earlier_first_order_steps_ = 0;  // before the restart
};

}  // namespace mortise
