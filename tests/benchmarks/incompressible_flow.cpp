// Cell steps per second of the incompressible flow, whole steps on one core. Arguments: cells along a side, pressure
// solver (number in pressure_solver_keys()), density ratio of a disk (1: no disk and no density field), walls (0:
// periodic).
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "mortise/coupler/reference_map/incompressible_solver.hpp"

namespace mortise {
namespace {

/// A smoothed disk that stays where it is.
class Disk : public Solids {
 public:
  double ratio = 1;
  const ComponentGrid<2>* grid = nullptr;
  void begin(SolidFields& fields) override {
    for (int t = 0; t < fields.density.tiles(); ++t)
      for_each_cell<2>(grid->shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid->first_cell(t);
        const Point<2> x = grid->center({first[0] + c[0], first[1] + c[1]});
        const double s = std::clamp(((x - Point<2>(-0.1, 0)).norm() - 0.6) / (2 * grid->spacing[0]), -1.0, 1.0);
        const double fluid = 0.5 * (1 + s + std::sin(std::numbers::pi * s) / std::numbers::pi);
        fields.density.tile(t).component(0)[grid->shape.at(c)] = fluid + (1 - fluid) * ratio;
      });
  }
  void half_step(const EdgeVelocities&, double, double, SolidFields&) override {}
  double rate() const override { return 0; }
};

void incompressible_flow(benchmark::State& state) {
  using std::numbers::pi;
  const int n = static_cast<int>(state.range(0));
  IncompressibleSetup setup;
  setup.domain = {Point<2>(-1, -1), Point<2>(1, 1)};
  setup.cells = {n, n}, setup.tile = {64, 64};
  setup.viscosity = 1e-3;
  setup.pressure_solver = pressure_solver_keys()[static_cast<std::size_t>(state.range(1))];
  if (state.range(3) != 0)
    for (FlowSide& side : setup.sides) side.kind = SideKind::wall;
  setup.velocity = [](const Point<2>& x) {
    return Point<2>(std::sin(pi * x[0]) * std::cos(pi * x[1]), -std::cos(pi * x[0]) * std::sin(pi * x[1]));
  };
  Disk disk;
  disk.ratio = static_cast<double>(state.range(2));
  IncompressibleSolver flow(setup, Communicator(MPI_COMM_SELF), state.range(2) > 1 ? &disk : nullptr);
  disk.grid = &flow.grid();
  flow.initialize();
  for (int k = 0; k < 5; ++k) flow.advance(1);
  const FlowCounts before = flow.counts();
  for (auto _ : state) flow.advance(1);
  const FlowCounts after = flow.counts();
  const auto steps = static_cast<double>(after.steps - before.steps);
  state.counters["cell_steps"] = benchmark::Counter(steps * n * n, benchmark::Counter::kIsRate);
  state.counters["edge_iterations"] = static_cast<double>(after.edge_iterations - before.edge_iterations) / steps;
  state.counters["node_iterations"] = static_cast<double>(after.node_iterations - before.node_iterations) / steps;
}
BENCHMARK(incompressible_flow)
    ->ArgsProduct({{128}, {0, 1, 3}, {1, 3}, {0, 1}})
    ->Args({256, 0, 1, 0})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mortise
