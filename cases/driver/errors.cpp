#include "mortise/cases/driver/errors.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/cases/scene/solid_state.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/solid/elastic_measures.hpp"

namespace mortise {

/// Errors of N quantities in one cell.
template <std::size_t N>
struct CellError {
  std::int64_t grid, index;
  double volume;
  std::array<double, N> error;
};

namespace {

/// Norms over the cells of all ranks, summed in the order of grids and cells. Collective.
template <std::size_t N>
std::map<std::string, ErrorNorms> norms_of(const Communicator& comm, const std::vector<CellError<N>>& mine,
                                           const std::array<std::string, N>& names) {
  std::vector<CellError<N>> all = comm.gather_all(mine);
  std::sort(all.begin(), all.end(), [](const CellError<N>& a, const CellError<N>& b) {
    return std::pair(a.grid, a.index) < std::pair(b.grid, b.index);
  });
  std::array<ErrorNorms, N> norms;
  double volume = 0;
  for (const CellError<N>& cell : all) {
    volume += cell.volume;
    for (std::size_t q = 0; q < N; ++q) {
      const double e = std::fabs(cell.error[q]);
      norms[q].l1 += e * cell.volume;
      norms[q].l2 += e * e * cell.volume;
      norms[q].max = std::max(norms[q].max, e);
    }
  }
  std::map<std::string, ErrorNorms> named;
  for (std::size_t q = 0; q < N; ++q)
    named[names[q]] = {norms[q].l1 / volume, std::sqrt(norms[q].l2 / volume), norms[q].max};
  return named;
}

/// What a cell of the fluid should hold: the mean of a smooth solution, the value at its centre otherwise.
template <int Dim>
Primitive<Dim> exact_gas(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact, int grid, int tile,
                         const Index<Dim>& cell) {
  const EulerSolver<Dim>& fluid = simulation.fluid();
  const double gamma = fluid.setup().gas.gamma, t = simulation.time();
  if (!exact.smooth()) return exact.state(fluid.cell_center(grid, tile, cell), t);
  const auto at = [&](const Point<Dim>& x) { return to_conserved(exact.state(x, t), gamma); };
  return to_primitive(mean_state<Dim>(fluid.cell_corners(grid, tile, cell), at), gamma);
}

template <int Dim>
constexpr auto fluid_names() {
  if constexpr (Dim == 1)
    return std::array<std::string, 4>{"fluid.density", "fluid.velocity_x", "fluid.pressure", "fluid.temperature"};
  else
    return std::array<std::string, 5>{"fluid.density", "fluid.velocity_x", "fluid.velocity_y", "fluid.pressure",
                                      "fluid.temperature"};
}

const std::array<std::string, 11> solid_names = {"solid.displacement", "solid.displacement_x", "solid.displacement_y",
                                                 "solid.velocity",     "solid.velocity_x",     "solid.velocity_y",
                                                 "solid.stress",       "solid.stress_xx",      "solid.stress_xy",
                                                 "solid.stress_yx",    "solid.stress_yy"};

/// The same for a solid, in the components of its law.
template <int Dim>
ElasticState exact_solid(const ElasticSolver& solid, const ExactSolution<Dim>& exact, double time, int grid, int tile,
                         const Index<2>& cell) {
  const auto at = [&](const Point<2>& X) { return elastic_state(solid.law(), exact.solid(X, time)); };
  if (!exact.smooth()) return at(solid.cell_center(grid, tile, cell));
  return cell_mean<2>(solid.cell_corners(grid, tile, cell), at);
}

std::array<double, solid_names.size()> solid_error(const Material& material, const ElasticState& state,
                                                   const ElasticState& exact) {
  const Point<2> u = displacement_of(material, state) - displacement_of(material, exact);
  const Point<2> v = velocity_of(state) - velocity_of(exact);
  const Gradient s = stress_of(material, state) - stress_of(material, exact);
  return {u.norm(), u.x(), u.y(), v.norm(), v.x(), v.y(), s.norm(), s(0, 0), s(0, 1), s(1, 0), s(1, 1)};
}

/// The grid of a body as it was grown before anything moved.
const GrownGrid& undeformed(const FittedBody<2>& body) { return body.mesh ? *body.mesh : body.shape.atlas->grid(); }

/// The fluid's side: pressures at its faces, whose middles had the reference positions of its own first grid.
void add_pressures(const InterfaceState& interface, const GrownGrid& mesh, double p_inf, const ExactSolution<2>& exact,
                   std::vector<double>& deviations) {
  for (std::size_t f = 0; f < interface.pressure.size(); ++f) {
    const auto i = static_cast<int>(f);
    const auto known = exact.interface_at(0.5 * (mesh.node(i, 0) + mesh.node(i + 1, 0)), interface.half_time);
    if (known) deviations.push_back(interface.pressure[f] - p_inf - known->pressure);
  }
}

}  // namespace

template <int Dim>
std::map<std::string, ErrorNorms> fluid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact) {
  constexpr std::size_t quantities = Dim + 3;  // ρ, u, p, T
  const EulerSolver<Dim>& fluid = simulation.fluid();
  const Gas& gas = fluid.setup().gas;
  std::vector<CellError<quantities>> mine;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const int number = static_cast<int>(g);
    for_each_local_cell<Dim>(grid, [&](int t, const Index<Dim>& c, std::size_t index, std::size_t cell) {
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) != CellState::active) return;
      const Primitive<Dim> W = to_primitive(get<Dim>(fluid.fields()[g].tile(t), cell), gas.gamma);
      const Primitive<Dim> E = exact_gas<Dim>(simulation, exact, number, t, c);
      CellError<quantities> entry{number, static_cast<std::int64_t>(index), fluid.cell_volume(number, t, c), {}};
      const double pressure = W.pressure - gas.p_inf;
      entry.error[0] = W.density - E.density;
      for (std::size_t d = 0; d < Dim; ++d) entry.error[1 + d] = W.velocity[d] - E.velocity[d];
      entry.error[Dim + 1] = pressure - E.pressure;
      entry.error[Dim + 2] = pressure / W.density - E.pressure / E.density;
      mine.push_back(entry);
    });
  }
  return norms_of(fluid.communicator(), mine, fluid_names<Dim>());
}

template <int Dim>
std::map<std::string, ErrorNorms> solid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact) {
  std::vector<CellError<solid_names.size()>> mine;
  std::int64_t number = 0;
  for (const auto& solid : simulation.solids()) {
    const Material& material = solid->setup().options.material;
    for (int g = 0; g < static_cast<int>(solid->grids().size()); ++g, ++number) {
      const ComponentGrid<2>& grid = solid->grids()[static_cast<std::size_t>(g)];
      const Field<2>& field = solid->fields()[static_cast<std::size_t>(g)];
      for_each_local_cell<2>(grid, [&](int t, const Index<2>& c, std::size_t index, std::size_t cell) {
        if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) != CellState::active) return;
        const ElasticState known = exact_solid(*solid, exact, simulation.time(), g, t, c);
        mine.push_back({number, static_cast<std::int64_t>(index), solid->cell_volume(g, t, c),
                        solid_error(material, state_in(field.tile(t), material.law, cell), known)});
      });
    }
  }
  return norms_of(simulation.fluid().communicator(), mine, solid_names);
}

template <>
InterfaceDeviations interface_deviations(const Simulation<1>&, const ExactSolution<1>&) {
  return {};
}

template <>
InterfaceDeviations interface_deviations(const Simulation<2>& simulation, const ExactSolution<2>& exact) {
  InterfaceDeviations deviations;
  const std::vector<InterfaceState> interfaces = simulation.interfaces();
  for (const SolidSetup& setup : simulation.setup().solids) {
    if (!setup.interface) continue;
    const auto interface = std::find_if(interfaces.begin(), interfaces.end(), [&](const InterfaceState& state) {
      return state.name == setup.interface->name;
    });
    if (interface == interfaces.end()) continue;
    const bool moved = simulation.steps() > 0;
    for (std::size_t n = 0; n < interface->nodes.size(); ++n) {
      const Point<2> X = setup.elastic.fitted->node(static_cast<int>(n), 0);
      if (const auto known = exact.interface_at(X, simulation.time()))
        deviations.position.push_back((interface->nodes[n] - known->position).norm());
      if (const auto known = exact.interface_at(X, interface->half_time); known && moved)
        deviations.velocity.push_back((interface->node_velocities[n] - known->velocity).norm());
    }
    if (moved)
      add_pressures(*interface, undeformed(simulation.setup().fluid.bodies[setup.interface->body]),
                    simulation.fluid().setup().gas.p_inf, exact, deviations.pressure);
  }
  return deviations;
}

template std::map<std::string, ErrorNorms> fluid_errors<1>(const Simulation<1>&, const ExactSolution<1>&);
template std::map<std::string, ErrorNorms> fluid_errors<2>(const Simulation<2>&, const ExactSolution<2>&);
template std::map<std::string, ErrorNorms> solid_errors<1>(const Simulation<1>&, const ExactSolution<1>&);
template std::map<std::string, ErrorNorms> solid_errors<2>(const Simulation<2>&, const ExactSolution<2>&);

}  // namespace mortise
