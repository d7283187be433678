// Reference solution of an axisymmetric gas and an axisymmetric linear elastic solid that share a circle (radial_shell,
// rotating_elastic_disk): the one-dimensional solver of radial_coupling.hpp on two grids, extrapolated to spacing 0
// (Richardson), kept at equal intervals of time, cubic in space and time in between. Deterministic. On smooth flow the
// answers at a kept time are good to about 1e-9; at weak kinks (the front of a disturbance) to the square of the
// spacing.
#pragma once

#include <vector>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/radial_coupling.hpp"

namespace mortise {

class RadialReference : public ExactSolution<2> {
 public:
  /// cells: of the coarser grid across the solid. snapshots: kept intervals; their times are k time_end/snapshots.
  /// Throws InputError if gas and solid do not lie on either side of the interface.
  explicit RadialReference(const RadialProblem& problem, int cells = 600, int snapshots = 32);

  Primitive<2> state(const Point<2>& x, double t) const override;
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;
  std::optional<ExactInterface> interface_at(const Point<2>& X, double t) const override;
  /// time_end, or when the first disturbance reaches the outer end of the gas.
  double valid_until() const override;

  RadialInterface interface_now(double t) const;

 private:
  /// Columns: cells from the interface outwards in a coordinate 0 < θ < 1 between the interface and the far end.
  using Profile = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>;
  struct Snapshot {
    Profile gas;                           // rows: ρ, u, p̃
    Profile solid;                         // rows: v_r, v_θ, σ_rr, σ_rθ, σ_θθ, u_r, u_θ
    Eigen::Array<double, 7, 1> interface;  // position, velocity, traction, p̃
  };
  static Snapshot snapshot_of(RadialCoupling& run);
  static Snapshot extrapolated(const Snapshot& coarse, const Snapshot& fine);
  static Eigen::ArrayXd sample(const Profile& profile, double theta);
  static Eigen::ArrayXd slope(const Profile& profile, double theta);
  /// Σ weight · of(snapshot) over the kept times around t.
  template <class Function>
  Eigen::ArrayXd at_time(double t, const Function& of) const;

  RadialProblem problem_;
  double side_;     // 1: gas outside, −1: gas inside
  double gas_end_;  // of the grid; the gas beyond is at rest
  std::vector<Snapshot> snapshots_;
};

}  // namespace mortise
