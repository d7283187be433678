// The coupling schemes for deforming interfaces, by key: from half-time data of both sides to one answer for both.
//
// Per fluid face, with area vector S (current, into the fluid, S = |S| n) over the reference length L of the structure
// it faces, a = |S|/L (a = 1 for loads per reference area), the structure seen through Z⁻¹:
//   1/z_e = a n·Z⁻¹n,   v_e = n·v_s − n·Z⁻¹t_s,    P(v) − p_e + z_e (v − v_e) = 0    (the projection)
//   t_I = −(P − p_e) n a,   v_I = v_s + Z⁻¹(t_I − t_s).
// P(v): the fluid's wall law. Linear: P = p_f + z_f (v − v_f·n).
#pragma once

#include "mortise/coupler/interface.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {

/// Solution at the interface over one step. load = pressure and wall_velocity = velocity where the scheme has one
/// answer for both sides; traditional has two velocities, anti-traditional two pressures.
struct InterfaceSolution {
  std::vector<double> pressure;         // p̃ per fluid face: what the fluid's flux gets
  std::vector<double> load;             // p̃ per fluid face: what the structure carries, makes `traction`
  std::vector<Point<2>> traction;       // t_I per structure face, outward reference normal, per reference area
  std::vector<Point<2>> velocity;       // v_I per structure face: what the structure's flux gets
  std::vector<Point<2>> wall_velocity;  // per structure face: what the interface's nodes, the fluid's wall, move with
  int iterations = 0;
};

struct InterfaceOptions {
  bool nonlinear = true;        // the fluid's full wall law; false: acoustic
  bool reference_load = false;  // (p − p_e) acts per reference area instead of per current area
  bool lagged = false;  // traditional, anti-traditional: data of the last step; false: extrapolated to second order
  double reference_pressure = 0;  // p̃_e, at which the stress-free structure is in equilibrium (shifted like p̃)
  double tolerance = 1e-12;       // sub-iterations: change of the velocity over the fastest wave
  int most_iterations = 200;      // sub-iterations
};

struct InterfaceProblem {
  std::span<const StructureTrace> structure;  // at t + ½Δt
  std::span<const FluidTrace> fluid;          // at t + ½Δt
  std::span<const Point<2>> area;             // S per fluid face, into the fluid
  std::span<const double> reference_length;   // per structure face
  const Transfer* transfer = nullptr;
  const WallLaw* law = nullptr;
};

/// What a scheme remembers of the last two steps, the last one first; empty before the first step. Lagged data are
/// those of [0], extrapolated ones 2 [0] − [1] ([0] while there is one only).
struct InterfaceHistory {
  std::vector<std::vector<Point<2>>> wall_velocity;  // InterfaceSolution::velocity, the structure's own v_I
  std::vector<std::vector<double>> pressure;         // InterfaceSolution::load

  void remember(const InterfaceSolution& solution);  // after a step has been accepted
};

using InterfaceScheme = InterfaceSolution (*)(const InterfaceProblem&, const InterfaceHistory&,
                                              const InterfaceOptions&);

/// projection, traditional, traditional-subiterated, anti-traditional.
/// All throw NumericalError, naming the fluid face, when its gas is inadmissible or no solution exists;
/// traditional-subiterated also when it does not converge, anti-traditional when a structure does not yield.
const Registry<InterfaceScheme>& interface_schemes();

/// t_I per structure face from the pressures of the fluid faces: −Σ_pieces (p − p_e) S of_fluid / L (or with the
/// direction of S only, if reference_load). The force on all structure faces is that of all fluid faces to round-off.
std::vector<Point<2>> tractions(const InterfaceProblem& problem, std::span<const double> pressure,
                                const InterfaceOptions& options);

}  // namespace mortise
