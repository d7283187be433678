// A shock runs along the plane surface Y = 0 of a linear elastic half-space Y ≤ 0 faster than both of its waves. Its
// foot moves with the speed V along x (at the origin at t = 0), the shock front n·x = V n_x t, n = (cos β, −sin β),
// into a gas at rest; behind it the gas is uniform (Rankine-Hugoniot). The solid carries a pressure and a shear wave
// from the foot,
//   u = A k_p (c_p t − k_p·X)₊ + B d_s (c_s t − k_s·X)₊,  k = (c/V, −√(1 − c²/V²)),  d_s = k_s turned by 90°,
// so that the surface behind the foot moves with U = A c_p k_p + B c_s d_s and is a straight line with normal n_w ∝
// (U_y, V − U_x). β, A and B solve, with a = |n_w| before normalisation over V or 1 (load_law.hpp),
//   (v_gas − U)·n_w = 0,   σ (0, 1) = −(p − p_e) a n_w.
// Source: Banks, Henshaw & Schwendeman, J. Comput. Phys. 231 (2012) 3518, section 5.2 (its constants satisfy a = 1).
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/load_law.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// Non-dimensional. The defaults are the published problem.
struct SuperseismicShockProblem {
  double gamma = 1.4, p_inf = 0;
  double density = 0.1114827, pressure = 0.1114827 * 0.09375;  // of the gas ahead, at rest; physical pressure
  double reference_pressure = 0.1114827 * 0.09375;             // p_e
  double foot_speed = 1;                                       // V > c_p
  Material material{StressLaw::linear, 1, 0.1398307, 0.07203351};
  LoadLaw load = LoadLaw::reference_area;
};

class SuperseismicShock : public ExactSolution<2> {
 public:
  /// Throws InputError for V ≤ c_p, NumericalError if the foot has no solution with an attached shock.
  explicit SuperseismicShock(const SuperseismicShockProblem& problem);

  Primitive<2> state(const Point<2>& x, double t) const override;
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;
  std::optional<ExactInterface> interface_at(const Point<2>& X, double t) const override;

  double shock_angle() const { return angle_; }  // β
  double pressure_amplitude() const { return amplitudes_[0]; }
  double shear_amplitude() const { return amplitudes_[1]; }

 private:
  Primitive<2> behind(double angle) const;
  Point<2> surface_velocity(const Point<2>& amplitudes) const;
  Eigen::Matrix2d gradient(const Point<2>& amplitudes) const;
  Eigen::Vector3d defect(double angle, const Point<2>& amplitudes) const;
  void solve();

  SuperseismicShockProblem problem_;
  double pressure_speed_, shear_speed_;      // c_p, c_s
  Point<2> pressure_normal_, shear_normal_;  // k_p, k_s
  Primitive<2> ahead_, behind_;              // p̃
  double angle_;                             // β
  Point<2> amplitudes_;                      // A, B
};

}  // namespace mortise
