// `--set key=value`: changes of a case file from the command line.
#pragma once

#include <string>

#include "mortise/cases/input/node.hpp"

namespace mortise {

/// Applies "key=value" to the tree of a case file. The key is dotted, array entries by index from 0
/// ("bodies.2.position.0=0.5"); tables that are not there yet are made, array entries are not. The value is a TOML
/// value, or a bare word for a string. Throws InputError with "--set key=value" as the place.
void apply_override(Node& root, const std::string& argument);

}  // namespace mortise
