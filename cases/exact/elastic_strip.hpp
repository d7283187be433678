// Static linear elasticity of a strip that repeats itself in X (period L), held at its bottom Y = −H, with a curved top
// Y = top(X) under given tractions. Every harmonic k = 2πm/L that vanishes at the bottom is, η = Y + H, α = (λ+μ)/μ,
//   u_X = Re i f e^{ikX},  f = −q/k (1 + α/2) sinh kη − ½α η (p sinh kη + q cosh kη),
//   u_Y = Re g e^{ikX},    g =  p/k (1 + α/2) sinh kη − ½α η (p cosh kη + q sinh kη),   p, q complex,
// and for k = 0 u = (p, q) η. With m = 0 … K the 4K + 2 coefficients satisfy the tractions at 2K + 1 equidistant points
// of the top: spectrally accurate for a smooth top.
#pragma once

#include <Eigen/LU>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/periodic_series.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

class ElasticStrip {
 public:
  /// top: Y(X) of the stress-free strip.
  ElasticStrip(const Material& material, PeriodicSeries top, double height, int harmonics);

  int points() const { return 2 * harmonics_ + 1; }
  Point<2> point(int i) const;  // where tractions are given
  const PeriodicSeries& top() const { return top_; }
  Point<2> normal(double X) const;  // unit reference normal of the top, upwards

  /// Sets the tractions (reference normal, per reference area) at the points.
  void load(const std::vector<Point<2>>& tractions);

  ExactSolid operator()(const Point<2>& X) const;

 private:
  ExactSolid basis(int column, const Point<2>& X) const;

  Material material_;
  PeriodicSeries top_;
  double height_;
  int harmonics_;
  Eigen::PartialPivLU<Eigen::MatrixXd> tractions_;  // of the coefficients at the points
  Eigen::VectorXd coefficients_;
};

}  // namespace mortise
