// The elastic solids of a case: grids on both sides of their interfaces, material, sides, state at t = 0.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/scene/scene.hpp"

namespace mortise {

/// Appends solid `index` of the description to the set-up, and its interface to the gas's bodies; an outline with gas
/// around it also to `shapes`. Cells of size `spacing`. Throws InputError.
void add_solid(const CaseDescription& description, std::size_t index, double spacing,
               const std::shared_ptr<const ExactSolution<2>>& exact, SimulationSetup<2>& setup,
               std::vector<PlacedShape<2>>& shapes);

/// Scenes without a background: the box around all grids, for output.
Box<2> bounds_of(const SimulationSetup<2>& setup);

}  // namespace mortise
