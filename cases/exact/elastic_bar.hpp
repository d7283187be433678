// A bar of linear material fixed at its back ξ = −L, set in motion by an initial velocity v0(ξ), its front against a
// gas at rest with the pressure p_e (elastic_piston.hpp). The wave that reaches the front is initial data or left the
// front 2L/c earlier and came back from the fixed end with its slope unchanged,
//   f'(ξ) = −v0(ξ)/2c for −L ≤ ξ ≤ 0,  f'(ξ) = g'(−2L − ξ) for ξ < −L,  g'(ξ) = v0(ξ)/2c for ξ ≤ 0,
// and the interface velocity w(t) is the root of p_e − P(w) = ρc w + 2M f'(−ct), P the simple-wave relation of the gas.
#pragma once

#include "mortise/cases/exact/elastic_piston.hpp"

namespace mortise {

/// The problem with the interface velocity and initial state of that bar; v0 is defined on −length ≤ ξ ≤ 0 and vanishes
/// at both ends.
ElasticPistonProblem fixed_bar(ElasticPistonProblem problem, std::function<double(double)> initial_velocity);

}  // namespace mortise
