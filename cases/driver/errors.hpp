// Norms of the difference from an exact solution at the present time, the same for any number of ranks.
#pragma once

#include <map>
#include <string>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/summary/summary.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// Over the active cells of the fluid: "fluid.density", "fluid.velocity_x", …, "fluid.pressure", "fluid.temperature"
/// (T = p/ρ). Collective.
template <int Dim>
std::map<std::string, ErrorNorms> fluid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact);

/// Over the active cells of all solids, weighted by reference area: "solid.displacement", "solid.velocity",
/// "solid.stress" (length of the difference; σ of the linear law, otherwise P) and their components
/// "solid.displacement_x", …, "solid.stress_xx", "solid.stress_xy", "solid.stress_yx", "solid.stress_yy". Collective.
template <int Dim>
std::map<std::string, ErrorNorms> solid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact);

/// What the interfaces of the solids deviate by at their nodes and, for the pressure, at the fluid's faces. Velocity
/// and pressure are those of the middle of the last step and compared with the exact ones of that time; none before the
/// first step.
struct InterfaceDeviations {
  std::vector<double> position, velocity, pressure;
};
template <int Dim>
InterfaceDeviations interface_deviations(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact);

}  // namespace mortise
