#include "mortise/cases/driver/gather.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/driver/solid_snapshot.hpp"
#include "mortise/fluid/cell.hpp"

namespace mortise {
namespace {

constexpr const char* velocity_names[] = {"velocity_x", "velocity_y"};

template <std::size_t N>
struct CellRecord {
  std::int64_t index;
  std::array<double, N> values;
  CellState state;
};

void place_nodes(const EulerSolver<2>& fluid, int g, GridSnapshot& out) {
  out.cells = fluid.grids()[static_cast<std::size_t>(g)].cells;
  for (int j = 0; j <= out.cells[1]; ++j)
    for (int i = 0; i <= out.cells[0]; ++i) {
      const Point<2> x = fluid.present_node(g, {i, j});
      out.x.push_back(x[0]);
      out.y.push_back(x[1]);
    }
}

void place_nodes(const EulerSolver<1>& fluid, int g, GridSnapshot& out) {
  const ComponentGrid<1>& grid = fluid.grids()[static_cast<std::size_t>(g)];
  std::vector<double> nodes;
  for (int i = 0; i <= grid.cells[0]; ++i) nodes.push_back(fluid.present_node(g, {i})[0]);
  out = line_grid(grid.name, nodes);
}

/// The gas in a cell that solids share.
Primitive<2> gas_of_mixture(const TileBlock& U, const TileBlock& part, double pressure, double gamma, std::size_t cell) {
  Conserved<2> all = get<2>(U, cell);
  const double share = part.component(composition::share)[cell], of_gas = 1 - share;
  all.energy -= part.component(composition::energy)[cell];
  Primitive<2> W = to_primitive(all, gamma);
  W.density = (W.density - part.component(composition::mass)[cell]) / of_gas;
  W.pressure = (W.pressure - share * pressure) / of_gas;
  return W;
}

/// What is left to the gas of a cell says little of it where this much or more of the cell is solid: such cells are holes.
constexpr double most_solid_share = 0.01;

template <int Dim>
GridSnapshot fluid_snapshot(const Simulation<Dim>& simulation, int g) {
  const EulerSolver<Dim>& fluid = simulation.fluid();
  const ComponentGrid<Dim>& grid = fluid.grids()[static_cast<std::size_t>(g)];
  const Field<Dim>& field = fluid.fields()[static_cast<std::size_t>(g)];
  const Gas& gas = fluid.setup().gas;
  std::vector<CellRecord<Dim + 2>> mine;  // ρ, u, p
  for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>&, std::size_t index, std::size_t cell) {
    const CellState state = state_of(grid.masks[static_cast<std::size_t>(t)], cell);
    if (state == CellState::hole) return;
    Primitive<Dim> W = to_primitive(get<Dim>(field.tile(t), cell), gas.gamma);
    if constexpr (Dim == 2)
      if (const ReferenceMapScene* map = simulation.reference_map(); map && map->composition().tile(t).allocated()) {
        const double share = map->composition().tile(t).component(composition::share)[cell];
        if (share > most_solid_share) return;
        if (share > 0) W = gas_of_mixture(field.tile(t), map->composition().tile(t), map->setup().pressure, gas.gamma, cell);
      }
    CellRecord<Dim + 2> record{static_cast<std::int64_t>(index), {}, state};
    record.values[0] = W.density;
    for (std::size_t d = 0; d < Dim; ++d) record.values[1 + d] = W.velocity[d];
    record.values[Dim + 1] = W.pressure - gas.p_inf;
    mine.push_back(record);
  });
  GridSnapshot out;
  out.dimension = Dim;
  place_nodes(fluid, g, out);
  out.name = grid.name;
  const std::size_t n = out.cell_count();
  out.mask.assign(n, mask_hole);
  std::vector<std::vector<double>> values(Dim + 3, std::vector<double>(n, 0.0));
  for (const CellRecord<Dim + 2>& record : grid.forest.communicator().gather_all(mine)) {
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
  return out;
}

SolidGrid solid_grid(const ElasticSolver& solid, int g) {
  const ComponentGrid<2>& grid = solid.grids()[static_cast<std::size_t>(g)];
  const Field<2>& field = solid.fields()[static_cast<std::size_t>(g)];
  std::vector<CellRecord<std::tuple_size_v<ElasticState>>> mine;
  for_each_local_cell<2>(grid, [&](int t, const Index<2>&, std::size_t index, std::size_t cell) {
    const CellState state = state_of(grid.masks[static_cast<std::size_t>(t)], cell);
    if (state != CellState::hole)
      mine.push_back({static_cast<std::int64_t>(index), state_in(field.tile(t), solid.law(), cell), state});
  });
  SolidGrid out{
      .name = grid.name, .cells = grid.cells, .periodic = grid.periodic[0], .nodes = {}, .mask = {}, .states = {}};
  for (int j = 0; j <= grid.cells[1]; ++j)
    for (int i = 0; i <= grid.cells[0]; ++i) out.nodes.push_back(solid.node(g, i, j));
  const auto n = static_cast<std::size_t>(grid.cells[0]) * static_cast<std::size_t>(grid.cells[1]);
  out.mask.assign(n, mask_hole);
  out.states.assign(n, ElasticState{});
  for (const auto& record : grid.forest.communicator().gather_all(mine)) {
    out.mask[static_cast<std::size_t>(record.index)] = static_cast<std::uint8_t>(record.state);
    out.states[static_cast<std::size_t>(record.index)] = record.values;
  }
  return out;
}

/// The fitted grid is the last one of a solid; its layer 0 is the interface, if there is one of its name.
void add_solid(const ElasticSolver& solid, const std::vector<InterfaceState>& interfaces, Snapshot& snapshot) {
  for (std::size_t g = 0; g < solid.grids().size(); ++g)
    snapshot.grids.push_back(solid_snapshot(solid_grid(solid, static_cast<int>(g)), solid.setup().options.material));
  for (const InterfaceState& interface : interfaces)
    if (interface.name == solid.setup().name) place_first_layer(snapshot.grids.back(), interface.nodes);
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
    snapshot.outlines.push_back({Point<2>(std::max(x + atlas.left(), domain.low[0]), 0),
                                 Point<2>(std::min(x + atlas.right(), domain.high[0]), 0)});
  }
}

}  // namespace

template <int Dim>
Snapshot gather_snapshot(const Simulation<Dim>& simulation, bool contours) {
  Snapshot snapshot;
  snapshot.time = simulation.time();
  snapshot.step = static_cast<int>(simulation.steps());
  for (std::size_t g = 0; g < simulation.fluid().grids().size(); ++g)
    snapshot.grids.push_back(fluid_snapshot(simulation, static_cast<int>(g)));
  const std::vector<InterfaceState> interfaces = simulation.interfaces();
  for (const auto& solid : simulation.solids()) add_solid(*solid, interfaces, snapshot);
  for (const MappedSolid& solid : mapped_solids(simulation)) add_mapped_solid(solid, contours, snapshot);
  add_outlines(simulation, snapshot);
  return snapshot;
}

template Snapshot gather_snapshot<1>(const Simulation<1>&, bool);
template Snapshot gather_snapshot<2>(const Simulation<2>&, bool);

}  // namespace mortise
