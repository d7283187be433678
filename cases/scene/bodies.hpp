// The bodies of a case: shape, body-fitted grid, inertia, prescribed motion and forces.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// Appends body `index` of the description to the set-up, with a grid of cell size `spacing`. Throws InputError.
template <int Dim>
void add_body(const CaseDescription& description, std::size_t index, double spacing, SimulationSetup<Dim>& setup);

}  // namespace mortise
