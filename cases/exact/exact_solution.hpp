// Exact (or asymptotic) solutions that a run is measured against.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/fluid/state.hpp"
#include "mortise/grids/core/types.hpp"

namespace mortise {

/// Where a body is and how it moves at one time. Non-dimensional, angles in radians.
template <int Dim>
struct ExactMotion {
  Pose<Dim> pose;
  Point<Dim> velocity = Point<Dim>::Zero();  // of the centre of mass
  double angular_velocity = 0;
};

/// An elastic solid at one of its material points X. Non-dimensional.
struct ExactSolid {
  Point<2> velocity = Point<2>::Zero();
  Point<2> displacement = Point<2>::Zero();            // u = x − X
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();    // linear: σ; hyperelastic: first Piola-Kirchhoff stress P
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  // ∇u, rows: components of u

  /// Superposition of linear motions.
  ExactSolid& operator+=(const ExactSolid& other) {
    velocity += other.velocity;
    displacement += other.displacement;
    stress += other.stress;
    gradient += other.gradient;
    return *this;
  }
};

/// The interface at one of its material points. Non-dimensional.
struct ExactInterface {
  Point<2> position = Point<2>::Zero();
  Point<2> velocity = Point<2>::Zero();  // of the material
  double pressure = 0;                   // physical pressure of the fluid on it
};

/// The answer of one case as a function of position and time. Non-dimensional.
template <int Dim>
struct ExactSolution {
  virtual ~ExactSolution() = default;

  /// (ρ, u, p) of the fluid with the physical pressure p = p̃ − p∞. Inside a body: the nearest wall state.
  /// Only where describes_fluid(); else throws std::logic_error.
  virtual Primitive<Dim> state(const Point<Dim>& x, double t) const = 0;

  /// False where only the motion of the bodies is known.
  virtual bool describes_fluid() const { return true; }

  /// Motion of all bodies in the order of the case, where it is known.
  virtual std::optional<std::vector<ExactMotion<Dim>>> bodies(double /*t*/) const { return std::nullopt; }

  /// True where solid() answers.
  virtual bool describes_solid() const { return false; }

  /// The solid that is at the reference position X. Only where describes_solid(); else throws std::logic_error.
  virtual ExactSolid solid(const Point<2>& /*X*/, double /*t*/) const {
    throw std::logic_error("this exact solution does not describe a solid");
  }

  /// The material point of the deformable interface with reference position X, where it is known.
  virtual std::optional<ExactInterface> interface_at(const Point<2>& /*X*/, double /*t*/) const { return std::nullopt; }

  /// The solution holds for 0 ≤ t ≤ valid_until().
  virtual double valid_until() const { return std::numeric_limits<double>::infinity(); }

  /// Gas and solid are smooth: cells are started and judged with the mean of the solution, not the value at the centre.
  virtual bool smooth() const { return false; }
};

/// The solution named by description.exact, nullptr where that is empty. Throws InputError for an unknown key (with the
/// nearest one), a key that does not exist in this dimension, and a scene the solution does not cover.
///   1D: riemann, uniform, rigid_piston, shock_on_massless_body
///   2D: riemann, uniform, vortex, weak_shock_on_free_cylinder, and those of elastic_cases.hpp
template <int Dim>
std::unique_ptr<ExactSolution<Dim>> make_exact(const CaseDescription& description);

}  // namespace mortise
