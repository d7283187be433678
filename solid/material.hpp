// Stress laws of elastic solids in the plane (plane strain), in the reference frame. ρ0 is the reference density.
//
//   linear                 σ = λ tr ε I + 2μ ε,  ε = ½(∇u + ∇uᵀ)                      system (v, σ), does not rotate
//   saint_venant_kirchhoff P = F S,  S = λ tr E I + 2μ E,  E = ½(FᵀF − I)              system (v, F)
//   neo_hookean            P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ,  J = det F                   system (v, F)
//
// P is the first Piola-Kirchhoff stress; P N is the traction on a face with reference normal N per reference area.
#pragma once

#include <string>

#include "mortise/grids/core/registry.hpp"
#include "mortise/grids/core/types.hpp"

namespace mortise {

enum class StressLaw { linear, saint_venant_kirchhoff, neo_hookean };

/// Keys: linear, saint_venant_kirchhoff, neo_hookean.
const Registry<StressLaw>& stress_laws();

/// Non-dimensional. density > 0, mu > 0, lambda + mu > 0.
struct Material {
  StressLaw law = StressLaw::linear;
  double density = 1;  // ρ0
  double lambda = 1, mu = 1;

  double pressure_wave_speed() const;  // c_p = √((λ + 2μ)/ρ0), of the stress-free state
  double shear_wave_speed() const;     // c_s = √(μ/ρ0)
  /// Throws InputError naming the number that is wrong.
  void check() const;
};

/// F (rows: space, columns: reference).
using Gradient = Eigen::Matrix2d;

/// First Piola-Kirchhoff stress P(F) of a hyperelastic law; for StressLaw::linear F = I + ∇u and the answer is σ.
Gradient stress(const Material& material, const Gradient& F);
/// Γ(F, N) = ∂(P N)/∂F · N, symmetric positive definite where the law is strongly elliptic.
Eigen::Matrix2d acoustic_tensor(const Material& material, const Gradient& F, const Point<2>& N);
/// Z = √(ρ0 Γ).
Eigen::Matrix2d impedance(const Material& material, const Gradient& F, const Point<2>& N);

}  // namespace mortise
