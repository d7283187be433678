// Linear acoustics on both sides of one interface, coupled by the library's schemes: solid and gas with wave speeds and
// cells 1, impedances z_s = Z and z_f = 1, both at the same Courant number. Starts from noise in all cells.
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "mortise/coupler/amplification.hpp"

namespace mortise::testing {

/// Far ends let waves out, or reflect them: nothing leaves, so that only the scheme can take energy away.
inline ElasticLine even_line(double ratio, double cfl, int order, const std::string& scheme, bool lagged, bool reflect,
                             int cells = 12) {
  ElasticLine line;
  line.solid.impedance = ratio;
  line.solid.cells = line.gas.cells = cells;
  line.solid.end = reflect ? FarEnd::fixed : FarEnd::rest;
  line.gas.end = reflect ? FarEnd::wall : FarEnd::rest;
  line.time_step = cfl;
  line.scheme = scheme;
  line.lagged = lagged;
  line.order = order;
  return line;
}

class AcousticPair {
 public:
  explicit AcousticPair(const ElasticLine& line) : matrix_(amplification_matrix(line)) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> noise(-1, 1);
    state_ = Eigen::VectorXd::Zero(matrix_.rows());
    for (Eigen::Index k = 0; k < cells(); ++k) state_[k] = noise(random);
  }

  void step() { state_ = (matrix_ * state_).eval(); }
  /// Energy of all cells.
  double energy() const { return 0.5 * state_.head(cells()).squaredNorm(); }
  double velocity() const { return state_[cells()]; }      // the structure's of the last step, up to a factor
  double pressure() const { return state_[cells() + 1]; }  // that it carries, up to a factor

 private:
  Eigen::Index cells() const { return matrix_.rows() - 4; }

  Eigen::MatrixXd matrix_;
  Eigen::VectorXd state_;
};

/// Whether noise at the interface has grown rather than decayed after that many steps.
inline bool grows(double ratio, double cfl, int order, const std::string& scheme, bool lagged) {
  AcousticPair pair(even_line(ratio, cfl, order, scheme, lagged, false));
  const double start = pair.energy();
  for (int n = 0; n < 800 && pair.energy() < 1e6 * start; ++n) pair.step();
  return pair.energy() > start;
}

/// The ratio of impedances at which growth begins or ends, by bisection of its logarithm between 0.1 and 10.
inline double threshold(double cfl, int order, const std::string& scheme, bool lagged) {
  double low = 0.1, high = 10;
  const bool below = grows(low, cfl, order, scheme, lagged);
  for (int i = 0; i < 10; ++i) {
    const double middle = std::sqrt(low * high);
    (grows(middle, cfl, order, scheme, lagged) == below ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace mortise::testing
