// Motion of a rigid piston between two gases (or with gas on one side), as long as the waves it sends are simple:
//   m v' = p_L(v) − p_R(v) + f(t),  X' = v,   p_K(v) = p_K0 [1 ± (γ−1)/2 (v − u_K)/c_K]^(2γ/(γ−1))  (+ right, − left).
// m = 0 makes v the root of p_L − p_R + f = 0. A prescribed motion gives v at once.
// Method: Radau IIA with three stages (order 5, L-stable, stages of a massless piston are exact roots; Hairer & Wanner,
// Solving Ordinary Differential Equations II, table IV.5.6) in equal steps. Between the steps v is the collocation
// cubic and X its integral, so that the error of both is of fourth order in a step of 1/4096 of the time covered.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "mortise/fluid/state.hpp"
#include "mortise/fluid/wall_pressure.hpp"

namespace mortise {

/// Everything per unit area and non-dimensional; pressures of the gases are p̃ = p + p∞.
struct PistonProblem {
  double gamma = 1.4, p_inf = 0;
  std::optional<Primitive<1>> left, right;     // gas that touches the piston; at least one
  double mass = 0;                             // ≥ 0
  double position = 0, velocity = 0;           // at t = 0; velocity is not used for mass = 0 or a prescribed motion
  std::function<double(double)> force;         // f(t) for t ≥ 0; empty: none
  std::function<double(double)> displacement;  // prescribed X(t) − X(0) for t ≥ 0; empty: free
  double time_end = 1;                         // the time to cover, > 0
};

class PistonMotion {
 public:
  /// Throws NumericalError where no velocity balances the forces (a massless piston blown away into vacuum).
  explicit PistonMotion(const PistonProblem& problem);

  double position(double t) const;
  double velocity(double t) const;
  double acceleration(double t) const;
  double step() const { return step_; }

 private:
  struct Step {
    double position, velocity;  // at its start
    Eigen::Vector3d slopes;     // v(θ) = velocity + slopes·(θ, θ², θ³), 0 ≤ θ ≤ 1
  };
  WallResponse net_force(double t, double v) const;
  double balanced_velocity(double guess) const;
  Eigen::Vector3d free_stages(double t, double v) const;
  Eigen::Vector3d prescribed_stages(double t) const;
  std::pair<const Step*, double> locate(double t) const;

  PistonProblem problem_;
  double step_;
  double difference_;     // step of the differences that differentiate a prescribed motion
  double round_off_ = 0;  // velocity below which Newton has converged
  std::vector<Step> steps_;
};

/// f'(t), t ≥ 0, by differences of step h and order 6: central, one-sided where a central one would need f at t < 0.
double derivative(const std::function<double(double)>& f, double t, double h);

}  // namespace mortise
