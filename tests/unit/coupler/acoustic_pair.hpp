// Linear acoustics on both sides of one interface, coupled by the library's schemes: solid (v, σ) on the left, fluid
// (v, p) on the right, wave speeds and cells 1, impedances z_s = Z and z_f = 1, both at CFL number λ.
//   z v_t = σ_x, σ_t = z v_x, fluid with σ = −p; upwind fluxes of half-time states, order 1 or 2 (MUSCL-Hancock with
// central slopes, one-sided at the interface and at the far ends).
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "unit/coupler/interface_scene.hpp"
#include "unit/coupler/wall_scene.hpp"

namespace mortise::testing {

struct Wave {
  double v = 0, sigma = 0;
  Wave operator+(const Wave& o) const { return {v + o.v, sigma + o.sigma}; }
  Wave operator-(const Wave& o) const { return {v - o.v, sigma - o.sigma}; }
  Wave operator*(double k) const { return {v * k, sigma * k}; }
};

class AcousticLine {
 public:
  AcousticLine(int cells, double impedance, int order) : z_(impedance), order_(order), cells_(std::size_t(cells)) {}
  std::vector<Wave>& cells() { return cells_; }

  /// Half-time state at the right or left side of a cell.
  Wave trace(std::size_t i, bool right, double cfl) const {
    const Wave& q = cells_[i];
    if (order_ == 1) return q;
    const bool first = i == 0, last = i + 1 == cells_.size();
    const Wave s = (cells_[last ? i : i + 1] - cells_[first ? i : i - 1]) * (first || last ? 1.0 : 0.5);
    return q + Wave{s.sigma / z_, s.v * z_} * (0.5 * cfl) + s * (right ? 0.5 : -0.5);
  }
  /// With the given solutions at both ends.
  void step(const Wave& left, const Wave& right, double cfl) {
    std::vector<Wave> flux = {left};
    for (std::size_t i = 0; i + 1 < cells_.size(); ++i) {
      const Wave L = trace(i, true, cfl), R = trace(i + 1, false, cfl);
      flux.push_back(
          {0.5 * (L.v + R.v) + 0.5 / z_ * (R.sigma - L.sigma), 0.5 * (L.sigma + R.sigma) + 0.5 * z_ * (R.v - L.v)});
    }
    flux.push_back(right);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Wave change = flux[i + 1] - flux[i];
      cells_[i] = cells_[i] + Wave{change.sigma / z_, change.v * z_} * cfl;
    }
  }

 private:
  double z_;
  int order_;
  std::vector<Wave> cells_;
};

class AcousticPair {
 public:
  AcousticPair(double ratio, double cfl, int order, const std::string& scheme, bool lagged, int cells = 12)
      : z_(ratio),
        cfl_(cfl),
        solid_(cells, ratio, order),
        fluid_(cells, 1, order),
        scheme_(interface_schemes().at(scheme)),
        scene_(one_face({1, 0}, {{}, {}, isotropic_admittance({1, 0}, ratio, ratio)}, {1, {}, 0}, acoustic(1))) {
    options_.lagged = lagged;
    options_.nonlinear = false;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (Wave& q : solid_.cells()) q = {noise(random), ratio * noise(random)};
    for (Wave& q : fluid_.cells()) q = {noise(random), noise(random)};
  }

  /// Far ends let waves out, or reflect them: nothing leaves, so that only the scheme can take energy away.
  void step(bool reflect) {
    const Wave s = solid_.trace(solid_.cells().size() - 1, true, cfl_), f = fluid_.trace(0, false, cfl_);
    scene_.structure[0].velocity = {s.v, 0};
    scene_.structure[0].traction = {s.sigma, 0};
    scene_.fluid[0] = {1, {f.v, 0}, -f.sigma};
    const InterfaceSolution answer = scheme_(scene_.problem(), history_, options_);
    history_.remember(answer);
    const Wave a = solid_.trace(0, false, cfl_), b = fluid_.trace(fluid_.cells().size() - 1, true, cfl_);
    const Wave far_solid = reflect ? Wave{0, a.sigma + z_ * a.v} : Wave{a.v + a.sigma / z_, a.sigma + z_ * a.v} * 0.5;
    const Wave far_fluid = reflect ? Wave{0, b.sigma - b.v} : Wave{b.v - b.sigma, b.sigma - b.v} * 0.5;
    solid_.step(far_solid, {answer.velocity[0][0], answer.traction[0][0]}, cfl_);
    fluid_.step({answer.wall_velocity[0][0], -answer.pressure[0]}, far_fluid, cfl_);
    velocity_ = answer.velocity[0][0];
    pressure_ = answer.load[0];
  }
  /// Energy of all cells.
  double energy() {
    double sum = 0;
    for (const Wave& q : solid_.cells()) sum += 0.5 * (z_ * q.v * q.v + q.sigma * q.sigma / z_);
    for (const Wave& q : fluid_.cells()) sum += 0.5 * (q.v * q.v + q.sigma * q.sigma);
    return sum;
  }
  double velocity() const { return velocity_; }  // the structure's, of the last step
  double pressure() const { return pressure_; }  // that it carries

 private:
  double z_, cfl_;
  AcousticLine solid_, fluid_;
  InterfaceScheme scheme_;
  InterfaceScene scene_;
  InterfaceHistory history_;
  InterfaceOptions options_;
  double velocity_ = 0, pressure_ = 0;
};

/// Whether noise at the interface has grown rather than decayed after that many steps.
inline bool grows(double ratio, double cfl, int order, const std::string& scheme, bool lagged) {
  AcousticPair pair(ratio, cfl, order, scheme, lagged);
  pair.step(false);
  const double start = pair.energy();
  for (int n = 0; n < 800 && pair.energy() < 1e6 * start; ++n) pair.step(false);
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
