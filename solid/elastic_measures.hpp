// What is read off the state of an elastic solid at a point (plane strain, ε_zz = 0, F_zz = 1):
//
//   linear        σ is part of the state, tr ε = tr σ/2(λ + μ),  J ≈ 1 + tr ε,  σ_zz = λ tr ε,  W = ½ σ : ε
//   hyperelastic  σ = P Fᵀ/J;  saint_venant_kirchhoff: σ_zz = λ tr E/J,  W = ½ λ (tr E)² + μ E : E
//                              neo_hookean:            σ_zz = λ ln J/J,  W = ½ μ (F : F − 2 − 2 ln J) + ½ λ (ln J)²
#pragma once

#include "mortise/solid/elastic_solver.hpp"

namespace mortise {

/// Cauchy stress σ, non-dimensional.
struct CauchyStress {
  double xx = 0, xy = 0, yy = 0, zz = 0;

  /// √(3/2 s : s) with the deviator s of σ.
  double von_mises() const;
};

/// The state in a cell of a tile.
inline ElasticState state_in(const TileBlock& block, StressLaw law, std::size_t cell) {
  ElasticState state{};
  for (int c = 0; c < elastic_components(law); ++c) state[static_cast<std::size_t>(c)] = block.component(c)[cell];
  return state;
}

/// v and u of a state, in the order of components of elastic_step.hpp.
inline Point<2> velocity_of(const ElasticState& state) { return {state[0], state[1]}; }
inline Point<2> displacement_of(const Material& material, const ElasticState& state) {
  const auto u = static_cast<std::size_t>(displacement_component(material.law));
  return {state[u], state[u + 1]};
}
/// F of a hyperelastic state.
inline Gradient deformation_gradient_of(const ElasticState& state) {
  return (Gradient() << state[2], state[3], state[4], state[5]).finished();
}

/// J: volume over reference volume.
double jacobian_of(const Material& material, const ElasticState& state);
CauchyStress cauchy_stress_of(const Material& material, const ElasticState& state);
/// What the law is written in: σ (linear) or P.
Gradient stress_of(const Material& material, const ElasticState& state);
/// W, per reference volume.
double strain_energy_of(const Material& material, const ElasticState& state);

}  // namespace mortise
