#include "mortise/cases/driver/gather.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/fluid/cell.hpp"

namespace mortise {
namespace {

constexpr const char* velocity_names[] = {"velocity_x", "velocity_y"};

/// Calls visit(local tile, local cell index, grid-wide index, offset) for every cell of a grid on this rank.
template <int Dim, class Visit>
void for_each_local_cell(const ComponentGrid<Dim>& grid, Visit&& visit) {
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    const Index<Dim> first = grid.first_cell(t);
    for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
      std::size_t index = 0;
      for (std::size_t d = Dim; d-- > 0;) index = index * static_cast<std::size_t>(grid.cells[d]) + static_cast<std::size_t>(first[d] + c[d]);
      visit(t, c, index, grid.shape.at(c));
    });
  }
}

CellState state_of(const TileMask& mask, std::size_t cell) { return mask.cut() ? mask.state[cell] : CellState::active; }

template <int Dim>
struct CellRecord {
  std::int64_t index;
  std::array<double, Dim + 2> values;  // ρ, u, p
  CellState state;
};

void place_nodes(const Simulation<2>& simulation, std::size_t g, GridSnapshot& out) {
  const ComponentGrid<2>& grid = simulation.fluid().grids()[g];
  out.cells = grid.cells;
  out.x.resize(out.node_count());
  out.y.resize(out.node_count());
  const FittedBody<2>* body = grid.background() ? nullptr : &simulation.setup().fluid.bodies[static_cast<std::size_t>(grid.body)];
  const Frame<2> frame(body ? simulation.bodies()[static_cast<std::size_t>(grid.body)].pose : Pose<2>{});
  for (int j = 0; j <= grid.cells[1]; ++j)
    for (int i = 0; i <= grid.cells[0]; ++i) {
      Point<2> x(grid.origin[0] + i * grid.spacing[0], grid.origin[1] + j * grid.spacing[1]);
      if (body) x = frame.to_space(body->shape.atlas->grid().node(i, j));
      out.x[out.node(i, j)] = x[0];
      out.y[out.node(i, j)] = x[1];
    }
}

void place_nodes(const Simulation<1>& simulation, std::size_t g, GridSnapshot& out) {
  const ComponentGrid<1>& grid = simulation.fluid().grids()[g];
  std::vector<double> nodes;
  for (int i = 0; i <= grid.cells[0]; ++i) {
    double x = grid.origin[0] + i * grid.spacing[0];
    if (!grid.background()) {
      const auto body = static_cast<std::size_t>(grid.body);
      x = simulation.bodies()[body].pose.position[0] + simulation.setup().fluid.bodies[body].shape.atlas->node(grid.side, i);
    }
    nodes.push_back(x);
  }
  out = line_grid(grid.name, nodes);
}

void add_outlines(const Simulation<2>& simulation, Snapshot& snapshot) {
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
    if (!simulation.setup().fluid.bodies[b].wall) continue;
    const Frame<2> frame(simulation.bodies()[b].pose);
    const std::vector<Point<2>>& polygon = simulation.setup().bodies[b].outline->polygon();
    const std::size_t stride = std::max<std::size_t>(1, polygon.size() / 400);  // fine enough for pictures
    std::vector<Point<2>> outline;
    for (std::size_t k = 0; k < polygon.size(); k += stride) outline.push_back(frame.to_space(polygon[k]));
    snapshot.outlines.push_back(std::move(outline));
  }
}

void add_outlines(const Simulation<1>& simulation, Snapshot& snapshot) {
  for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
    const double x = simulation.bodies()[b].pose.position[0];
    const LineAtlas& atlas = *simulation.setup().fluid.bodies[b].shape.atlas;
    const Box<1>& domain = simulation.setup().fluid.domain;
    snapshot.outlines.push_back(
        {Point<2>(std::max(x + atlas.left(), domain.low[0]), 0), Point<2>(std::min(x + atlas.right(), domain.high[0]), 0)});
  }
}

}  // namespace

template <int Dim>
Snapshot gather_snapshot(const Simulation<Dim>& simulation) {
  const EulerSolver<Dim>& fluid = simulation.fluid();
  const Gas& gas = fluid.setup().gas;
  Snapshot snapshot;
  snapshot.time = simulation.time();
  snapshot.step = static_cast<int>(simulation.steps());
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    GridSnapshot out;
    out.dimension = Dim;
    place_nodes(simulation, g, out);
    out.name = grid.name;
    std::vector<CellRecord<Dim>> mine;
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>&, std::size_t index, std::size_t cell) {
      const CellState state = state_of(grid.masks[static_cast<std::size_t>(t)], cell);
      if (state == CellState::hole) return;
      const Primitive<Dim> W = to_primitive(get<Dim>(fluid.fields()[g].tile(t), cell), gas.gamma);
      CellRecord<Dim> record{static_cast<std::int64_t>(index), {}, state};
      record.values[0] = W.density;
      for (std::size_t d = 0; d < Dim; ++d) record.values[1 + d] = W.velocity[d];
      record.values[Dim + 1] = W.pressure - gas.p_inf;
      mine.push_back(record);
    });
    const std::size_t n = out.cell_count();
    out.mask.assign(n, static_cast<std::uint8_t>(CellState::hole));
    std::vector<std::vector<double>> values(Dim + 3, std::vector<double>(n, 0.0));
    for (const CellRecord<Dim>& record : grid.forest.communicator().gather_all(mine)) {
      const auto k = static_cast<std::size_t>(record.index);
      out.mask[k] = static_cast<std::uint8_t>(record.state);
      double speed2 = 0;
      for (std::size_t c = 0; c < Dim + 2; ++c) values[c][k] = record.values[c];
      for (std::size_t d = 0; d < Dim; ++d) speed2 += record.values[1 + d] * record.values[1 + d];
      values[Dim + 2][k] = std::sqrt(speed2 * record.values[0] / (gas.gamma * (record.values[Dim + 1] + gas.p_inf)));
    }
    out.fields.emplace_back("density", std::move(values[0]));
    for (std::size_t d = 0; d < Dim; ++d) out.fields.emplace_back(velocity_names[d], std::move(values[1 + d]));
    out.fields.emplace_back("pressure", std::move(values[Dim + 1]));
    out.fields.emplace_back("mach", std::move(values[Dim + 2]));
    snapshot.grids.push_back(std::move(out));
  }
  add_outlines(simulation, snapshot);
  return snapshot;
}

template <int Dim>
std::map<std::string, ErrorNorms> fluid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact) {
  constexpr std::size_t quantities = Dim + 3;  // ρ, u, p, T
  struct Cell {
    std::int64_t grid, index;
    double volume;
    std::array<double, quantities> error;
  };
  const EulerSolver<Dim>& fluid = simulation.fluid();
  const Gas& gas = fluid.setup().gas;
  std::vector<Cell> mine;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const Pose<Dim> pose = grid.background() ? Pose<Dim>{} : simulation.bodies()[static_cast<std::size_t>(grid.body)].pose;
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>& c, std::size_t index, std::size_t cell) {
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) != CellState::active) return;
      const Primitive<Dim> W = to_primitive(get<Dim>(fluid.fields()[g].tile(t), cell), gas.gamma);
      const Primitive<Dim> E = exact.state(fluid.cell_center(static_cast<int>(g), t, c, pose), simulation.time());
      Cell entry{static_cast<std::int64_t>(g), static_cast<std::int64_t>(index), fluid.cell_volume(static_cast<int>(g), t, c), {}};
      const double pressure = W.pressure - gas.p_inf;
      entry.error[0] = W.density - E.density;
      for (std::size_t d = 0; d < Dim; ++d) entry.error[1 + d] = W.velocity[d] - E.velocity[d];
      entry.error[Dim + 1] = pressure - E.pressure;
      entry.error[Dim + 2] = pressure / W.density - E.pressure / E.density;
      mine.push_back(entry);
    });
  }
  std::vector<Cell> all = fluid.grids().front().forest.communicator().gather_all(mine);
  std::sort(all.begin(), all.end(), [](const Cell& a, const Cell& b) { return std::pair(a.grid, a.index) < std::pair(b.grid, b.index); });
  std::array<ErrorNorms, quantities> norms;
  double volume = 0;
  for (const Cell& cell : all) {
    volume += cell.volume;
    for (std::size_t q = 0; q < quantities; ++q) {
      const double e = std::fabs(cell.error[q]);
      norms[q].l1 += e * cell.volume;
      norms[q].l2 += e * e * cell.volume;
      norms[q].max = std::max(norms[q].max, e);
    }
  }
  std::map<std::string, ErrorNorms> named;
  for (std::size_t q = 0; q < quantities; ++q) {
    const std::string name = q == 0 ? "density" : q <= Dim ? velocity_names[q - 1] : q == Dim + 1 ? "pressure" : "temperature";
    named["fluid." + name] = {norms[q].l1 / volume, std::sqrt(norms[q].l2 / volume), norms[q].max};
  }
  return named;
}

template <int Dim>
std::array<double, static_cast<std::size_t>(euler_components<Dim>)> totals(const Simulation<Dim>& simulation) {
  constexpr auto n = static_cast<std::size_t>(euler_components<Dim>);
  struct TileSum {
    std::int64_t grid, tile;
    std::array<double, n> sum;
  };
  const EulerSolver<Dim>& fluid = simulation.fluid();
  std::vector<TileSum> mine;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const Pose<Dim> pose = grid.background() ? Pose<Dim>{} : simulation.bodies()[static_cast<std::size_t>(grid.body)].pose;
    const std::size_t base = mine.size();
    for (int t = 0; t < grid.forest.local_count(); ++t)
      mine.push_back({static_cast<std::int64_t>(g), grid.forest.first_global() + t, {}});
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>& c, std::size_t, std::size_t cell) {
      const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
      if (state_of(mask, cell) == CellState::hole) return;
      const bool shared = !grid.background() || mask.cut();
      const double weight = fluid.cell_volume(static_cast<int>(g), t, c) *
                            (shared ? fluid.overlap().share(static_cast<int>(g), fluid.cell_center(static_cast<int>(g), t, c, pose)) : 1.0);
      for (std::size_t k = 0; k < n; ++k)
        mine[base + static_cast<std::size_t>(t)].sum[k] += weight * fluid.fields()[g].tile(t).component(static_cast<int>(k))[cell];
    });
  }
  std::map<std::pair<std::int64_t, std::int64_t>, std::array<double, n>> in_order;  // whatever the ranks
  for (const TileSum& tile : fluid.grids().front().forest.communicator().gather_all(mine)) in_order[{tile.grid, tile.tile}] = tile.sum;
  std::array<double, n> sum{};
  for (const auto& [place, of_tile] : in_order)
    for (std::size_t k = 0; k < n; ++k) sum[k] += of_tile[k];
  return sum;
}

template <int Dim>
TileRecords gather_tiles(Simulation<Dim>& simulation) {
  EulerSolver<Dim>& fluid = simulation.fluid();
  TileRecords records;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    TileRecords mine;
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      const TileBlock& block = fluid.fields()[g].tile(t);
      mine.keys.insert(mine.keys.end(), {static_cast<std::int64_t>(g), grid.forest.first_global() + t, block.allocated()});
      mine.rates.push_back(fluid.rates()[g][static_cast<std::size_t>(t)]);
      if (!block.allocated()) continue;
      for (int c = 0; c < EulerSolver<Dim>::components; ++c)
        for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& cell) { mine.values.push_back(block.component(c)[grid.shape.at(cell)]); });
    }
    const Communicator& comm = grid.forest.communicator();  // ranks hold consecutive pieces of the order of tiles
    for (const std::int64_t key : comm.gather_all(mine.keys)) records.keys.push_back(key);
    for (const double rate : comm.gather_all(mine.rates)) records.rates.push_back(rate);
    for (const double value : comm.gather_all(mine.values)) records.values.push_back(value);
  }
  return records;
}

template <int Dim>
void scatter_tiles(const TileRecords& records, Simulation<Dim>& simulation) {
  EulerSolver<Dim>& fluid = simulation.fluid();
  const double* next = records.values.data();
  for (std::size_t k = 0; k < records.rates.size(); ++k) {
    const auto g = static_cast<std::size_t>(records.keys[3 * k]);
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const bool allocated = records.keys[3 * k + 2] != 0;
    const auto count = static_cast<std::size_t>(grid.shape.count() * EulerSolver<Dim>::components);
    const std::int64_t local = records.keys[3 * k + 1] - grid.forest.first_global();
    if (local >= 0 && local < grid.forest.local_count()) {
      const int t = static_cast<int>(local);
      fluid.rates()[g][static_cast<std::size_t>(t)] = records.rates[k];
      TileBlock& block = fluid.fields()[g].tile(t);
      if (allocated && block.allocated()) {
        const double* value = next;
        for (int c = 0; c < EulerSolver<Dim>::components; ++c)
          for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& cell) { block.component(c)[grid.shape.at(cell)] = *value++; });
      }
    }
    if (allocated) next += count;
  }
}

template Snapshot gather_snapshot<1>(const Simulation<1>&);
template Snapshot gather_snapshot<2>(const Simulation<2>&);
template std::map<std::string, ErrorNorms> fluid_errors<1>(const Simulation<1>&, const ExactSolution<1>&);
template std::map<std::string, ErrorNorms> fluid_errors<2>(const Simulation<2>&, const ExactSolution<2>&);
template std::array<double, 3> totals<1>(const Simulation<1>&);
template std::array<double, 4> totals<2>(const Simulation<2>&);
template TileRecords gather_tiles<1>(Simulation<1>&);
template TileRecords gather_tiles<2>(Simulation<2>&);
template void scatter_tiles<1>(const TileRecords&, Simulation<1>&);
template void scatter_tiles<2>(const TileRecords&, Simulation<2>&);

}  // namespace mortise
