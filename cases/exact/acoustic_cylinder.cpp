#include "mortise/cases/exact/acoustic_cylinder.hpp"

#include "mortise/cases/exact/bessel_k.hpp"
#include "mortise/cases/exact/inverse_laplace.hpp"

namespace mortise {
namespace {

std::complex<double> velocity_transform(std::complex<double> s, double mu) {
  return 2.0 / (s * s * ((1 + mu) * scaled_bessel_k(1, s) + mu * s * scaled_bessel_k(0, s)));
}

}  // namespace

double acoustic_cylinder_velocity(double ct_over_a, double density_ratio) {
  if (ct_over_a <= 0) return 0;
  return inverse_laplace([&](std::complex<double> s) { return velocity_transform(s, density_ratio); }, ct_over_a);
}

double acoustic_cylinder_displacement(double ct_over_a, double density_ratio) {
  if (ct_over_a <= 0) return 0;
  return inverse_laplace([&](std::complex<double> s) { return velocity_transform(s, density_ratio) / s; }, ct_over_a);
}

}  // namespace mortise
