// Typing errors in the keys of a case file are found before anything is read.
#pragma once

#include <vector>

#include "mortise/cases/input/node.hpp"
#include "mortise/cases/input/section.hpp"

namespace mortise {

/// Throws InputError for the first key of the tree that is not in the list, with the nearest one that is.
void reject_unknown_keys(const Node& root, const std::vector<KeyEntry>& known);

}  // namespace mortise
