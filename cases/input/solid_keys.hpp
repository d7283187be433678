// The keys of elastic solids, their interfaces, and of outlines, which rigid bodies have too.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/input/section.hpp"

namespace mortise {

/// The variables of formulas that describe t = 0.
inline const std::vector<std::string> place_only = {"x", "y"};

/// The sides a solid may have, by key.
std::vector<std::pair<const char*, SideDescription*>> side_keys(SolidDescription& solid);

/// Keys of the outlines that rigid and elastic bodies share, `shape` itself excepted.
void visit_outline(Section& s, ShapeDescription& shape);
/// Keys of [grid] that belong to layers.
void visit_layer(Section& s, CaseDescription& description);
/// One of [[solids]].
void visit_solid(Section& s, SolidDescription& solid);
/// [solid] and [coupling].
void visit_solid_options(Section& s, SolidOptionsDescription& options);
void visit_coupling(Section& s, CouplingDescription& coupling);

}  // namespace mortise
