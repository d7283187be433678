// The incompressible flow alone: exact flows, self-convergence, channel, cavity, liquids at rest, continued runs.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "mortise/coupler/reference_map/incompressible_solver.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

struct Norms {
  double l2 = 0, largest = 0;
};

/// Calls visit(position, u, v) for all cells.
template <class Visit>
void for_each_velocity(const IncompressibleSolver& flow, Visit&& visit) {
  const ComponentGrid<2>& grid = flow.grid();
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
      const Index<2> first = grid.first_cell(t);
      visit(grid.center({first[0] + c[0], first[1] + c[1]}), flow.velocity().tile(t).component(0)[grid.shape.at(c)],
            flow.velocity().tile(t).component(1)[grid.shape.at(c)]);
    });
}

/// Difference of the velocities from exact(place), the L2 norm relative to the area.
template <class Exact>
Norms error_against(const IncompressibleSolver& flow, Exact&& exact) {
  Norms norms;
  int cells = 0;
  for_each_velocity(flow, [&](const Point<2>& x, double u, double v) {
    const Point<2> e = Point<2>(u, v) - exact(x);
    norms.l2 += e.squaredNorm(), ++cells;
    norms.largest = std::max(norms.largest, e.cwiseAbs().maxCoeff());
  });
  norms.l2 = std::sqrt(norms.l2 / cells);
  return norms;
}

void run_to(IncompressibleSolver& flow, double end, double dt) {
  while (flow.time() < end - 1e-12) flow.advance(std::min(dt, end - flow.time()));
}

/// Largest net flow out of a cell over its edges, per area.
double edge_divergence(const IncompressibleSolver& flow) {
  const ComponentGrid<2>& grid = flow.grid();
  double largest = 0;
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
      const double* const u = flow.edges().x.tile(t).component(0);
      const double* const v = flow.edges().y.tile(t).component(1);
      const double du = u[grid.shape.at(c[0] + 1, c[1])] - u[grid.shape.at(c)];
      const double dv = v[grid.shape.at(c[0], c[1] + 1)] - v[grid.shape.at(c)];
      largest = std::max(largest, std::abs(du / grid.spacing[0] + dv / grid.spacing[1]));
    });
  return largest;
}

/// Decaying vortices carried across the grid obliquely.
Norms carried_vortices(int n, FlowSlopes slopes) {
  const double nu = 0.002, end = 0.4;
  const Point<2> mean(1, 0.5);
  const auto exact = [&](const Point<2>& x, double t) {
    const double a = 2 * pi * (x[0] - mean[0] * t), b = 2 * pi * (x[1] - mean[1] * t),
                 decay = std::exp(-8 * pi * pi * nu * t);
    return Point<2>(mean + decay * Point<2>(std::sin(a) * std::cos(b), -std::cos(a) * std::sin(b)));
  };
  IncompressibleSetup setup;
  setup.cells = {n, n}, setup.tile = {16, 16};
  setup.viscosity = nu;
  setup.slopes = slopes;
  setup.velocity = [&](const Point<2>& x) { return exact(x, 0); };
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  run_to(flow, end, 0.2 / n);
  EXPECT_LT(edge_divergence(flow), 1e-10);
  return error_against(flow, [&](const Point<2>& x) { return exact(x, end); });
}

TEST(IncompressibleFlow, CarriedVorticesAreSecondOrder) {
  for (const FlowSlopes slopes : {FlowSlopes::limited, FlowSlopes::central}) {
    const Norms coarse = carried_vortices(32, slopes), fine = carried_vortices(64, slopes),
                finest = carried_vortices(128, slopes);
    SCOPED_TRACE(slopes == FlowSlopes::limited ? "limited" : "central");
    RecordProperty(slopes == FlowSlopes::limited ? "limited" : "central", std::to_string(finest.l2));
    EXPECT_GT(std::log2(fine.l2 / finest.l2), 1.9);
    EXPECT_GT(std::log2(fine.largest / finest.largest), 1.9);
    EXPECT_GT(std::log2(coarse.largest / fine.largest), 1.8);
    EXPECT_LT(finest.l2, 5e-4);
  }
}

/// A shear flow along the diagonal, alone with viscosity: exact for all t.
TEST(IncompressibleFlow, ObliqueShearDecaysAtSecondOrder) {
  const double nu = 0.02, end = 0.2;
  double before = 0;
  for (const int n : {64, 128}) {
    IncompressibleSetup setup;
    setup.cells = {n, n}, setup.tile = {16, 32};
    setup.viscosity = nu;
    setup.slopes = FlowSlopes::central;
    const auto exact = [&](const Point<2>& x, double t) {
      const double f = std::exp(-8 * pi * pi * nu * t) * std::sin(2 * pi * (x[0] - x[1]));
      return Point<2>(f, f);
    };
    setup.velocity = [&](const Point<2>& x) { return exact(x, 0); };
    IncompressibleSolver flow(setup, Communicator());
    flow.initialize();
    run_to(flow, end, 0.1 / n);
    const Norms error = error_against(flow, [&](const Point<2>& x) { return exact(x, end); });
    if (before > 0) {
      EXPECT_GT(std::log2(before / error.largest), 1.9);
    }
    EXPECT_LT(error.largest, 6.0 / n / n);
    before = error.largest;
  }
}

/// Pulses of alternate sense on a periodic square.
Point<2> pulses(const Point<2>& x) {
  Point<2> v(0, 0);
  for (int m = 0; m < 6; ++m) {
    const double k = 2 * (m + 1), s = m % 2 == 0 ? 1 : -1, z = -5.0 / 6 + m / 3.0;
    const double f = s * std::exp(-k * (2 - std::cos(pi * (x[0] - z)) - std::cos(pi * (x[1] - z))));
    v += Point<2>(-f * std::sin(pi * (x[1] - z)), f * std::sin(pi * (x[0] - z)));
  }
  return v;
}

std::unique_ptr<IncompressibleSolver> run_pulses(int n, FlowSlopes slopes) {
  IncompressibleSetup setup;
  setup.domain = {Point<2>(-1, -1), Point<2>(1, 1)};
  setup.cells = {n, n}, setup.tile = {n / 2, n / 2};
  setup.viscosity = 1e-3;
  setup.slopes = slopes;
  setup.velocity = pulses;
  auto flow = std::make_unique<IncompressibleSolver>(setup, Communicator());
  flow->initialize();
  run_to(*flow, 0.5, 0.6 / n);
  return flow;
}

/// Differences of a run from one on a grid three times as fine, whose cells have the same centres.
Norms against_finer(int n, FlowSlopes slopes, const IncompressibleSolver& fine) {
  const auto flow = run_pulses(n, slopes);
  return error_against(*flow, [&](const Point<2>& x) { return fine.sample(x)->velocity; });
}

TEST(IncompressibleFlow, PulsesConvergeAtSecondOrder) {
  const auto fine = run_pulses(324, FlowSlopes::central);
  const Norms coarse = against_finer(36, FlowSlopes::central, *fine),
              middle = against_finer(108, FlowSlopes::central, *fine);
  RecordProperty("l2", std::to_string(middle.l2));
  EXPECT_GT(std::log(coarse.l2 / middle.l2) / std::log(3.0), 1.9);
  EXPECT_GT(std::log(coarse.largest / middle.largest) / std::log(3.0), 1.8);
}

IncompressibleSetup channel(int n) {
  IncompressibleSetup setup;
  setup.domain = {Point<2>(0, 0), Point<2>(2, 1)};
  setup.cells = {2 * n, n}, setup.tile = {n / 2, n / 2};
  setup.viscosity = 0.05;
  setup.cfl = 0.8;
  setup.sides[west].kind = SideKind::inflow;
  setup.sides[west].velocity = [](const Point<2>& x) { return Point<2>(4 * x[1] * (1 - x[1]), 0); };
  setup.sides[east].kind = SideKind::outflow;
  setup.sides[south].kind = setup.sides[north].kind = SideKind::wall;
  return setup;
}

TEST(IncompressibleFlow, ChannelFromRestTendsToTheParabolaWithItsPressure) {
  const IncompressibleSetup setup = channel(16);
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  run_to(flow, 6, 1);
  const Norms error = error_against(flow, [](const Point<2>& x) { return Point<2>(4 * x[1] * (1 - x[1]), 0); });
  EXPECT_LT(error.largest, 0.02);
  EXPECT_LT(edge_divergence(flow), 1e-10);
  // −∂p/∂x = 8 μ u_max/H²
  const double drop = flow.sample(Point<2>(0.75, 0.5))->pressure - flow.sample(Point<2>(1.25, 0.5))->pressure;
  EXPECT_NEAR(drop, 0.5 * 8 * 0.05, 0.01);
}

/// Lid-driven cavity, Re = 100; extrema of the velocities on the centre lines as known from spectral solutions.
TEST(IncompressibleFlow, CavityHasThePublishedExtrema) {
  IncompressibleSetup setup;
  setup.cells = {48, 48}, setup.tile = {24, 24};
  setup.viscosity = 0.01;
  setup.cfl = 0.8;
  for (FlowSide& side : setup.sides) side.kind = SideKind::wall;
  setup.sides[north].speed = 1;
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  run_to(flow, 15, 1);
  double lowest_u = 0, highest_v = 0, lowest_v = 0;
  for (int k = 1; k < 200; ++k) {
    lowest_u = std::min(lowest_u, flow.sample(Point<2>(0.5, k / 200.0))->velocity[0]);
    const double v = flow.sample(Point<2>(k / 200.0, 0.5))->velocity[1];
    highest_v = std::max(highest_v, v), lowest_v = std::min(lowest_v, v);
  }
  EXPECT_NEAR(lowest_u, -0.21404, 0.004);
  EXPECT_NEAR(highest_v, 0.17957, 0.004);
  EXPECT_NEAR(lowest_v, -0.25380, 0.004);
}

/// Solids that stand still: a density by place, nothing else.
class StillDensity : public Solids {
 public:
  StillDensity(const std::function<double(const Point<2>&)>& density, double rate) : density_(density), rate_(rate) {}
  void attach(const ComponentGrid<2>& grid) { grid_ = &grid; }
  void begin(SolidFields& fields) override {
    for (int t = 0; t < fields.density.tiles(); ++t)
      for_each_cell<2>(grid_->shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid_->first_cell(t);
        fields.density.tile(t).component(0)[grid_->shape.at(c)] =
            density_(grid_->center({first[0] + c[0], first[1] + c[1]}));
      });
  }
  void half_step(const EdgeVelocities&, double, double, SolidFields&) override {}
  double rate() const override { return rate_; }

 private:
  std::function<double(const Point<2>&)> density_;
  double rate_;
  const ComponentGrid<2>* grid_ = nullptr;
};

TEST(IncompressibleFlow, LayeredLiquidStaysAtRestUnderGravity) {
  for (const std::string& solver : pressure_solver_keys()) {
    IncompressibleSetup setup;
    setup.cells = {16, 32}, setup.tile = {8, 8};
    setup.domain = {Point<2>(0, 0), Point<2>(1, 2)};
    setup.viscosity = 1e-3;
    setup.gravity = Point<2>(0, -1);
    setup.pressure_solver = solver;
    for (FlowSide& side : setup.sides) side.kind = SideKind::wall;
    StillDensity liquid([](const Point<2>& x) { return x[1] < 1 ? 3.0 - x[1] : 1.0; }, 0);
    IncompressibleSolver flow(setup, Communicator(), &liquid);
    liquid.attach(flow.grid());
    flow.initialize();
    for (int k = 0; k < 20; ++k) flow.advance(0.05);
    EXPECT_LT(error_against(flow, [](const Point<2>&) { return Point<2>(0, 0); }).largest, 1e-8) << solver;
    const double drop = flow.sample(Point<2>(0.5, 1.25))->pressure - flow.sample(Point<2>(0.5, 1.75))->pressure;
    EXPECT_NEAR(drop, 0.5, 1e-7) << solver;
  }
}

TEST(IncompressibleFlow, SolidsWithTheFluidsDensityChangeNothing) {
  IncompressibleSetup setup;
  setup.domain = {Point<2>(-1, -1), Point<2>(1, 1)};
  setup.cells = {32, 32}, setup.tile = {16, 16};
  setup.density = 2;
  setup.viscosity = 1e-2;
  setup.velocity = pulses;
  StillDensity solids([](const Point<2>&) { return 2.0; }, 0);
  IncompressibleSolver alone(setup, Communicator()), with(setup, Communicator(), &solids);
  solids.attach(with.grid());
  alone.initialize();
  with.initialize();
  for (int k = 0; k < 20; ++k) {
    alone.advance(0.01);
    with.advance(0.01);
  }
  // μ∇²v and ∇·μ(∇v + ∇vᵀ) differ by μ∇(∇·v), which the projection takes up to its own order.
  const Norms difference = error_against(with, [&](const Point<2>& x) { return alone.sample(x)->velocity; });
  EXPECT_LT(difference.largest, 3e-3);
  EXPECT_GT(error_against(with, pulses).largest, 1e-2);
}

/// Solids of the fluid's density that swell in one half of a torus and shrink in the other.
class Swelling : public StillDensity {
 public:
  Swelling() : StillDensity([](const Point<2>&) { return 1.0; }, 0) {}
  static double divergence(const Point<2>& x) { return 0.3 * std::sin(std::numbers::pi * x[0]); }
  void attach(const ComponentGrid<2>& grid) {
    StillDensity::attach(grid);
    grid_ = &grid;
  }
  void begin(SolidFields& fields) override {
    StillDensity::begin(fields);
    for (int t = 0; t < fields.divergence.tiles(); ++t)
      for_each_cell<2>(grid_->shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid_->first_cell(t);
        fields.divergence.tile(t).component(0)[grid_->shape.at(c)] =
            divergence(grid_->center({first[0] + c[0], first[1] + c[1]}));
      });
  }

 private:
  const ComponentGrid<2>* grid_ = nullptr;
};

TEST(IncompressibleFlow, VelocitiesHaveTheDivergenceThatSolidsAskFor) {
  IncompressibleSetup setup;
  setup.domain = {Point<2>(-1, -1), Point<2>(1, 1)};
  setup.cells = {32, 32}, setup.tile = {16, 16};
  setup.tolerance = 1e-11;
  Swelling solids;
  IncompressibleSolver flow(setup, Communicator(), &solids);
  solids.attach(flow.grid());
  flow.initialize();
  for (int k = 0; k < 3; ++k) flow.advance(1e-3);
  const TileShape<2>& shape = flow.grid().shape;
  const double h = flow.grid().spacing[0];
  const auto s = static_cast<std::size_t>(shape.stride);
  for (int t = 0; t < flow.grid().forest.local_count(); ++t)
    for_each_cell<2>(shape, 0, [&](const Index<2>& c) {
      const Index<2> first = flow.grid().first_cell(t);
      const std::size_t k = shape.at(c);
      const double *const u = flow.edges().x.tile(t).component(0) + k, *const v =
                                                                           flow.edges().y.tile(t).component(1) + k;
      const Point<2> x = flow.grid().center({first[0] + c[0], first[1] + c[1]});
      EXPECT_NEAR((u[1] - u[0]) / h + (v[s] - v[0]) / h, Swelling::divergence(x), 1e-8);
    });
  // ∇·v = .3 sin πx has v = −.3/π cos πx.
  const Norms difference = error_against(
      flow, [](const Point<2>& x) { return Point<2>(-0.3 / std::numbers::pi * std::cos(std::numbers::pi * x[0]), 0); });
  EXPECT_LT(difference.largest, 2e-3);
}

TEST(IncompressibleFlow, RateOfSolidsLimitsTheStep) {
  IncompressibleSetup setup;
  setup.cells = {8, 8}, setup.tile = {8, 8};
  setup.cfl = 0.5;
  StillDensity solids([](const Point<2>&) { return 1.0; }, 40);
  IncompressibleSolver flow(setup, Communicator(), &solids);
  solids.attach(flow.grid());
  flow.initialize();
  EXPECT_DOUBLE_EQ(flow.advance(1), 0.5 / 40);
  EXPECT_DOUBLE_EQ(flow.advance(0.001), 0.001);
}

TEST(IncompressibleFlow, ContinuedRunIsTheSameToTheBit) {
  IncompressibleSetup setup = channel(16);
  IncompressibleSolver whole(setup, Communicator()), part(setup, Communicator());
  whole.initialize();
  for (int k = 0; k < 5; ++k) whole.advance(1);
  std::vector<std::vector<double>> states;
  for (int t = 0; t < whole.grid().forest.local_count(); ++t) states.push_back(whole.state(t));
  part.restore(whole.time(), states);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(whole.advance(1), part.advance(1));
  for (int t = 0; t < whole.grid().forest.local_count(); ++t) EXPECT_EQ(whole.state(t), part.state(t));
  states.pop_back();
  EXPECT_THROW(part.restore(0, states), InputError);
}

}  // namespace
}  // namespace mortise
