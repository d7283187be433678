// The gas and the solids that a run begins with.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// Throws InputError for the first active cell of this rank whose density or p̃ is not positive and finite at t = 0, or
/// whose state in a solid is not finite, as formulas of the case file can make it. The simulation is initialised.
template <int Dim>
void check_initial_state(const CaseDescription& description, const Simulation<Dim>& simulation);

}  // namespace mortise
