#include "mortise/cases/exact/radial_solid.hpp"

#include <cmath>

namespace mortise {
namespace {

RadialElastic combine(double a, const RadialElastic& x, double b, const RadialElastic& y) {
  return {a * x.velocity + b * y.velocity, a * x.stress + b * y.stress, a * x.hoop + b * y.hoop};
}

/// Slope at x0 of the parabola through three cells in a row, per cell.
RadialElastic one_sided(const RadialElastic& x0, const RadialElastic& x1, const RadialElastic& x2) {
  return combine(1, combine(-1.5, x0, 2, x1), -0.5, x2);
}

}  // namespace

RadialSolid::RadialSolid(const Material& material, double near, double far, int cells, double omega,
                         std::function<double(double)> far_stress)
    : material_(material),
      near_(near),
      far_(far),
      far_stress_(std::move(far_stress)),
      modulus_(material.lambda + 2 * material.mu, material.mu),
      state_(static_cast<std::size_t>(cells)),
      slope_(state_.size()),
      half_(state_.size()),
      displacement_(state_.size(), Eigen::Vector2d::Zero()) {
  impedance_ = (material.density * modulus_).cwiseSqrt();
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i].velocity[1] = omega * radius(static_cast<double>(i) + 0.5);
}

/// The mirror image at the axis: velocities are odd, stresses even.
RadialElastic RadialSolid::mirrored(const RadialElastic& W) const { return {-W.velocity, W.stress, W.hoop}; }

void RadialSolid::predict(double dt) {
  const std::size_t n = state_.size();
  for (std::size_t i = 1; i + 1 < n; ++i) slope_[i] = combine(0.5, state_[i + 1], -0.5, state_[i - 1]);
  slope_[0] = one_sided(state_[0], state_[1], state_[2]);
  slope_[n - 1] = far_ == 0 ? combine(0.5, mirrored(state_[n - 1]), -0.5, state_[n - 2])
                            : combine(-1, one_sided(state_[n - 1], state_[n - 2], state_[n - 3]), 0, state_[0]);
  const double inverse_spacing = 1 / spacing();
  for (std::size_t i = 0; i < n; ++i) {
    const double inverse_radius = 1 / radius(static_cast<double>(i) + 0.5);
    const RadialElastic& W = state_[i];
    const Eigen::Vector2d Dv = inverse_spacing * slope_[i].velocity, Ds = inverse_spacing * slope_[i].stress;
    const double hoop_strain = W.velocity[0] * inverse_radius;
    const Eigen::Vector2d force(Ds[0] + (W.stress[0] - W.hoop) * inverse_radius,
                                Ds[1] + 2 * W.stress[1] * inverse_radius);
    half_[i].velocity = W.velocity + dt / material_.density * force;
    half_[i].stress[0] = W.stress[0] + dt * (modulus_[0] * Dv[0] + material_.lambda * hoop_strain);
    half_[i].stress[1] = W.stress[1] + dt * modulus_[1] * (Dv[1] - W.velocity[1] * inverse_radius);
    half_[i].hoop = W.hoop + dt * (material_.lambda * Dv[0] + modulus_[0] * hoop_strain);
  }
}

RadialElastic RadialSolid::trace() const { return combine(1, half_[0], -0.5, slope_[0]); }

/// Solution of the Riemann problem on a face between two cells in a row.
RadialElastic RadialSolid::between(const RadialElastic& before, const RadialElastic& after) const {
  const double sign = far_ > near_ ? 1 : -1;
  const Eigen::Vector2d dv = after.velocity - before.velocity, ds = after.stress - before.stress;
  return {0.5 * (before.velocity + after.velocity) + 0.5 * sign * ds.cwiseQuotient(impedance_),
          0.5 * (before.stress + after.stress) + 0.5 * sign * dv.cwiseProduct(impedance_), 0};
}

/// The solution at the far end.
RadialElastic RadialSolid::far_face(double t) const {
  const RadialElastic last = combine(1, half_.back(), 0.5, slope_.back());
  const double sign = far_ > near_ ? 1 : -1;
  if (far_ == 0 || !far_stress_)  // nothing moves there
    return {Eigen::Vector2d::Zero(), last.stress - sign * last.velocity.cwiseProduct(impedance_), 0};
  const Eigen::Vector2d stress(far_stress_(t), 0);
  return {last.velocity + sign * (stress - last.stress).cwiseQuotient(impedance_), stress, 0};
}

void RadialSolid::advance(double t, double dt, const RadialElastic& interface) {
  const std::size_t n = state_.size();
  RadialElastic before = interface;
  for (std::size_t i = 0; i < n; ++i) {
    const RadialElastic after =
        i + 1 < n ? between(combine(1, half_[i], 0.5, slope_[i]), combine(1, half_[i + 1], -0.5, slope_[i + 1]))
                  : far_face(t + 0.5 * dt);
    const double a = radius(static_cast<double>(i)), b = radius(static_cast<double>(i) + 1), h = b - a;
    const double inverse_radius = 2 / (a + b), hoop_strain = half_[i].velocity[0] * inverse_radius;
    const Eigen::Vector2d Dv = (after.velocity - before.velocity) / h;
    const double radial_force = ((b * after.stress[0] - a * before.stress[0]) / h - half_[i].hoop) * inverse_radius;
    const double angular_force = 3 * (b * b * after.stress[1] - a * a * before.stress[1]) / (b * b * b - a * a * a);
    RadialElastic& W = state_[i];
    const Eigen::Vector2d old = W.velocity;
    W.velocity += dt / material_.density * Eigen::Vector2d(radial_force, angular_force);
    W.stress[0] += dt * (modulus_[0] * Dv[0] + material_.lambda * hoop_strain);
    W.stress[1] += dt * modulus_[1] * (Dv[1] - half_[i].velocity[1] * inverse_radius);
    W.hoop += dt * (material_.lambda * Dv[0] + modulus_[0] * hoop_strain);
    displacement_[i] += 0.5 * dt * (old + W.velocity);
    before = after;
  }
}

}  // namespace mortise
