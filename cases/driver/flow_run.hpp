// Running a case with an incompressible fluid.
#pragma once

#include "mortise/cases/driver/run_case.hpp"

namespace mortise {

/// As run_case(), for descriptions with fluid.kind = "incompressible". Writes summary.json, frames and fields, and
/// solids.csv (t, solid, x, y, velocity_x, velocity_y, angular_momentum, volume: of the whole solid) and tracers.csv
/// (t, probe, x, y: material points and points that move with the fluid).
int run_flow_case(const CaseDescription& description, const RunOptions& options, const Communicator& comm);

/// As check_case_runs().
void check_flow_case_runs(const CaseDescription& description, const Communicator& comm);

}  // namespace mortise
