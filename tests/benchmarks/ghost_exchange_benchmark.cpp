// Ghost exchange of a plane grid on one rank; it runs twice per time step.
#include "mortise/grids/forest/ghost_exchange.hpp"

#include <benchmark/benchmark.h>

#include <array>

namespace mortise {
namespace {

void fill_plane_grid(benchmark::State& state) {
  const TileShape<2> shape({static_cast<int>(state.range(0)), static_cast<int>(state.range(1))});
  const Forest<2> forest(Communicator(MPI_COMM_SELF), {360 / shape.cells[0], 240 / shape.cells[1]}, {false, false});
  const GhostExchange<2> exchange(forest, shape, 4);
  Field<2> field(shape, 4, forest.local_count());
  const std::array<double, 4> filler{};
  for (auto _ : state) {
    exchange.fill(field, filler);
    benchmark::ClobberMemory();
  }
  state.counters["tiles"] = forest.local_count();
}
BENCHMARK(fill_plane_grid)
    ->Args({60, 30})
    ->Args({120, 30})
    ->Args({120, 60})
    ->Args({360, 240})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mortise
