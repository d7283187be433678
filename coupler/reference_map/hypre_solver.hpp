// The pressure solver "hypre", see pressure_solver_keys().
#pragma once

#include <memory>

#include "mortise/coupler/reference_map/pressure_solver.hpp"

namespace mortise {

/// Collective.
std::unique_ptr<PressureSolver> make_hypre_solver(const PressureProblem& problem);

}  // namespace mortise
