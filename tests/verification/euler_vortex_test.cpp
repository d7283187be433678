// An isentropic vortex carried through a periodic square: second order on Cartesian and on deforming curvilinear grids.
#include <gtest/gtest.h>

#include <numbers>

#include "unit/fluid/plane_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;
using std::numbers::pi;

constexpr double box = 10;
const std::array<double, 2> stream = {1, 0.5};

/// Vortex of strength 5 that started in the middle (Shu 1998), at time t.
Primitive<2> vortex(const Point<2>& x, double t) {
  std::array<double, 2> r;
  for (std::size_t d = 0; d < 2; ++d) {
    const double away = x[static_cast<int>(d)] - stream[d] * t - 0.5 * box;
    r[d] = away - box * std::round(away / box);
  }
  const double strength = 5, swirl = strength / (2 * pi) * std::exp(0.5 * (1 - r[0] * r[0] - r[1] * r[1]));
  const double temperature = 1 - 0.5 * (gamma_air - 1) / gamma_air * swirl * swirl;
  const double density = std::pow(temperature, 1 / (gamma_air - 1));
  return {density, {stream[0] - swirl * r[1], stream[1] + swirl * r[0]}, density * temperature};
}

struct VortexErrors {
  double mean = 0, largest = 0;
};

class Flow {
 public:
  Flow(int n, StepOptions options, bool deforming)
      : n_(n), h_(box / n), deforming_(deforming), options_(options), tile_({n, n}), nodes_({n, n}) {
    const double cube = h_ * h_ * h_;
    if (options_.limiter == Limiter::van_albada) options_.van_albada_floor.fill(10 * cube / (box * box * box) * 50);
    tile_.fill([&](int i, int j) { return vortex(centre(i, j, 0), 0); });
  }

  VortexErrors density_errors_at(double end) {
    for (double t = 0; t < end;) {
      const double dt = std::min(0.15 * h_, end - t);
      tile_.copy_periodic_ghosts();
      const StepResult result =
          deforming_ ? curvilinear_step(t, dt) : godunov_step(tile_.cartesian(h_, h_), dt, options_);
      EXPECT_TRUE(result.admissible);
      EXPECT_LT(result.rate * dt, 1);
      tile_.accept();
      t += dt;
    }
    VortexErrors errors;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i) {
        const double e = std::abs(tile_.before(i, j).density - vortex(centre(i, j, end), end).density);
        errors.mean += e / (n_ * n_);
        errors.largest = std::max(errors.largest, e);
      }
    return errors;
  }

 private:
  Point<2> node(int i, int j, double t) const {
    const double x = i * h_, y = j * h_, a = deforming_ ? 0.3 * std::sin(2 * t + 1) : 0, k = 2 * pi / box;
    return {x + a * std::sin(k * x) * std::cos(k * y), y - a * std::sin(k * (x + y))};
  }
  Point<2> centre(int i, int j, double t) const {
    return 0.25 * (node(i, j, t) + node(i + 1, j, t) + node(i, j + 1, t) + node(i + 1, j + 1, t));
  }
  StepResult curvilinear_step(double t, double dt) {
    nodes_.place([&](int i, int j) -> Point<2> { return 0.5 * (node(i, j, t) + node(i, j, t + dt)); });
    nodes_.move([&](int i, int j) -> Point<2> { return (node(i, j, t + dt) - node(i, j, t)) / dt; });
    return godunov_step(nodes_.tile(tile_), dt, options_);
  }

  int n_;
  double h_;
  bool deforming_;
  StepOptions options_;
  PlaneTile tile_;
  PlaneNodes nodes_;
};

void expect_orders(Limiter limiter, RiemannSolver solver, bool deforming, double mean_order, double largest_order) {
  StepOptions options;
  options.limiter = limiter;
  options.riemann = solver;
  const VortexErrors coarse = Flow(64, options, deforming).density_errors_at(1),
                     fine = Flow(128, options, deforming).density_errors_at(1);
  EXPECT_GE(std::log2(coarse.mean / fine.mean), mean_order) << coarse.mean << " " << fine.mean;
  EXPECT_GE(std::log2(coarse.largest / fine.largest), largest_order) << coarse.largest << " " << fine.largest;
  EXPECT_LT(fine.mean, 3e-4);
}

TEST(EulerVortex, SecondOrderOnACartesianGrid) {
  for (const RiemannSolver solver : {RiemannSolver::hllc, RiemannSolver::exact}) {
    expect_orders(Limiter::none, solver, false, 1.9, 1.9);
    expect_orders(Limiter::van_albada, solver, false, 1.9, 1.9);
    expect_orders(Limiter::mc, solver, false, 1.9, 1.2);
  }
}

TEST(EulerVortex, SecondOrderOnADeformingGrid) {
  expect_orders(Limiter::none, RiemannSolver::hllc, true, 1.9, 1.9);
  expect_orders(Limiter::van_albada, RiemannSolver::hllc, true, 1.9, 1.9);
  expect_orders(Limiter::mc, RiemannSolver::hllc, true, 1.9, 1.2);
}

}  // namespace
}  // namespace mortise
