// What a scene contains: mass, momentum and energy of the fluid, of rigid bodies and of elastic solids, the same for
// any number of ranks. Overlapping cells are shared out smoothly.
#pragma once

#include <vector>

#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// ∫ρ, ∫ρu, ∫E over the fluid (E with p̃). Collective.
template <int Dim>
std::array<double, static_cast<std::size_t>(euler_components<Dim>)> totals(const Simulation<Dim>& simulation);

/// One elastic solid. Non-dimensional.
struct SolidTotals {
  double mass = 0;
  Point<2> center = Point<2>::Zero();  // of mass, at present
  Point<2> momentum = Point<2>::Zero();
  double angular_momentum = 0;  // about the centre of mass
  double kinetic_energy = 0, strain_energy = 0;
  double max_von_mises = 0;  // over active cells
};
/// From the sums of m, m x (2), m v (2), m x × v, kinetic and strain energy.
SolidTotals totals_of(const std::array<double, 8>& sum, double max_von_mises);
/// Collective.
SolidTotals totals(const ElasticSolver& solid);

/// A scene as a whole. A structure is in equilibrium at the pressure p̃_e, so that E − p̃_e V is what its motion
/// conserves, V being its volume up to a constant.
template <int Dim>
struct SceneTotals {
  double mass = 0;  // of fluid and elastic solids
  Point<Dim> momentum = Point<Dim>::Zero();
  double energy = 0;
  double reference_work = 0;  // Σ p̃_e V over the interfaces

  static constexpr std::size_t size = Dim + 3;
  std::vector<double> state() const;
  void resume(const double* state);
};
/// Collective.
template <int Dim>
SceneTotals<Dim> scene_totals(const Simulation<Dim>& simulation);

/// What cannot leave or enter a scene through its boundaries.
struct Closure {
  bool energy = false;  // and mass
  bool momentum = false;
};
template <int Dim>
Closure closure(const Simulation<Dim>& simulation);

}  // namespace mortise
