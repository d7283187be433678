// Linear elasticity in plane strain: σ = λ tr ε I + 2μ ε, ε = ½(∇u + ∇uᵀ), and motions that depend on one coordinate.
#pragma once

#include <cmath>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

/// λ + 2μ = ρ c_p²: stress over strain of a plane pressure wave.
inline double pressure_modulus(const Material& material) { return material.lambda + 2 * material.mu; }

/// σ for a displacement gradient ∇u.
inline Eigen::Matrix2d linear_stress(const Material& material, const Eigen::Matrix2d& gradient) {
  return material.lambda * gradient.trace() * Eigen::Matrix2d::Identity() +
         material.mu * (gradient + gradient.transpose());
}

/// Unit vector at an angle from +x, in radians; exact at multiples of a right angle as far as sin and cos are.
inline Point<2> direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A turned by +90°.
inline Point<2> left_of(const Point<2>& a) { return {-a[1], a[0]}; }

/// The motion u along the unit vector d that depends on n·X only, with du/d(n·X) = slope.
inline ExactSolid plane_motion(const Material& material, const Point<2>& n, const Point<2>& d, double velocity,
                               double displacement, double slope) {
  ExactSolid solid;
  solid.velocity = velocity * d;
  solid.displacement = displacement * d;
  solid.gradient = slope * d * n.transpose();
  solid.stress = linear_stress(material, solid.gradient);
  return solid;
}

/// (ρ, u, p) with the velocity of a line along the unit vector n in the plane.
inline Primitive<2> along(const Primitive<1>& line, const Point<2>& n) {
  return {line.density, {line.velocity[0] * n[0], line.velocity[0] * n[1]}, line.pressure};
}

}  // namespace mortise
