// All grids of a scene at one instant, gathered from the ranks.
#pragma once

#include "mortise/coupler/simulation.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// The fluid's grids with density, velocity, pressure and Mach number, then the solids' (solid_snapshot.hpp); complete
/// on every rank. `contours`: of reference maps, too. Collective.
template <int Dim>
Snapshot gather_snapshot(const Simulation<Dim>& simulation, bool contours = false);

}  // namespace mortise
