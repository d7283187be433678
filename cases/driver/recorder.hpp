// What a run writes while it goes: histories, fields, pictures, checkpoints. Only rank 0 touches files; what fails there
// waits for settle(), so that no rank is left behind in the middle of a collective operation.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>

#include "mortise/cases/driver/histories.hpp"
#include "mortise/cases/driver/tiles.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {

/// Writes the pictures of a case as frames/<field>_NNNN.png; returns the path of the first. Throws EnvironmentError.
std::string write_frame(const Snapshot& snapshot, const CaseDescription& description, const std::string& directory,
                        int number);

/// The state of a run between two steps.
struct Checkpoint {
  TileRecords tiles;
  std::vector<double> motion;  // Simulation::motion_state(); of incompressible flows the time and Tracers::state()
  std::vector<double> totals;  // of the report; of incompressible flows the number of steps
};

/// Replaces the checkpoint in `directory`. Throws EnvironmentError.
void write_checkpoint(const Checkpoint& checkpoint, const std::string& case_text, const std::string& directory);

/// The checkpoint in `directory`, of whatever scene. Throws EnvironmentError when it cannot be read.
Checkpoint read_any_checkpoint(const std::string& directory);

/// Throws the EnvironmentError that says that the checkpoint there does not belong to the scene.
[[noreturn]] void refuse_checkpoint(const std::string& directory);

template <int Dim>
class Recorder {
 public:
  /// resume_time: keep what an earlier run wrote up to then. Collective.
  Recorder(const CaseDescription& description, const Simulation<Dim>& simulation, std::string directory,
           const Communicator& comm, std::optional<double> resume_time);

  /// A row per body, probe and interface. Collective.
  void histories(const Simulation<Dim>& simulation);
  /// Fields and pictures of this instant. Collective.
  void frame(const Simulation<Dim>& simulation, int number);
  /// `totals`: of the report (RunReport::totals_so_far). Collective.
  void checkpoint(Simulation<Dim>& simulation, const std::vector<double>& totals);
  /// Throws AgreedFailure when something could not be written. Collective.
  void settle() const;
  const std::string& last_picture() const { return last_picture_; }

 private:
  void write(const std::function<void()>& files);

  const CaseDescription& description_;
  std::string directory_;
  Communicator comm_;
  std::optional<SeriesWriter> series_;
  Histories<Dim> histories_;
  std::string last_picture_;
  std::exception_ptr failure_;  // the first, on rank 0
};

/// The last checkpoint in `directory`. Throws EnvironmentError when it cannot be read or is not of this scene.
template <int Dim>
Checkpoint read_checkpoint(const std::string& directory, const Simulation<Dim>& simulation);

}  // namespace mortise
