// Cell updates per second of the fused step kernels on one core: 1024 × 1024 cells as a grid of tiles, without ghost
// exchange. Arguments: tile width, tile height, limiter, Riemann solver (as in their enumerations).
#include <benchmark/benchmark.h>

#include <cmath>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/godunov_step.hpp"

namespace mortise {
namespace {

constexpr int side = 1024;
constexpr double spacing = 1.0 / side;

/// Tiles of a smooth flow, and one set of moving nodes that serves them all, as in a solver that makes nodes tile by
/// tile.
struct Grid {
  explicit Grid(Index<2> cells)
      : shape(cells),
        node_shape({cells[0] + 1, cells[1] + 1}),
        tiles(side / cells[0] * (side / cells[1])),
        now(shape, 4, tiles),
        next(shape, 4, tiles),
        nodes(node_shape.plane, 4) {
    for (int t = 0; t < tiles; ++t)
      for (int j = -2; j < cells[1] + 2; ++j)
        for (int i = -2; i < cells[0] + 2; ++i) {
          const double x = 0.11 * i, y = 0.07 * j + 0.3 * t;
          const Primitive<2> W{
              1 + 0.2 * std::sin(x + y), {0.3 * std::cos(y), 0.2 * std::sin(x)}, 1 + 0.1 * std::cos(x - y)};
          put(now.tile(t), shape.at(i, j), to_conserved(W, 1.4));
        }
    for (int j = -2; j < node_shape.cells[1] + 2; ++j)
      for (int i = -2; i < node_shape.cells[0] + 2; ++i) {
        const std::size_t n = node_shape.at(i, j);
        nodes.component(0)[n] = spacing * (i + 0.1 * std::sin(0.3 * j));
        nodes.component(1)[n] = spacing * (j + 0.1 * std::cos(0.2 * i));
        nodes.component(2)[n] = 0.1 * std::cos(0.1 * j);
        nodes.component(3)[n] = 0.1 * std::sin(0.1 * i);
      }
  }
  CartesianTile<2> cartesian(int t) {
    return {&shape, now.tile(t).component(0), next.tile(t).component(0), {spacing, spacing}};
  }
  CurvilinearTile curvilinear(int t) {
    return {&shape,
            &node_shape,
            now.tile(t).component(0),
            next.tile(t).component(0),
            nodes.component(0),
            nodes.component(1),
            nodes.component(2),
            nodes.component(3),
            nullptr,
            {}};
  }
  TileShape<2> shape, node_shape;
  int tiles;
  Field<2> now, next;
  TileBlock nodes;
};

template <class StepTile>
void run(benchmark::State& state, StepTile step_tile) {
  Grid grid({static_cast<int>(state.range(0)), static_cast<int>(state.range(1))});
  StepOptions options;
  options.limiter = static_cast<Limiter>(state.range(2));
  options.riemann = static_cast<RiemannSolver>(state.range(3));
  options.van_albada_floor.fill(1e-8);
  bool admissible = true;
  for (auto _ : state)
    for (int t = 0; t < grid.tiles; ++t) admissible = step_tile(grid, t, options).admissible && admissible;
  if (!admissible) state.SkipWithError("inadmissible state");
  state.counters["Mcell/s"] = benchmark::Counter(
      1e-6 * grid.tiles * grid.shape.count() * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

constexpr double dt = 0.1 * spacing;

void cartesian_step(benchmark::State& state) {
  run(state,
      [](Grid& grid, int t, const StepOptions& options) { return godunov_step(grid.cartesian(t), dt, options); });
}
void curvilinear_step(benchmark::State& state) {
  run(state,
      [](Grid& grid, int t, const StepOptions& options) { return godunov_step(grid.curvilinear(t), dt, options); });
}

void variants(benchmark::internal::Benchmark* b) {
  for (const auto& [nx, ny] : {std::pair{60, 30}, {64, 32}, {124, 32}, {128, 32}, {256, 64}}) b->Args({nx, ny, 2, 0});
  for (const int limiter : {0, 1, 3}) b->Args({124, 32, limiter, 0});
  for (const int limiter : {0, 1, 2, 3}) b->Args({124, 32, limiter, 2});
  b->Args({124, 32, 2, 1});
  b->ArgNames({"nx", "ny", "limiter", "riemann"})->Unit(benchmark::kMillisecond);
}
BENCHMARK(cartesian_step)->Apply(variants);
BENCHMARK(curvilinear_step)->Apply(variants);

}  // namespace
}  // namespace mortise
