// From what a case file says to an incompressible flow with solids on its grid.
#pragma once

#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/reference_map/flow_solids.hpp"
#include "mortise/coupler/reference_map/incompressible_setup.hpp"

namespace mortise {

struct FlowScene {
  IncompressibleSetup flow;
  FlowSolidsSetup solids;
};

/// Throws InputError.
FlowScene build_flow_scene(const CaseDescription& description);

}  // namespace mortise
