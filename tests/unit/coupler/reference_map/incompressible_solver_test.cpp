#include "mortise/coupler/reference_map/incompressible_solver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr double pi = 3.141592653589793;

struct Norms {
  double l2 = 0, max = 0;
};

/// Velocity against exact(x, t) at the end.
Norms error(const IncompressibleSolver& flow, const std::function<Point<2>(const Point<2>&)>& exact) {
  Norms norms;
  const ComponentGrid<2>& grid = flow.grid();
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
      const Index<2> first = grid.first_cell(t);
      const std::size_t k = grid.shape.at(c);
      const Point<2> v(flow.velocity().tile(t).component(0)[k], flow.velocity().tile(t).component(1)[k]);
      const double e = (v - exact(grid.center({first[0] + c[0], first[1] + c[1]}))).norm();
      norms.l2 += e * e * grid.spacing.prod();
      norms.max = std::max(norms.max, e);
    });
  norms.l2 = std::sqrt(norms.l2);
  return norms;
}

IncompressibleSetup torus(int n) {
  IncompressibleSetup setup;
  setup.domain = {{0, 0}, {1, 1}};
  setup.cells = {n, n};
  setup.tile = {n / 2, n / 2};
  setup.viscosity = 0.01;
  return setup;
}

/// Taylor and Green's vortices, carried by a stream so that they are not steady where they stand.
TEST(IncompressibleSolver, DriftingVorticesAreOfSecondOrder) {
  const Point<2> stream(1, 0.5);
  const auto exact = [&](const Point<2>& x, double t) -> Point<2> {
    const Point<2> y = 2 * pi * (x - t * stream);
    const double decay = std::exp(-8 * pi * pi * 0.01 * t);
    return stream + decay * Point<2>(std::sin(y[0]) * std::cos(y[1]), -std::cos(y[0]) * std::sin(y[1]));
  };
  Norms errors[2];
  for (int level = 0; level < 2; ++level) {
    IncompressibleSetup setup = torus(32 << level);
    setup.velocity = [&](const Point<2>& x) { return exact(x, 0); };
    IncompressibleSolver flow(setup, Communicator());
    flow.initialize();
    while (flow.time() < 0.3) flow.advance(0.3 - flow.time());
    errors[level] = error(flow, [&](const Point<2>& x) { return exact(x, 0.3); });
    EXPECT_EQ(flow.counts().edge_iterations + flow.counts().node_iterations, 0);  // density is constant
  }
  EXPECT_GT(std::log2(errors[0].l2 / errors[1].l2), 1.9);
  EXPECT_GT(std::log2(errors[0].max / errors[1].max), 1.9);
  EXPECT_LT(errors[1].max, 0.01);
}

TEST(IncompressibleSolver, EdgeVelocitiesAreFreeOfDivergence) {
  IncompressibleSetup setup = torus(32);
  setup.velocity = [](const Point<2>& x) { return Point<2>(std::sin(2 * pi * x[1]), std::sin(4 * pi * x[0])); };
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  for (int k = 0; k < 5; ++k) flow.advance(1);
  double worst = 0;
  const TileShape<2>& shape = flow.grid().shape;
  for (int t = 0; t < flow.grid().forest.local_count(); ++t)
    for_each_cell<2>(shape, 0, [&](const Index<2>& c) {
      const double* u = flow.edges().x.tile(t).component(0);
      const double* v = flow.edges().y.tile(t).component(1);
      worst = std::max(worst, std::fabs(u[shape.at(c[0] + 1, c[1])] - u[shape.at(c)] + v[shape.at(c[0], c[1] + 1)] - v[shape.at(c)]));
    });
  EXPECT_LT(worst, 1e-12);
}

/// A channel that is driven by what flows in: parallel flow with the parabola of Poiseuille at its end.
TEST(IncompressibleSolver, ChannelBecomesParabolic) {
  IncompressibleSetup setup;
  setup.domain = {{0, 0}, {4, 1}};
  setup.cells = {64, 32};
  setup.tile = {32, 32};
  setup.viscosity = 0.1;
  setup.sides[west] = {SideKind::inflow, 0, [](const Point<2>&) { return Point<2>(1, 0); }};
  setup.sides[east].kind = SideKind::outflow;
  setup.sides[south].kind = setup.sides[north].kind = SideKind::wall;
  setup.velocity = [](const Point<2>&) { return Point<2>(1, 0); };
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  while (flow.time() < 3) flow.advance(3 - flow.time());
  for (const double y : {0.2, 0.5, 0.8}) EXPECT_NEAR(flow.sample({3.5, y})->velocity.x(), 6 * y * (1 - y), 0.02) << y;
  EXPECT_NEAR(flow.sample({3.5, 0.5})->velocity.y(), 0, 0.01);
  EXPECT_NEAR(flow.sample({3.0, 0.5})->pressure - flow.sample({3.5, 0.5})->pressure, 0.5 * 12 * 0.1, 0.03);  // 12 μ ū/H²
}

/// Rigid rotation of a box cannot be, but a lid drives one vortex: its centre at Re 100 (Ghia, Ghia and Shin 1982: (0.6172, 0.7344)).
TEST(IncompressibleSolver, DrivenCavity) {
  IncompressibleSetup setup;
  setup.cells = {32, 32};
  setup.tile = {32, 32};
  setup.viscosity = 0.01;
  for (FlowSide& side : setup.sides) side.kind = SideKind::wall;
  setup.sides[north].speed = 1;
  IncompressibleSolver flow(setup, Communicator());
  flow.initialize();
  while (flow.time() < 12) flow.advance(12 - flow.time());
  EXPECT_NEAR(flow.sample({0.5, 0.1719})->velocity.x(), -0.10150, 0.008);
  EXPECT_NEAR(flow.sample({0.5, 0.5})->velocity.x(), -0.20581, 0.01);
  EXPECT_NEAR(flow.sample({0.2344, 0.5})->velocity.y(), 0.17527, 0.01);
}

TEST(IncompressibleSolver, WrongNumbersAreRefused) {
  IncompressibleSetup setup = torus(32);
  setup.viscosity = -1;
  EXPECT_THROW(IncompressibleSolver(setup, Communicator()), InputError);
  setup = torus(32);
  setup.sides[west].kind = SideKind::wall;
  EXPECT_THROW(IncompressibleSolver(setup, Communicator()), InputError);
  setup = torus(32);
  setup.pressure_solver = "transfrom";
  EXPECT_THROW(IncompressibleSolver(setup, Communicator()), InputError);
}

}  // namespace
}  // namespace mortise
