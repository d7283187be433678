// The elastic solids of a case whose scheme is the reference map: outlines, materials, state at t = 0, no grids.
#pragma once

#include "mortise/cases/scene/scene.hpp"
#include "mortise/cases/scene/solid_state.hpp"

namespace mortise {

/// The material point X with X + u(X, 0) = x, by Newton's method; NaN where it does not converge.
Point<2> reference_point(const SolidFunction& initial, const Point<2>& x);

/// Of the undeformed solid where it is. Throws InputError for outlines that cannot be, and for solids thinner than
/// their blur zone.
std::shared_ptr<const LevelSet> level_set_of(const CaseDescription& description, const SolidDescription& from,
                                             double spacing);

/// Throws InputError for a solid, or a case, that the reference map does not take.
void refuse_what_cannot_be_mapped(const CaseDescription& description, const SolidDescription& from);

/// Appends solid `index` of the description to setup.reference_map, which is made if there is none, and its outline to
/// `shapes`. `spacing`: of the background. Throws InputError.
void add_mapped_solid(const CaseDescription& description, std::size_t index, double spacing,
                      const std::shared_ptr<const ExactSolution<2>>& exact, SimulationSetup<2>& setup,
                      std::vector<PlacedShape<2>>& shapes);

}  // namespace mortise
