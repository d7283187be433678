// The words a case file may use where it has a choice.
#pragma once

#include <string>
#include <vector>

namespace mortise::options {

inline const std::vector<std::string> schemes = {"none", "rigid", "traditional"};
inline const std::vector<std::string> limiters = {"none", "minmod", "mc", "van_albada"};
inline const std::vector<std::string> riemann_solvers = {"hllc", "exact", "hlle"};
inline const std::vector<std::string> boundaries = {"inflow", "outflow", "wall", "periodic", "exact"};
inline const std::vector<std::string> initial_kinds = {"uniform", "shock", "riemann", "vortex", "regions"};
inline const std::vector<std::string> shapes = {"circle",  "ellipse", "stick", "rectangle",
                                                "polygon", "spline",  "slab",  "half_space"};
inline const std::vector<std::string> surfaces = {"wall", "exact"};
inline const std::vector<std::string> sides = {"left", "right"};
inline const std::vector<std::string> degrees_of_freedom = {"x", "y", "angle"};
inline const std::vector<std::string> pictures = {"schlieren", "pressure", "velocity", "mach", "grids"};
inline const std::vector<std::string> exact_solutions = {
    "none", "riemann", "vortex", "uniform", "rigid_piston", "shock_on_massless_body", "weak_shock_on_free_cylinder"};

}  // namespace mortise::options
