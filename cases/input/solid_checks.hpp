// What the keys of elastic solids must satisfy together, and their defaults that depend on other keys.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/input/node.hpp"

namespace mortise {

/// Fills in names, laws, initial states, sides, the reference pressure, the layer; applies [solid] scale.
void complete_solids(const Node& root, CaseDescription& description);

/// Throws InputError for the first thing wrong with the solids of a completed description.
void check_solids(const Node& root, const CaseDescription& description);

}  // namespace mortise
