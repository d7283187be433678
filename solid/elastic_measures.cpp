#include "mortise/solid/elastic_measures.hpp"

#include <Eigen/LU>
#include <cmath>

namespace mortise {
namespace {

/// σ of a state of the linear system.
Gradient linear_stress(const ElasticState& state) {
  return (Gradient() << state[2], state[3], state[3], state[4]).finished();
}

double linear_dilatation(const Material& material, const ElasticState& state) {
  return linear_stress(state).trace() / (2 * (material.lambda + material.mu));
}

/// E = ½(FᵀF − I).
Gradient green_strain(const Gradient& F) { return 0.5 * (F.transpose() * F - Gradient::Identity()); }

}  // namespace

double CauchyStress::von_mises() const {
  return std::sqrt(0.5 * ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) + 3 * xy * xy);
}

double jacobian_of(const Material& material, const ElasticState& state) {
  if (material.law == StressLaw::linear) return 1 + linear_dilatation(material, state);
  return deformation_gradient_of(state).determinant();
}

Gradient stress_of(const Material& material, const ElasticState& state) {
  if (material.law == StressLaw::linear) return linear_stress(state);
  return stress(material, deformation_gradient_of(state));
}

CauchyStress cauchy_stress_of(const Material& material, const ElasticState& state) {
  if (material.law == StressLaw::linear)
    return {state[2], state[3], state[4], material.lambda * linear_dilatation(material, state)};
  const Gradient F = deformation_gradient_of(state);
  const double J = F.determinant();
  const Gradient sigma = stress(material, F) * F.transpose() / J;
  const double volumetric = material.law == StressLaw::neo_hookean ? std::log(J) : green_strain(F).trace();
  return {sigma(0, 0), 0.5 * (sigma(0, 1) + sigma(1, 0)), sigma(1, 1), material.lambda * volumetric / J};
}

double strain_energy_of(const Material& material, const ElasticState& state) {
  const double lambda = material.lambda, mu = material.mu;
  if (material.law == StressLaw::linear) {
    const double dilatation = linear_dilatation(material, state);
    const Gradient sigma = linear_stress(state);
    return 0.25 / mu * (sigma.squaredNorm() - lambda * dilatation * sigma.trace());
  }
  const Gradient F = deformation_gradient_of(state);
  if (material.law == StressLaw::saint_venant_kirchhoff) {
    const Gradient E = green_strain(F);
    return 0.5 * lambda * E.trace() * E.trace() + mu * E.squaredNorm();
  }
  const double log_j = std::log(F.determinant());
  return 0.5 * mu * (F.squaredNorm() - 2 - 2 * log_j) + 0.5 * lambda * log_j * log_j;
}

}  // namespace mortise
