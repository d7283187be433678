// Running a case: the time loop and everything that is written on the way.
#pragma once

#include <optional>
#include <string>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/grids/core/parallel.hpp"

namespace mortise {

struct RunOptions {
  std::string output;            // directory; empty: the case's own
  std::optional<double> until;   // end before time.end
  std::optional<int> frames;     // instead of output.frames
  std::string restart;           // directory of a run to continue from its last checkpoint
  bool no_skip = false;
  bool quiet = false;
  bool overwrite = false;
};

/// Runs the case to its end; returns the exit status of the program: 0 finished, 3 failed numerically (the summary is written, the last checkpoint
/// kept). Throws InputError before anything is written, EnvironmentError when writing fails.
int run_case(CaseDescription description, const RunOptions& options, const Communicator& comm);

/// Builds everything and cuts the first overlap, writes nothing. Throws InputError.
void check_case_runs(const CaseDescription& description, const Communicator& comm);

}  // namespace mortise
