#include "mortise/solid/material.hpp"

#include <cmath>
#include <sstream>

#include "mortise/solid/laws.hpp"

namespace mortise {
namespace {

using elastic::NeoHookean, elastic::SaintVenantKirchhoff, elastic::SymmetricTensor, elastic::Tensor, elastic::Vector;

void require(bool good, const char* name, double value, const std::string& bound = "> 0") {
  if (good && std::isfinite(value)) return;
  std::ostringstream message;
  message << "material: " << name << " must be " << (std::isfinite(value) ? bound : "finite") << ", not " << value;
  throw InputError(message.str());
}

std::string above_minus(double mu) {
  std::ostringstream bound;
  bound << "> -mu = " << -mu;
  return bound.str();
}

Tensor<double> tensor(const Gradient& F) { return {F(0, 0), F(0, 1), F(1, 0), F(1, 1)}; }
Gradient matrix(const Tensor<double>& A) { return (Gradient() << A.xx, A.xy, A.yx, A.yy).finished(); }
Eigen::Matrix2d matrix(const SymmetricTensor<double>& A) {
  return (Eigen::Matrix2d() << A.xx, A.xy, A.xy, A.yy).finished();
}

/// action(law) for the formulas of a hyperelastic law.
template <class Action>
auto with_law(const Material& m, Action action) {
  if (m.law == StressLaw::saint_venant_kirchhoff) return action(SaintVenantKirchhoff{m.density, m.lambda, m.mu});
  return action(NeoHookean{m.density, m.lambda, m.mu});
}

/// Z from its action on the unit vectors.
template <class Impedance>
Eigen::Matrix2d matrix_of(const Impedance& Z) {
  const Vector<double> x = Z.apply(Vector<double>{1, 0}), y = Z.apply(Vector<double>{0, 1});
  return (Eigen::Matrix2d() << x.x, y.x, x.y, y.y).finished();
}

}  // namespace

const Registry<StressLaw>& stress_laws() {
  static const Registry<StressLaw> laws("stress law", {{"linear", StressLaw::linear},
                                                       {"saint_venant_kirchhoff", StressLaw::saint_venant_kirchhoff},
                                                       {"neo_hookean", StressLaw::neo_hookean}});
  return laws;
}

double Material::pressure_wave_speed() const { return std::sqrt((lambda + 2 * mu) / density); }
double Material::shear_wave_speed() const { return std::sqrt(mu / density); }

void Material::check() const {
  require(density > 0, "density", density);
  require(mu > 0, "mu", mu);
  require(lambda + mu > 0, "lambda", lambda, above_minus(mu));
}

Gradient stress(const Material& m, const Gradient& F) {
  if (m.law == StressLaw::linear) {
    const Gradient H = F - Gradient::Identity();
    return m.lambda * H.trace() * Gradient::Identity() + m.mu * (H + H.transpose());
  }
  return with_law(m, [&](const auto& law) { return matrix(law.stress(law.at(tensor(F)), tensor(F))); });
}

Eigen::Matrix2d acoustic_tensor(const Material& m, const Gradient& F, const Point<2>& N) {
  if (m.law == StressLaw::linear) return m.mu * Eigen::Matrix2d::Identity() + (m.lambda + m.mu) * N * N.transpose();
  return with_law(m, [&](const auto& law) {
    return matrix(law.acoustic_tensor(law.at(tensor(F)), tensor(F), Vector<double>{N[0], N[1]}));
  });
}

Eigen::Matrix2d impedance(const Material& m, const Gradient& F, const Point<2>& N) {
  if (m.law == StressLaw::linear) {
    const double zp = m.density * m.pressure_wave_speed(), zs = m.density * m.shear_wave_speed();
    return zs * Eigen::Matrix2d::Identity() + (zp - zs) * N * N.transpose();
  }
  return with_law(m, [&](const auto& law) {
    return matrix_of(law.impedance(law.at(tensor(F)), tensor(F), Vector<double>{N[0], N[1]}));
  });
}

}  // namespace mortise
