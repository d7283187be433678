// Cell updates per second of the elastic step kernels on one core: 1024 × 1024 cells as a grid of tiles, without ghost
// exchange. Arguments: tile width, tile height, stress law, limiter (as in their enumerations).
#include <benchmark/benchmark.h>

#include <cmath>

#include "mortise/solid/elastic_step.hpp"

namespace mortise {
namespace {

constexpr int side = 1024;
constexpr double spacing = 1.0 / side;

/// Tiles of a smooth state, and one set of nodes that serves them all.
struct Solid {
  Solid(Index<2> cells, const ElasticOptions& o)
      : options(o),
        shape(cells),
        node_shape({cells[0] + 1, cells[1] + 1}),
        tiles(side / cells[0] * (side / cells[1])),
        now(shape, elastic_components(o.material.law), tiles),
        next(shape, elastic_components(o.material.law), tiles),
        nodes(node_shape.plane, 2) {
    const bool linear = o.material.law == StressLaw::linear;
    for (int t = 0; t < tiles; ++t)
      for (int c = 0; c < now.components(); ++c)
        for (int j = -2; j < cells[1] + 2; ++j)
          for (int i = -2; i < cells[0] + 2; ++i)
            now.tile(t).component(c)[shape.at(i, j)] =
                (!linear && (c == 2 || c == 5) ? 1.0 : 0.0) + 0.05 * std::sin(0.11 * i + 0.07 * j + 0.3 * t + c);
    for (int j = -2; j < node_shape.cells[1] + 2; ++j)
      for (int i = -2; i < node_shape.cells[0] + 2; ++i) {
        nodes.component(0)[node_shape.at(i, j)] = spacing * (i + 0.1 * std::sin(0.3 * j));
        nodes.component(1)[node_shape.at(i, j)] = spacing * (j + 0.1 * std::cos(0.2 * i));
      }
  }
  ElasticTile tile(int t, bool curvilinear) {
    ElasticTile tile;
    tile.shape = &shape;
    tile.nodes = &node_shape;
    tile.now = now.tile(t).component(0);
    tile.next = next.tile(t).component(0);
    tile.spacing = {spacing, spacing};
    if (curvilinear) tile.x = nodes.component(0), tile.y = nodes.component(1);
    return tile;
  }
  ElasticOptions options;
  TileShape<2> shape, node_shape;
  int tiles;
  Field<2> now, next;
  TileBlock nodes;
};

void run(benchmark::State& state, bool curvilinear) {
  ElasticOptions options;
  options.material.law = static_cast<StressLaw>(state.range(2));
  options.limiter = static_cast<ElasticLimiter>(state.range(3));
  Solid solid({static_cast<int>(state.range(0)), static_cast<int>(state.range(1))}, options);
  bool admissible = true;
  for (auto _ : state)
    for (int t = 0; t < solid.tiles; ++t)
      admissible = elastic_step(solid.tile(t, curvilinear), 0.1 * spacing, options).admissible && admissible;
  if (!admissible) state.SkipWithError("inadmissible state");
  state.counters["Mcell/s"] = benchmark::Counter(
      1e-6 * solid.tiles * solid.shape.count() * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void cartesian_elastic_step(benchmark::State& state) { run(state, false); }
void curvilinear_elastic_step(benchmark::State& state) { run(state, true); }

void variants(benchmark::internal::Benchmark* b) {
  for (const int law : {0, 1, 2})
    for (const auto& [nx, ny] : {std::pair{60, 30}, {64, 32}, {124, 32}, {256, 64}}) b->Args({nx, ny, law, 0});
  for (const int limiter : {1, 2}) b->Args({124, 32, 0, limiter})->Args({124, 32, 2, limiter});
  b->ArgNames({"nx", "ny", "law", "limiter"})->Unit(benchmark::kMillisecond);
}
BENCHMARK(cartesian_elastic_step)->Apply(variants);
BENCHMARK(curvilinear_elastic_step)->Apply(variants);

}  // namespace
}  // namespace mortise
