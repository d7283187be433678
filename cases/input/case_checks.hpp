// What the keys of a case file must satisfy together, as far as it can be known before any geometry is built.
#pragma once

#include <array>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/input/node.hpp"

namespace mortise {

/// The gas (ρ, u, v, p) behind a shock that runs with Mach number `mach` > 1 along the unit vector n into the gas
/// `ahead`, by the Rankine-Hugoniot relations of an ideal or stiffened gas.
std::array<double, 4> gas_behind_shock(const std::array<double, 4>& ahead, double mach, const std::array<double, 2>& n,
                                       double gamma, double p_inf);

/// Fills in the defaults that depend on other keys: names, scheme, the gas behind a shock, the inflow, paths.
void complete_case(const Node& root, CaseDescription& description);

/// Throw InputError for the first thing wrong with a completed description; `root` knows the places.
void check_case(const Node& root, const CaseDescription& description);
void check_body(const Node& root, const CaseDescription& description, std::size_t index);

}  // namespace mortise
