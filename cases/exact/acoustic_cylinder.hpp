// A plane acoustic step wave of pressure P hits a free rigid cylinder of radius a in a fluid (ρ, c) at rest.
// Only the cos θ part of the pressure moves the cylinder. With length a, time a/c (t = 0 at first touch), s the
// variable of the Laplace transform and μ = (mass of the cylinder)/(mass of the fluid it displaces), the incident wave
// e^{−s(1+x)}/s contributes −2 e^{−s}/s I_1(sr) cos θ, the scattered one A K_1(sr) cos θ. Radial momentum at r = 1,
// s V = −∂p_1/∂r, and the body's, π μ s V = −π p_1, eliminate A; the Wronskian I_1 K_1' − I_1' K_1 = −1/s leaves
//   V(s) = 2 e^{−s} / (s² [(1 + μ) K_1(s) + μ s K_0(s)]),   in units of P/(ρc).
// V → 2/(1 + μ) for t → ∞: the cylinder in a uniform stream with its added mass.
#pragma once

namespace mortise {

/// Velocity of the cylinder × ρc/P at the time ct/a after first touch; density_ratio = μ ≥ 0. 0 for ct/a ≤ 0.
/// Absolute accuracy better than 1e-7.
double acoustic_cylinder_velocity(double ct_over_a, double density_ratio);

/// Its displacement × ρc²/(P a).
double acoustic_cylinder_displacement(double ct_over_a, double density_ratio);

}  // namespace mortise
