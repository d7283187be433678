// What an elastic solid is at t = 0 and on its sides, from the case file or the exact solution.
#pragma once

#include <memory>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/elastic_solver.hpp"

namespace mortise {

/// Velocity, displacement, stress and displacement gradient of the material point X at time t.
using SolidFunction = std::function<ExactSolid(const Point<2>& X, double t)>;

/// The solid at t = 0 (rest, formula: whatever t) and, for exact and plane_wave, after. The gradient of formulas is
/// their central difference, exact to about 1e-10.
SolidFunction solid_function(const SolidDescription& solid, const Material& material,
                             const std::shared_ptr<const ExactSolution<2>>& exact);

/// Components of the solver's field: (v, σ, u) for the linear law, (v, F, u) otherwise.
ElasticState elastic_state(StressLaw law, const ExactSolid& solid);

/// A side as the solver sees it; a prescribed normal traction acts along the reference normal.
ElasticSide elastic_side(const SideDescription& side);

}  // namespace mortise
