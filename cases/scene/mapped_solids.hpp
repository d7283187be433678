// The elastic solids of a case whose scheme is the reference map: outlines, materials, state at t = 0, no grids.
#pragma once

#include "mortise/cases/scene/scene.hpp"

namespace mortise {

/// Appends solid `index` of the description to setup.reference_map, which is made if there is none, and its outline to
/// `shapes`. `spacing`: of the background. Throws InputError.
void add_mapped_solid(const CaseDescription& description, std::size_t index, double spacing,
                      const std::shared_ptr<const ExactSolution<2>>& exact, SimulationSetup<2>& setup,
                      std::vector<PlacedShape<2>>& shapes);

}  // namespace mortise
