// One step of a rigid body of any mass, zero included, in a compressible fluid.
//
//   M ẏ = F(t, y) + F_ext(t),  F = −Σ (P_e(e·y − u_e) − p∞) e L_e,  e = (n, r × n),  A = −∂F/∂y = Σ P' e eᵀ L
//
// over the wall faces; P(d) is the pressure on a wall that moves with d = e·y − u·n relative to the fluid and P' its
// slope (the impedance z when acoustic: A is then the added-mass tensor). Two-stage singly diagonally implicit
// Runge-Kutta method, order 2, L-stable, g = 1 − 1/√2:
//   M (y1 − y0) = g Δt F(g; y1),  M (y2 − y0) = Δt (1 − g) K + g Δt F(1; y2),  K = M (y1 − y0)/(g Δt),  y^{n+1} = y2,
// each stage by Newton's method with J = M + g Δt A. A massless row reads F = 0 at both stages, and K = 0. The grid
// moves with ȳ = (1 − g) y1 + g y2 and the fluid gets the mean pressure p̄ = (1 − g) p1 + g p2, hence
//   M (y^{n+1} − y^n) = Δt (−Σ (p̄ − p∞) e L + mean F_ext)   to round-off.
// Sources: Alexander, SIAM J. Numer. Anal. 14 (1977) 1006 (the method); Banks, Henshaw, Sjögreen, J. Comput. Phys.
// 245 (2013) 399 (added mass). The faces are frozen at t + Δt/2 within a step: ȳ, p̄ and, with mass, y^{n+1} keep order
// 2; y^{n+1} of a massless body that turns is late by the angle ω Δt/2, which is not carried on to the next step.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mortise/coupler/body_vector.hpp"
#include "mortise/coupler/wall_law.hpp"

namespace mortise {

/// One wall face of a body: geometry at t + Δt/2, fluid next to it at t and t + Δt/2. Pressures are shifted ones
/// (p̃ = p + p∞ > 0), densities > 0; normal velocities are those of the fluid, along `normal`.
template <int Dim>
struct WallFace {
  Point<Dim> normal = Point<Dim>::Zero();                                // unit, from the solid into the fluid
  Point<Dim> arm = Point<Dim>::Zero();                                   // face centre − centre of mass
  double measure = 1;                                                    // length L of the face; 1 on a line
  double density0 = 0, normal_velocity0 = 0, pressure0 = 0;              // at t
  double density_half = 0, normal_velocity_half = 0, pressure_half = 0;  // at t + Δt/2
};

/// g of the method: the stages are at t + g Δt and t + Δt.
inline constexpr double sdirk2_gamma = 0.29289321881345247560;

/// What a body brings to a step.
template <int Dim>
struct BodyStep {
  std::string name;                                    // for messages
  BodyVector<Dim> mass = BodyVector<Dim>::Zero();      // diagonal of M, ≥ 0
  BodyVector<Dim> velocity = BodyVector<Dim>::Zero();  // y^n; of a held degree of freedom: its mean over the step
  std::array<bool, Dim + rotations<Dim>> held{};       // degrees of freedom that are left as they are
  double length = 1;                                   // mean radius ℓ > 0
  double dt = 0;                                       // Δt > 0
  double p_inf = 0;                                    // p∞: forces use p̃ − p∞
  std::array<BodyVector<Dim>, 2> external{BodyVector<Dim>::Zero(),
                                          BodyVector<Dim>::Zero()};  // force and torque at t + g Δt and t + Δt
};

/// What a body takes from a step.
template <int Dim>
struct BodyMotion {
  BodyVector<Dim> velocity;      // y^{n+1}
  BodyVector<Dim> mean;          // ȳ: the grid moves with it
  std::vector<double> pressure;  // p̄ per face (p̃): the pressure of the fluid's flux through the wall
  BodyVector<Dim> force;         // −Σ (p̄ − p∞) e L: force and torque of the fluid
  BodyMatrix<Dim> added_mass;    // A at the end of the step; symmetric, positive semidefinite
  BodyMatrix<Dim> response;      // Δy^{n+1} per impulse spread over the step, linearised; symmetric; held rows 0
  int iterations = 0;            // Newton iterations, both stages
};

/// One step by the method above. Modes without mass and added mass (a massless circle that spins) keep their velocity.
/// Throws NumericalError when Newton's method fails: a massless body pulled out of the gas, or non-finite data.
template <int Dim>
BodyMotion<Dim> advance_added_mass(const BodyStep<Dim>& step, std::span<const WallFace<Dim>> faces, const WallLaw& law);

/// The foil: explicit (lagged) coupling. The fluid sees the wall move with y^n and answers with the pressure of its
/// data at t + Δt/2; then M (y^{n+1} − y^n) = Δt (F + mean F_ext). The grid moves with the velocity the fluid saw, ȳ =
/// y^n. A mode is amplified by ζ = 1 − z Δt/m: unstable iff m < z Δt/2, z the sum of the impedances of all sides.
/// Throws InputError unless traditional_possible().
template <int Dim>
BodyMotion<Dim> advance_traditional(const BodyStep<Dim>& step, std::span<const WallFace<Dim>> faces,
                                    const WallLaw& law);

/// Every degree of freedom has mass or is held.
template <int Dim>
bool traditional_possible(const BodyStep<Dim>& step);

/// Σ z e eᵀ L, z per face: the blocks A11 (v, v), A12, A21, A22 (ω, ω). `impedance` is as long as `faces`.
template <int Dim>
BodyMatrix<Dim> added_mass_tensor(std::span<const WallFace<Dim>> faces, std::span<const double> impedance);

/// Δy^{n+1} per impulse spread over the step for the added-mass tensor A: (1 − g) J⁺ M J⁺ + g J⁺, J = M + g Δt A.
/// M⁻¹ for heavy bodies, A⁻¹/Δt for massless ones. Rows of held degrees are zero.
template <int Dim>
BodyMatrix<Dim> impulse_response(const BodyStep<Dim>& step, const BodyMatrix<Dim>& added_mass);

}  // namespace mortise
