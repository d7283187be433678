// A gas and an elastic solid around the axis that share a circle: one run of RadialGas and RadialSolid, coupled at half
// time by the fluid-structure Riemann problem. With x the position of the interface's material point in its reference
// polar basis, |x| its radius, n = ± x/|x| into the gas, a = |x|/a₀ or 1 (load_law.hpp), Z = diag(ρc_p, ρc_s):
//   1/z_e = a n·Z⁻¹n,  v_e = n·v_s − n·Z⁻¹t_s,  P(v) − p_e + z_e (v − v_e) = 0,
//   t_I = −(P − p_e) a n,  v_I = v_s + Z⁻¹(t_I − t_s).
#pragma once

#include <optional>

#include "mortise/cases/exact/load_law.hpp"
#include "mortise/cases/exact/radial_gas.hpp"
#include "mortise/cases/exact/radial_solid.hpp"

namespace mortise {

/// Non-dimensional. The gas is at rest and the solid without stress at t = 0, in equilibrium: p = p_e.
struct RadialProblem {
  double gamma = 1.4, p_inf = 0;
  double density = 1, pressure = 1 / 1.4;  // of the gas; physical pressure
  Material material;                       // linear
  double interface_radius = 0.5;           // a₀
  double solid_end = 1;                    // the solid's other radius; 0: a full disk
  double gas_end = 0;  // the gas's other radius: inside, of a wall (0: a full disk); outside, of what is known
  std::function<double(double)> far_stress;  // σ_rr(t) at solid_end; empty: held
  double angular_velocity = 0;               // of the solid at t = 0
  LoadLaw load = LoadLaw::current_area;
  double time_end = 1;
};

/// The interface at one time, in the polar basis of its reference position.
struct RadialInterface {
  Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
  Eigen::Vector2d traction = Eigen::Vector2d::Zero();  // on the outward reference normal, per reference area
  double pressure = 0;                                 // p̃
};

class RadialCoupling {
 public:
  /// gas_end: where the grid of the gas ends, at most the problem's.
  RadialCoupling(const RadialProblem& problem, double gas_end, int solid_cells, int gas_cells);

  /// Advances by `steps` equal steps to the time t.
  void advance_to(double t, int steps);

  const RadialGas& gas() const { return gas_; }
  const RadialSolid& solid() const { return solid_; }
  /// The interface at the present time, from both sides extrapolated to it.
  RadialInterface interface_now();

 private:
  RadialInterface project(const Eigen::Vector2d& position) const;

  RadialProblem problem_;
  double side_;  // 1: gas outside, −1: gas inside
  RadialGas gas_;
  RadialSolid solid_;
  Eigen::Vector2d position_, velocity_;  // of the interface: now; over the last step
  double time_ = 0;
};

}  // namespace mortise
