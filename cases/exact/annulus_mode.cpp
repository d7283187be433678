#include "mortise/cases/exact/annulus_mode.hpp"

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/polar.hpp"

namespace mortise {
namespace {

double j(int order, double x) { return std::cyl_bessel_j(order, x); }
double y(int order, double x) { return std::cyl_neumann(order, x); }

/// J1(κr) Y1(κa) − Y1(κr) J1(κa).
double bracket(double k, double a, double r) { return j(1, k * r) * y(1, k * a) - y(1, k * r) * j(1, k * a); }

/// The m-th root κ of bracket(κ, a, b); neighbouring roots are about π/(b − a) apart.
double root_of(double a, double b, int m) {
  const double step = 0.1 * std::numbers::pi / (b - a);
  double low = step, at_low = bracket(low, a, b);
  for (int found = 0;; low += step) {
    const double at_high = bracket(low + step, a, b);
    if (at_low * at_high < 0 && ++found == m) break;
    at_low = at_high;
  }
  double high = low + step;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (at_low * bracket(middle, a, b) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

AnnulusMode::AnnulusMode(const AnnulusModeProblem& problem)
    : problem_(problem), wave_number_(root_of(problem.inner, problem.outer, problem.mode)) {
  const double a = problem.inner, b = problem.outer;
  frequency_ = wave_number_ * std::sqrt(pressure_modulus(problem.material) / problem.material.density);
  double largest = 0;
  const int samples = 1000 * problem.mode;
  for (int k = 0; k <= samples; ++k) {
    const double value = bracket(wave_number_, a, a + (b - a) * k / samples);
    if (std::abs(value) > 1.000001 * std::abs(largest)) largest = value;  // of equal ones the one next to r = a
  }
  weight_j_ = problem.amplitude / largest * y(1, wave_number_ * a);
  weight_y_ = -problem.amplitude / largest * j(1, wave_number_ * a);
}

Primitive<2> AnnulusMode::state(const Point<2>&, double) const {
  throw std::logic_error("the modes of an annulus do not describe a fluid");
}

ExactSolid AnnulusMode::solid(const Point<2>& X, double t) const {
  const double r = X.norm(), kr = wave_number_ * r;
  const double shape = weight_j_ * j(1, kr) + weight_y_ * y(1, kr);
  const double zero_order = weight_j_ * j(0, kr) + weight_y_ * y(0, kr);
  const double slope = wave_number_ * zero_order - shape / r;
  const double cosine = std::cos(frequency_ * t), sine = std::sin(frequency_ * t);
  const PolarBasis basis(X);
  ExactSolid solid;
  solid.displacement = shape * cosine * basis.radial;
  solid.velocity = -frequency_ * shape * sine * basis.radial;
  solid.gradient = basis.tensor(slope * cosine, 0, 0, shape / r * cosine);
  solid.stress = linear_stress(problem_.material, solid.gradient);
  return solid;
}

}  // namespace mortise
