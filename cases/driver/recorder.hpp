// What a run writes while it goes: histories, fields, pictures, checkpoints. Only rank 0 touches files.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mortise/cases/driver/gather.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/grids/output/csv.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {

template <int Dim>
class Recorder {
 public:
  /// resume_time: keep what an earlier run wrote up to then.
  Recorder(const CaseDescription& description, std::string directory, const Communicator& comm, std::optional<double> resume_time);

  /// A row per body and probe. Collective.
  void histories(const Simulation<Dim>& simulation);
  /// Fields and pictures of this instant. Collective.
  void frame(const Simulation<Dim>& simulation, int number);
  /// Collective.
  void checkpoint(Simulation<Dim>& simulation, int next_frame);
  const std::string& last_picture() const { return last_picture_; }

 private:
  const CaseDescription& description_;
  std::string directory_;
  Communicator comm_;
  std::optional<SeriesWriter> series_;
  std::optional<CsvWriter> bodies_, probes_;
  std::optional<double> schlieren_scale_;
  std::string last_picture_;
};

/// Brings the simulation to the last checkpoint in `directory`; returns the number of the next frame. Throws EnvironmentError.
template <int Dim>
int read_checkpoint(const std::string& directory, Simulation<Dim>& simulation);

}  // namespace mortise
