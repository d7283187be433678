// Linear elasticity of motions that do not depend on the angle, u = (u_r, u_θ)(R, t) in the polar basis of the
// reference position, M = λ + 2μ:
//   ρ v_r' = ∂R σ_rr + (σ_rr − σ_θθ)/R,  ρ v_θ' = ∂R σ_rθ + 2 σ_rθ/R,
//   σ_rr' = M ∂R v_r + λ v_r/R,  σ_θθ' = λ ∂R v_r + M v_r/R,  σ_rθ' = μ (∂R v_θ − v_θ/R),  u' = v,
// by MUSCL-Hancock without a limiter on equal cells; second order in space and time up to both ends.
#pragma once

#include <functional>
#include <vector>

#include "mortise/solid/material.hpp"

namespace mortise {

/// In the polar basis of the reference position.
struct RadialElastic {
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // v_r, v_θ
  Eigen::Vector2d stress = Eigen::Vector2d::Zero();    // σ_rr, σ_rθ
  double hoop = 0;                                     // σ_θθ
};

class RadialSolid {
 public:
  /// Turning at the rate ω as one, between the radii `near` (of the interface) and `far`, either way round; far = 0 is
  /// the axis. far_stress: σ_rr(t) there; empty: held.
  RadialSolid(const Material& material, double near, double far, int cells, double omega,
              std::function<double(double)> far_stress);

  /// Slopes at t and cell states at t + dt.
  void predict(double dt);
  /// The predicted state at the interface.
  RadialElastic trace() const;
  /// Advances from t to t + dt with the velocity and stress at the interface. After predict(½dt).
  void advance(double t, double dt, const RadialElastic& interface);

  const std::vector<RadialElastic>& cells() const { return state_; }  // from `near` to `far`
  const std::vector<Eigen::Vector2d>& displacement() const { return displacement_; }
  const Eigen::Vector2d& impedance() const { return impedance_; }  // ρ c_p, ρ c_s

 private:
  double spacing() const { return (far_ - near_) / static_cast<double>(state_.size()); }  // signed
  double radius(double cell) const { return near_ + cell * spacing(); }
  RadialElastic mirrored(const RadialElastic& W) const;
  RadialElastic between(const RadialElastic& before, const RadialElastic& after) const;
  RadialElastic far_face(double t) const;

  Material material_;
  double near_, far_;
  std::function<double(double)> far_stress_;
  Eigen::Vector2d impedance_, modulus_;  // of v_r and v_θ: (M, μ)
  std::vector<RadialElastic> state_, slope_, half_;
  std::vector<Eigen::Vector2d> displacement_;
};

}  // namespace mortise
