// Keys that belong to one choice among several (the radius to a circle, the Mach number to a shock), and keys that say
// the same thing in two ways (density, or mass and inertia).
#pragma once

#include "mortise/cases/input/node.hpp"

namespace mortise {

/// What `--set` chooses makes void what the file chose: a density set on the command line removes mass and inertia that
/// the file gives, a shape removes the keys of the file's shape, a prescribed motion the force along it.
void drop_superseded(Node& root);

/// Throws InputError for a key that does not belong to the shape or initial kind chosen, for one that is missing for
/// it, and for two keys that say the same thing.
void check_alternatives(const Node& root);

}  // namespace mortise
