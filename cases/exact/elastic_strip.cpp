#include "mortise/cases/exact/elastic_strip.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"

namespace mortise {
namespace {

/// f, g and their η-derivatives for one of p = 1 or q = 1, all times e^{−kH} so that they stay of order one.
struct Harmonic {
  double f, g, df, dg;
};

Harmonic harmonic(bool of_p, double k, double eta, double height, double alpha) {
  const double up = 0.5 * std::exp(k * (eta - height)), down = 0.5 * std::exp(-k * (eta + height));
  const double s = up - down, c = up + down, a = 1 + 0.5 * alpha, b = 0.5 * alpha;
  if (of_p) return {-b * eta * s, a / k * s - b * eta * c, -b * (s + eta * k * c), a * c - b * (c + eta * k * s)};
  return {-a / k * s - b * eta * c, -b * eta * s, -a * c - b * (c + eta * k * s), -b * (s + eta * k * c)};
}

}  // namespace

ElasticStrip::ElasticStrip(const Material& material, PeriodicSeries top, double height, int harmonics)
    : material_(material),
      top_(std::move(top)),
      height_(height),
      harmonics_(harmonics),
      coefficients_(Eigen::VectorXd::Zero(2 * points())) {
  Eigen::MatrixXd matrix(2 * points(), 2 * points());
  for (int i = 0; i < points(); ++i)
    for (int column = 0; column < 2 * points(); ++column)
      matrix.block<2, 1>(2 * i, column) = basis(column, point(i)).stress * normal(point(i)[0]);
  tractions_.compute(matrix);
}

Point<2> ElasticStrip::point(int i) const {
  const double X = top_.period() * i / points();
  return {X, top_.value(X)};
}

Point<2> ElasticStrip::normal(double X) const { return Point<2>(-top_.slope(X), 1).normalized(); }

/// Columns 0 and 1: p and q of k = 0; then for every harmonic the real and imaginary parts of p and of q.
ExactSolid ElasticStrip::basis(int column, const Point<2>& X) const {
  const double eta = X[1] + height_;
  ExactSolid solid;
  if (column < 2) {
    solid.displacement[column] = eta;
    solid.gradient(column, 1) = 1;
  } else {
    const double k = 2 * std::numbers::pi * ((column - 2) / 4 + 1) / top_.period();
    const double alpha = (material_.lambda + material_.mu) / material_.mu;
    const Harmonic h = harmonic((column - 2) % 4 < 2, k, eta, height_, alpha);
    const std::complex<double> i(0, 1), wave = ((column % 2 == 0) ? 1.0 : i) * std::exp(i * k * X[0]);
    const double along = std::real(i * wave), across = std::real(wave);  // factors of f and g
    solid.displacement = {h.f * along, h.g * across};
    solid.gradient << -k * h.f * across, h.df * along, k * h.g * along, h.dg * across;
  }
  solid.stress = linear_stress(material_, solid.gradient);
  return solid;
}

void ElasticStrip::load(const std::vector<Point<2>>& tractions) {
  Eigen::VectorXd right(2 * points());
  for (int i = 0; i < points(); ++i) right.segment<2>(2 * i) = tractions[static_cast<std::size_t>(i)];
  coefficients_ = tractions_.solve(right);
}

ExactSolid ElasticStrip::operator()(const Point<2>& X) const {
  ExactSolid sum;
  for (int column = 0; column < 2 * points(); ++column) {
    const ExactSolid one = basis(column, X);
    sum.displacement += coefficients_[column] * one.displacement;
    sum.gradient += coefficients_[column] * one.gradient;
  }
  sum.stress = linear_stress(material_, sum.gradient);
  return sum;
}

}  // namespace mortise
