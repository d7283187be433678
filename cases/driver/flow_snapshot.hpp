// An incompressible flow and its solids at one instant, gathered from the ranks.
#pragma once

#include "mortise/cases/driver/mapped_bodies.hpp"

namespace mortise {

/// Velocity, vorticity and pressure on the cells, then the solids (add_mapped_solid), complete on every rank; `step`:
/// its number. Collective.
Snapshot gather_flow_snapshot(const IncompressibleSolver& flow, const std::vector<MappedSolid>& solids, bool contours,
                              std::int64_t step);

}  // namespace mortise
