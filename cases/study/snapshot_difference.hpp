// The difference of two solutions on different grids, for self-convergence.
#pragma once

#include <map>
#include <string>

#include "mortise/cases/summary/summary.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// Norms of coarse − fine over the active cells of `coarse`: fluid.density, fluid.velocity_x, fluid.velocity_y,
/// fluid.pressure, fluid.temperature (T = p/ρ) where they are now; solid.displacement, solid.velocity, solid.stress
/// (length of the difference; Cauchy stress) at the same material points. l1 and l2 are means weighted with present
/// areas.
///
/// The mean over a coarse cell is compared with that of the fine solution, taken at four points of it from a quadratic
/// that takes the value of the nearest fine cell and fits its neighbours, limited to the range of their values: exact
/// to O(h_fine³) in smooth flow, and where coarse cells are blocks of four fine ones the mean of these. Cells the fine
/// solution does not cover, beside bodies that are elsewhere in it, are left out. Throws InputError when the two have
/// no field in common.
std::map<std::string, ErrorNorms> snapshot_difference(const Snapshot& coarse, const Snapshot& fine);

}  // namespace mortise
