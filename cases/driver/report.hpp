// What a run amounts to: summary.json and the closing line.
#pragma once

#include <string>

#include "mortise/cases/driver/gather.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/cases/summary/summary.hpp"

namespace mortise {

template <int Dim>
class RunReport {
 public:
  /// Takes the totals at the start of the run. Collective.
  RunReport(const CaseDescription& description, const Scene<Dim>& scene, Simulation<Dim>& simulation, const Communicator& comm);

  /// After every step: follows the error of the bodies' motion.
  void track();
  void failed(const std::string& reason);
  bool finished() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }
  /// Gathers and writes the summary. Collective; rank 0 writes.
  void write(const std::string& path, double wall_seconds);
  /// One line: steps, time, speed, errors.
  std::string headline() const { return headline_; }

 private:
  RunSummary collect(double wall_seconds);

  const CaseDescription& description_;
  const Scene<Dim>& scene_;
  Simulation<Dim>& simulation_;
  Communicator comm_;
  std::string reason_, headline_;
  std::array<double, static_cast<std::size_t>(euler_components<Dim>)> initial_totals_;
  ErrorNorms interface_velocity_, interface_position_;  // max over time; l1, l2 as means over time while summing
  double tracked_time_ = 0, last_time_ = 0;
  std::int64_t tight_ = 0;  // summed over the steps
};

}  // namespace mortise
