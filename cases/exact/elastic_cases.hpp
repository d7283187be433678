// The exact solutions of elastic solids as case files ask for them: from the keys of a case to the problem that is
// solved.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Of a solid whose description is complete.
Material material_of(const SolidDescription& solid);

/// Keys and makers: elastic_piston, elastic_bar, elastic_piston_shock, superseismic_shock, deforming_diffuser, radial_reference,
/// plane_waves, annulus_modes, rayleigh_wave. The description has been checked.
using ElasticMaker = std::function<std::unique_ptr<ExactSolution<2>>(const CaseDescription&)>;
std::vector<std::pair<std::string, ElasticMaker>> elastic_solutions();

}  // namespace mortise
