// The words a case file may use where it has a choice.
#pragma once

#include <string>
#include <vector>

namespace mortise::options {

inline const std::vector<std::string> schemes = {
    "none", "rigid", "traditional", "projection", "traditional-subiterated", "anti-traditional", "reference-map"};
inline const std::vector<std::string> body_schemes = {"rigid", "traditional"};
inline const std::vector<std::string> interface_schemes = {"projection", "traditional", "traditional-subiterated",
                                                           "anti-traditional", "reference-map"};
inline const std::vector<std::string> limiters = {"none", "minmod", "mc", "van_albada"};
inline const std::vector<std::string> riemann_solvers = {"hllc", "exact", "hlle"};
inline const std::vector<std::string> boundaries = {"inflow", "outflow", "wall", "slip_wall", "periodic", "exact"};
inline const std::vector<std::string> fluid_kinds = {"gas", "incompressible"};
inline const std::vector<std::string> pressure_solvers = {"automatic", "transform", "multigrid", "hypre"};
inline const std::vector<std::string> initial_kinds = {"uniform", "shock", "riemann", "vortex", "regions", "exact"};
inline const std::vector<std::string> shapes = {"circle",  "ellipse", "stick", "rectangle",
                                                "polygon", "spline",  "slab",  "half_space"};
inline const std::vector<std::string> surfaces = {"wall", "exact"};
inline const std::vector<std::string> sides = {"left", "right"};
inline const std::vector<std::string> degrees_of_freedom = {"x", "y", "angle"};
inline const std::vector<std::string> pictures = {"schlieren", "pressure", "velocity", "mach", "vorticity", "stress", "grids"};
inline const std::vector<std::string> fluid_exact_solutions = {
    "none", "riemann", "vortex", "uniform", "rigid_piston", "shock_on_massless_body", "weak_shock_on_free_cylinder"};
inline const std::vector<std::string> solid_exact_solutions = {
    "elastic_piston",   "elastic_bar", "elastic_piston_shock", "superseismic_shock", "deforming_diffuser",
    "radial_reference", "plane_waves", "annulus_modes",        "rayleigh_wave"};
inline const std::vector<std::string> exact_solutions = [] {
  std::vector<std::string> all = fluid_exact_solutions;
  all.insert(all.end(), solid_exact_solutions.begin(), solid_exact_solutions.end());
  return all;
}();

inline const std::vector<std::string> grid_kinds = {"overlapping", "layer"};
inline const std::vector<std::string> solid_shapes = {"circle", "ellipse", "stick", "rectangle", "polygon",
                                                      "spline", "annulus", "plate", "strip"};
inline const std::vector<std::string> laws = {"linear", "saint_venant_kirchhoff", "neo_hookean"};
inline const std::vector<std::string> gas_places = {"outside", "inside", "none"};
inline const std::vector<std::string> solid_sides = {"free", "fixed", "slip", "periodic", "exact"};
inline const std::vector<std::string> solid_initial_kinds = {"rest", "exact", "plane_wave", "formula"};
inline const std::vector<std::string> waves = {"pressure", "shear"};
inline const std::vector<std::string> solid_limiters = {"none", "minmod", "mc"};
inline const std::vector<std::string> fsrps = {"nonlinear", "linear"};
inline const std::vector<std::string> wall_velocities = {"extrapolated", "lagged"};
inline const std::vector<std::string> loads = {"current", "reference"};

}  // namespace mortise::options
