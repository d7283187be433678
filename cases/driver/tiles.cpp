#include "mortise/cases/driver/tiles.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

#include "mortise/cases/driver/map_contours.hpp"
#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {
namespace {

/// The map of a body in the manner of a solver, for its tiles; has no rates.
struct MapTiles {
  explicit MapTiles(BodyMap& map)
      : field(map.field()), none(1, std::vector<double>(static_cast<std::size_t>(map.field().tiles()), 0.0)) {}
  std::span<Field<2>> fields() { return {&field, 1}; }
  std::vector<std::vector<double>>& rates() { return none; }
  Field<2>& field;
  std::vector<std::vector<double>> none;
};

/// Gives a tile of a map memory, or takes it. Ghosts and cells that hold no map say so: maps look beyond what is
/// filled.
void hold_map(Field<2>& field, int t, bool held) {
  if (!held) return field.tile(t).release();
  if (field.tile(t).allocated()) return;
  field.allocate(t);
  std::fill_n(field.tile(t).component(2), field.shape().plane, unknown_phi);
  std::fill_n(field.tile(t).component(3), field.shape().plane, unknown_layer);
}

/// visit(number of the grid, the grid, components, solver, index of the grid in it) for all grids of a scene.
template <class AnySimulation, class Visit>
void for_each_grid(AnySimulation& simulation, Visit&& visit) {
  std::size_t number = 0;
  auto& fluid = simulation.fluid();
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) visit(number++, fluid.grids()[g], fluid.components, fluid, g);
  if constexpr (requires { simulation.fluid().present_node(0, Index<2>{}); })
    if (auto* map = simulation.reference_map())
      for (const auto& body : map->maps()) {
        MapTiles tiles(*body);
        visit(number++, simulation.fluid().grids().front(), MapField::components, tiles, std::size_t{0});
      }
  for (const auto& solid : simulation.solids())
    for (std::size_t g = 0; g < solid->grids().size(); ++g)
      visit(number++, solid->grids()[g], solid->components(), *solid, g);
}

template <int Dim>
void append(TileRecords& records, std::size_t number, const ComponentGrid<Dim>& grid, int components,
            const Field<Dim>& field, const std::vector<double>& rates) {
  TileRecords mine;
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    const TileBlock& block = field.tile(t);
    mine.keys.insert(mine.keys.end(),
                     {static_cast<std::int64_t>(number), grid.forest.first_global() + t, block.allocated()});
    mine.rates.push_back(rates[static_cast<std::size_t>(t)]);
    for (int c = 0; c < components && block.allocated(); ++c)
      for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& cell) {
        mine.values.push_back(block.component(c)[grid.shape.at(cell)]);
      });
  }
  const Communicator& comm = grid.forest.communicator();  // ranks hold consecutive pieces of the order of tiles
  for (const std::int64_t key : comm.gather_all(mine.keys)) records.keys.push_back(key);
  for (const double rate : comm.gather_all(mine.rates)) records.rates.push_back(rate);
  for (const double value : comm.gather_all(mine.values)) records.values.push_back(value);
}

template <int Dim>
void fill(TileBlock& block, const ComponentGrid<Dim>& grid, int components, const double* value) {
  for (int c = 0; c < components; ++c)
    for_each_cell<Dim>(grid.shape, 0,
                       [&](const Index<Dim>& cell) { block.component(c)[grid.shape.at(cell)] = *value++; });
}

template <int Dim>
std::size_t tile_size(const ComponentGrid<Dim>& grid, int components) {
  return static_cast<std::size_t>(grid.shape.count() * components);
}

}  // namespace

template <int Dim>
TileRecords gather_tiles(Simulation<Dim>& simulation) {
  TileRecords records;
  for_each_grid(simulation, [&](std::size_t number, const auto& grid, int components, auto& solver, std::size_t g) {
    append(records, number, grid, components, solver.fields()[g], solver.rates()[g]);
  });
  return records;
}

template <int Dim>
void scatter_tiles(const TileRecords& records, Simulation<Dim>& simulation) {
  const double* next = records.values.data();
  std::size_t k = 0;  // record
  for_each_grid(simulation, [&](std::size_t, const auto& grid, int components, auto& solver, std::size_t g) {
    for (std::int64_t tile = 0; tile < grid.forest.global_count(); ++tile, ++k) {
      const bool allocated = records.keys[3 * k + 2] != 0;
      const std::int64_t local = tile - grid.forest.first_global();
      if (local >= 0 && local < grid.forest.local_count()) {
        solver.rates()[g][static_cast<std::size_t>(local)] = records.rates[k];
        TileBlock& block = solver.fields()[g].tile(static_cast<int>(local));
        if constexpr (std::is_same_v<std::decay_t<decltype(solver)>, MapTiles>) {
          // Bodies are where they were, not where they began.
          hold_map(solver.field, static_cast<int>(local), allocated);
        }
        if (allocated && block.allocated()) fill(block, grid, components, next);
      }
      if (allocated) next += tile_size(grid, components);
    }
  });
}

template <int Dim>
bool fits(const TileRecords& records, const Simulation<Dim>& simulation) {
  std::size_t k = 0, values = 0;
  if (records.keys.size() != 3 * records.rates.size()) return false;
  bool same = true;
  for_each_grid(simulation, [&](std::size_t number, const auto& grid, int components, const auto&, std::size_t) {
    for (std::int64_t tile = 0; tile < grid.forest.global_count(); ++tile, ++k) {
      same = same && k < records.rates.size() && records.keys[3 * k] == static_cast<std::int64_t>(number) &&
             records.keys[3 * k + 1] == tile;
      if (same && records.keys[3 * k + 2] != 0) values += tile_size(grid, components);
    }
  });
  return same && k == records.rates.size() && values == records.values.size();
}

namespace {

std::size_t map_count(const FlowSolids* solids) { return solids ? solids->maps().size() : 0; }

/// Numbers of the records that belong to a tile of the flow: what maps leave.
std::size_t flow_tile_size(const TileRecords& records, const ComponentGrid<2>& grid) {
  const auto tiles = static_cast<std::size_t>(grid.forest.global_count());
  std::size_t of_maps = 0;
  for (std::size_t k = tiles; k < records.rates.size(); ++k)
    if (records.keys[3 * k + 2] != 0) of_maps += tile_size(grid, MapField::components);
  return of_maps > records.values.size() ? 0 : (records.values.size() - of_maps) / tiles;
}

}  // namespace

TileRecords gather_tiles(const IncompressibleSolver& flow, const FlowSolids* solids) {
  const ComponentGrid<2>& grid = flow.grid();
  const Communicator& comm = grid.forest.communicator();
  TileRecords records;
  std::vector<double> mine;
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for (const double value : flow.state(t)) mine.push_back(value);
  for (std::int64_t tile = 0; tile < grid.forest.global_count(); ++tile) {
    records.keys.insert(records.keys.end(), {0, tile, 1});
    records.rates.push_back(0);
  }
  records.values = comm.gather_all(mine);
  const std::vector<double> no_rates(static_cast<std::size_t>(grid.forest.local_count()), 0.0);
  for (std::size_t b = 0; b < map_count(solids); ++b)
    append<2>(records, b + 1, grid, MapField::components, std::as_const(*solids->maps()[b]).field(), no_rates);
  return records;
}

bool fits(const TileRecords& records, const IncompressibleSolver& flow, const FlowSolids* solids) {
  const ComponentGrid<2>& grid = flow.grid();
  const auto tiles = static_cast<std::size_t>(grid.forest.global_count());
  const std::size_t count = tiles * (1 + map_count(solids));
  if (records.keys.size() != 3 * count || records.rates.size() != count) return false;
  std::size_t values = 0, of_flow = flow_tile_size(records, grid);
  if (grid.forest.local_count() > 0 && flow.state(0).size() != of_flow) return false;
  for (std::size_t k = 0; k < count; ++k) {
    if (records.keys[3 * k] != static_cast<std::int64_t>(k / tiles) ||
        records.keys[3 * k + 1] != static_cast<std::int64_t>(k % tiles))
      return false;
    if (records.keys[3 * k + 2] != 0) values += k < tiles ? of_flow : tile_size(grid, MapField::components);
  }
  return values == records.values.size();
}

void scatter_tiles(const TileRecords& records, double time, IncompressibleSolver& flow, const FlowSolids* solids) {
  const ComponentGrid<2>& grid = flow.grid();
  const std::int64_t first = grid.forest.first_global(), tiles = grid.forest.global_count();
  const auto local = [&](std::int64_t tile) {
    return tile >= first && tile < first + grid.forest.local_count() ? static_cast<int>(tile - first) : -1;
  };
  const std::size_t of_flow = flow_tile_size(records, grid);
  const double* next = records.values.data();
  std::vector<std::vector<double>> states;
  for (std::int64_t tile = 0; tile < tiles; ++tile, next += of_flow)
    if (local(tile) >= 0) states.emplace_back(next, next + of_flow);
  std::size_t k = static_cast<std::size_t>(tiles);
  for (std::size_t b = 0; b < map_count(solids); ++b) {
    Field<2>& field = solids->maps()[b]->field();
    for (std::int64_t tile = 0; tile < tiles; ++tile, ++k) {
      const bool allocated = records.keys[3 * k + 2] != 0;
      if (const int t = local(tile); t >= 0) {
        hold_map(field, t, allocated);
        if (allocated) fill(field.tile(t), grid, MapField::components, next);
      }
      if (allocated) next += tile_size(grid, MapField::components);
    }
    solids->maps()[b]->resume();
  }
  flow.restore(time, states);
}

template TileRecords gather_tiles<1>(Simulation<1>&);
template TileRecords gather_tiles<2>(Simulation<2>&);
template void scatter_tiles<1>(const TileRecords&, Simulation<1>&);
template void scatter_tiles<2>(const TileRecords&, Simulation<2>&);
template bool fits<1>(const TileRecords&, const Simulation<1>&);
template bool fits<2>(const TileRecords&, const Simulation<2>&);

}  // namespace mortise
