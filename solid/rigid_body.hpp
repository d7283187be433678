// State of one rigid body. In the plane M ẏ = F with y = (v, ω), M = diag(m, m, I); on a line y = (v), M = (m).
// Mass and inertia may be zero: nothing here divides by them.
#pragma once

#include <array>
#include <string>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// Numbers in the velocity of a rigid body: 1 on a line, 3 in the plane.
template <int Dim>
inline constexpr int degrees_of_freedom = Dim + rotations<Dim>;

/// (v, ω): 3 numbers in the plane, 1 on a line.
template <int Dim>
using Velocity = Eigen::Matrix<double, degrees_of_freedom<Dim>, 1>;

/// One rigid body, non-dimensional; per unit depth in the plane, per unit area on a line.
template <int Dim>
struct RigidBody {
  std::string name;
  double mass = 0;                                   // m ≥ 0
  double inertia = 0;                                // I ≥ 0 about the centre of mass; unused on a line
  Pose<Dim> pose{};                                  // at t
  Velocity<Dim> y = Velocity<Dim>::Zero();           // (v, ω) at t; a held degree: mean velocity of the step
  std::array<bool, degrees_of_freedom<Dim>> held{};  // fixed or prescribed degrees of freedom
  double length = 1;  // mean radius ℓ = √(area/π) > 0: the lever that makes ω comparable with v

  /// Diagonal of M.
  Velocity<Dim> mass_diagonal() const;
  /// Velocity v + ω × (x − position) of the material point at x.
  Point<Dim> velocity_at(const Point<Dim>& x) const;
  /// ½ yᵀ M y.
  double kinetic_energy() const;
};

/// The pose after a time dt at the constant velocity `mean`.
template <int Dim>
Pose<Dim> advanced(const Pose<Dim>& pose, const Velocity<Dim>& mean, double dt);

}  // namespace mortise
