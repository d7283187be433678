// Does an exact solution satisfy the equations it claims to solve? Defects by central differences of its answers.
#pragma once

#include <cmath>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/linear_elasticity.hpp"

namespace mortise::testing {

/// Largest defect of ρ v_t = div σ, u_t = v, ∇u and σ = C:∇u at (X, t).
inline double elastic_defect(const ExactSolution<2>& solution, const Material& material, const Point<2>& X, double t,
                             double h = 1e-5) {
  const ExactSolid here = solution.solid(X, t);
  Eigen::Matrix2d gradient;
  Point<2> divergence = Point<2>::Zero();
  for (int d = 0; d < 2; ++d) {
    const Point<2> step = h * Point<2>::Unit(d);
    const ExactSolid after = solution.solid(X + step, t), before = solution.solid(X - step, t);
    gradient.col(d) = (after.displacement - before.displacement) / (2 * h);
    divergence += (after.stress - before.stress).col(d) / (2 * h);
  }
  const ExactSolid after = solution.solid(X, t + h), before = solution.solid(X, t - h);
  const Point<2> acceleration = (after.velocity - before.velocity) / (2 * h);
  const Point<2> velocity = (after.displacement - before.displacement) / (2 * h);
  return std::max({(material.density * acceleration - divergence).cwiseAbs().maxCoeff(),
                   (velocity - here.velocity).cwiseAbs().maxCoeff(), (gradient - here.gradient).cwiseAbs().maxCoeff(),
                   (linear_stress(material, here.gradient) - here.stress).cwiseAbs().maxCoeff()});
}

/// Largest defect of the Euler equations in primitive form at (x, t), γ given.
inline double euler_defect(const ExactSolution<2>& solution, double gamma, const Point<2>& x, double t,
                           double h = 1e-5) {
  using Vector = Eigen::Vector4d;
  const auto at = [&](const Point<2>& y, double s) {
    const Primitive<2> W = solution.state(y, s);
    return Vector(W.density, W.velocity[0], W.velocity[1], W.pressure);
  };
  const Vector W = at(x, t), Wt = (at(x, t + h) - at(x, t - h)) / (2 * h);
  const Point<2> dx(h, 0), dy(0, h);
  const Vector Wx = (at(x + dx, t) - at(x - dx, t)) / (2 * h), Wy = (at(x + dy, t) - at(x - dy, t)) / (2 * h);
  const Vector advection = Wt + W[1] * Wx + W[2] * Wy;
  const double divergence = Wx[1] + Wy[2];
  const Vector defect(advection[0] + W[0] * divergence, advection[1] + Wx[3] / W[0], advection[2] + Wy[3] / W[0],
                      advection[3] + gamma * W[3] * divergence);
  return defect.cwiseAbs().maxCoeff();
}

}  // namespace mortise::testing
