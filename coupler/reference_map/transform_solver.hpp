// The pressure solver "transform", see pressure_solver_keys().
#pragma once

#include <memory>

#include "mortise/coupler/reference_map/pressure_solver.hpp"

namespace mortise {

/// Collective.
std::unique_ptr<PressureSolver> make_transform_solver(const PressureProblem& problem);

}  // namespace mortise
