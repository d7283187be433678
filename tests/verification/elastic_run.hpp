// Elastic solids for tests: exact waves, grids, runs and errors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/solid/elastic_measures.hpp"

namespace mortise::testing {

using std::numbers::pi;

/// λ = μ = ⅓, ρ0 = 1: c_p = 1.
inline Material unit_speed(StressLaw law) { return {.law = law, .density = 1, .lambda = 1.0 / 3, .mu = 1.0 / 3}; }

/// (v, σ or F, u) from v, ∇u and u.
inline ElasticState elastic_state(const Material& material, const Point<2>& v, const Gradient& grad,
                                  const Point<2>& u) {
  if (material.law != StressLaw::linear)
    return {v[0], v[1], 1 + grad(0, 0), grad(0, 1), grad(1, 0), 1 + grad(1, 1), u[0], u[1]};
  const Gradient s = stress(material, Gradient::Identity() + grad);
  return {v[0], v[1], s(0, 0), s(0, 1), s(1, 1), u[0], u[1]};
}

/// Traction on the normal N.
inline Point<2> traction_of(const Material& material, const ElasticState& a, const Point<2>& N) {
  Gradient stress_or_gradient;
  if (material.law == StressLaw::linear)
    stress_or_gradient << a[2], a[3], a[3], a[4];
  else
    stress_or_gradient << a[2], a[3], a[4], a[5];
  return (material.law == StressLaw::linear ? stress_or_gradient : stress(material, stress_or_gradient)) * N;
}

/// u = A d sin(k·X − ω t): along k (P) or across (S). Exact for linear elasticity; the S wave also for neo-Hookean
/// solids, at any amplitude.
struct PlaneWave {
  Material material;
  Point<2> k;
  bool shear = false;
  double amplitude = 0.01;

  ElasticState operator()(const Point<2>& X, double t) const {
    const Point<2> n = k.normalized(), d = shear ? Point<2>(-n.y(), n.x()) : n;
    const double omega = k.norm() * (shear ? material.shear_wave_speed() : material.pressure_wave_speed());
    const double phase = k.dot(X) - omega * t, s = amplitude * std::sin(phase), c = amplitude * std::cos(phase);
    return elastic_state(material, -omega * c * d, c * d * k.transpose(), s * d);
  }
};

/// A side that does what `exact` does there.
inline ElasticSide following(ElasticBoundary kind, const Material& material, const ElasticFunction& exact) {
  return {kind, [=](const Point<2>& X, const Point<2>& N, double t) -> Point<2> {
            const ElasticState a = exact(X, t);
            return kind == ElasticBoundary::displacement ? velocity_of(a) : traction_of(material, a, N);
          }};
}

/// Nodes place(ξ, η) of a grid of along × layers cells, 0 ≤ ξ, η ≤ 1.
template <class Place>
std::shared_ptr<GrownGrid> placed_grid(int along, int layers, double spacing, bool periodic, Place place,
                                       const Point<2>& period = Point<2>::Zero()) {
  auto grid = std::make_shared<GrownGrid>();
  grid->along = along;
  grid->layers = layers;
  grid->spacing = spacing;
  grid->periodic = periodic;
  grid->period = period;
  for (int j = 0; j <= layers; ++j)
    for (int i = 0; i < grid->row(); ++i)
      grid->nodes.push_back(place(static_cast<double>(i) / along, static_cast<double>(j) / layers));
  return grid;
}

/// The ring a ≤ r ≤ 1 with `layers` cells across; layer 0 is the inner circle.
inline std::shared_ptr<GrownGrid> ring(double a, int along, int layers) {
  return placed_grid(along, layers, (1 - a) / layers, true, [a](double xi, double eta) {
    const double r = a + (1 - a) * eta, angle = -2 * pi * xi;
    return Point<2>(r * std::cos(angle), r * std::sin(angle));
  });
}

/// A Cartesian solid on the unit square.
inline ElasticSetup square(const Material& material, int n, int tile, ElasticBoundary kind) {
  ElasticSetup setup;
  setup.name = "square";
  setup.options.material = material;
  setup.domain.include({0, 0});
  setup.domain.include({1, 1});
  setup.cells = {n, n};
  setup.tile = {tile, tile};
  setup.sides.fill({kind, {}});
  return setup;
}

/// The unit disk: a Cartesian core and a grid grown inward from the circle.
inline ElasticSetup disk(const Material& material, int n) {
  const double h = 1.0 / n;
  const Outline circle = Outline::circle(1);
  ElasticSetup setup;
  setup.name = "disk";
  setup.options.material = material;
  setup.fitted = std::make_shared<GrownGrid>(grow(circle, {.spacing = h, .layers = 10, .inward = true}));
  setup.atlas = std::make_shared<BodyAtlas>(circle, *setup.fitted, true);
  const int half = n + 8;
  setup.domain.include(Point<2>::Constant(-half * h));
  setup.domain.include(Point<2>::Constant(half * h));
  setup.cells = {2 * half, 2 * half};
  setup.tile = {half, half};
  return setup;
}

class ElasticRun {
 public:
  ElasticRun(ElasticSetup setup, const ElasticFunction& initial, const Communicator& comm = Communicator())
      : solver_(comm, std::move(setup), timers_) {
    solver_.initialize(initial, 0);
  }
  ElasticSolver& solver() { return solver_; }
  const ElasticSolver& solver() const { return solver_; }
  double time() const { return time_; }

  void step(double dt) {
    ASSERT_TRUE(solver_.step({}, {}, dt)) << solver_.first_bad_cell() << " at t = " << time_;
    time_ += dt;
    solver_.commit(time_);
  }
  /// Equal steps of about CFL number `cfl` until t = end.
  void advance_to(double end, double cfl = 0.9) {
    const int steps = std::max(1, static_cast<int>(std::ceil((end - time_) * solver_.rate() / cfl)));
    const double dt = (end - time_) / steps;
    for (int n = 0; n < steps && !::testing::Test::HasFatalFailure(); ++n) step(dt);
  }

  /// Calls visit(grid, tile, cell, centre, state) for every active cell.
  template <class Visit>
  void for_each_active_cell(Visit visit) const {
    for (int g = 0; g < static_cast<int>(solver_.grids().size()); ++g) {
      const auto grid = static_cast<std::size_t>(g);
      const Field<2>& field = solver_.fields()[grid];
      for (int t = 0; t < field.tiles(); ++t) {
        const TileMask& mask = solver_.grids()[grid].masks[static_cast<std::size_t>(t)];
        for_each_cell<2>(field.shape(), 0, [&](const Index<2>& cell) {
          const std::size_t k = field.shape().at(cell);
          if (mask.cut() && !mask.active[k]) return;
          ElasticState state{};
          for (int c = 0; c < solver_.components(); ++c)
            state[static_cast<std::size_t>(c)] = field.tile(t).component(c)[k];
          visit(g, t, cell, solver_.cell_center(g, t, cell), state);
        });
      }
    }
  }
  /// Differences from `exact` over all components and active cells: the largest, and the mean.
  double largest_error(const ElasticFunction& exact) const { return errors(exact).first; }
  double mean_error(const ElasticFunction& exact) const { return errors(exact).second; }

 private:
  std::pair<double, double> errors(const ElasticFunction& exact) const {
    double largest = 0, sum = 0, numbers = 0;
    for_each_active_cell([&](int, int, const Index<2>&, const Point<2>& X, const ElasticState& state) {
      const ElasticState right = exact(X, time_);
      for (std::size_t c = 0; c < static_cast<std::size_t>(solver_.components()); ++c) {
        const double error = std::abs(state[c] - right[c]);
        largest = error <= largest ? largest : error;  // a NaN stays
        sum += error;
        ++numbers;
      }
    });
    return {largest, sum / numbers};
  }

  PhaseTimers timers_;
  ElasticSolver solver_;
  double time_ = 0;
};

/// Errors at two resolutions fall with at least this order.
inline void expect_order(double coarse, double fine, double order) {
  EXPECT_GE(std::log2(coarse / fine), order) << coarse << " " << fine;
}

}  // namespace mortise::testing
