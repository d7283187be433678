#include "mortise/cases/exact/rayleigh_wave.hpp"

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"

namespace mortise {

/// Root of (2 − x)² − 4 √(1 − x) √(1 − m x), x = (c/c_s)², m = (c_s/c_p)²: negative just above 0, positive at 1.
double rayleigh_speed_ratio(double lambda, double mu) {
  const double m = mu / (lambda + 2 * mu);
  const auto excess = [m](double x) { return (2 - x) * (2 - x) - 4 * std::sqrt((1 - x) * (1 - m * x)); };
  double low = 1e-3, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  return std::sqrt(0.5 * (low + high));
}

RayleighWave::RayleighWave(const RayleighWaveProblem& problem) : problem_(problem) {
  const Material& m = problem.material;
  const double ratio = rayleigh_speed_ratio(m.lambda, m.mu);
  speed_ = ratio * std::sqrt(m.mu / m.density);
  q_ = std::sqrt(1 - ratio * ratio * m.mu / pressure_modulus(m));
  s_ = std::sqrt(1 - ratio * ratio);
}

Primitive<2> RayleighWave::state(const Point<2>&, double) const {
  throw std::logic_error("Rayleigh's wave does not describe a fluid");
}

ExactSolid RayleighWave::solid(const Point<2>& X, double t) const {
  const Point<2> along_surface = direction(problem_.angle), outward = left_of(along_surface);
  const double k = 2 * std::numbers::pi / problem_.length, A = problem_.amplitude, half = 0.5 * (1 + s_ * s_);
  const double phase = k * (along_surface.dot(X - problem_.origin) - speed_ * t),
               depth = k * outward.dot(X - problem_.origin);
  const double sine = std::sin(phase), cosine = std::cos(phase), eq = std::exp(q_ * depth), es = std::exp(s_ * depth);
  const double tangential = A * (eq - half * es), normal = -A * q_ * (eq - es / half);
  const double tangential_slope = A * k * (q_ * eq - half * s_ * es);    // d/dY
  const double normal_slope = -A * k * q_ * (q_ * eq - s_ * es / half);  // d/dY
  ExactSolid solid;
  solid.displacement = tangential * sine * along_surface + normal * cosine * outward;
  solid.velocity = k * speed_ * (-tangential * cosine * along_surface + normal * sine * outward);
  solid.gradient = k * (tangential * cosine * along_surface - normal * sine * outward) * along_surface.transpose() +
                   (tangential_slope * sine * along_surface + normal_slope * cosine * outward) * outward.transpose();
  solid.stress = linear_stress(problem_.material, solid.gradient);
  return solid;
}

}  // namespace mortise
