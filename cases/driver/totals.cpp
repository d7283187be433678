#include "mortise/cases/driver/totals.hpp"

#include <algorithm>

#include "mortise/cases/driver/interface_measures.hpp"
#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/solid/elastic_measures.hpp"

namespace mortise {

template <int Dim>
std::array<double, static_cast<std::size_t>(euler_components<Dim>)> totals(const Simulation<Dim>& simulation) {
  constexpr auto n = static_cast<std::size_t>(euler_components<Dim>);
  const EulerSolver<Dim>& fluid = simulation.fluid();
  TileSums<n> sums;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>& grid = fluid.grids()[g];
    const int number = static_cast<int>(g);
    sums.add(g, grid, [&](int t, const Index<Dim>& c, std::size_t cell) {
      const bool shared = !grid.background() || grid.masks[static_cast<std::size_t>(t)].cut();
      const double weight =
          fluid.cell_volume(number, t, c) * (shared ? fluid.share(number, fluid.cell_center(number, t, c)) : 1.0);
      std::array<double, n> summand;
      for (std::size_t k = 0; k < n; ++k)
        summand[k] = weight * fluid.fields()[g].tile(t).component(static_cast<int>(k))[cell];
      return summand;
    });
  }
  return sums.total(fluid.communicator());
}

SolidTotals totals_of(const std::array<double, 8>& sum, double max_von_mises) {
  SolidTotals all;
  all.mass = sum[0];
  all.center = Point<2>(sum[1], sum[2]) / sum[0];
  all.momentum = {sum[3], sum[4]};
  all.angular_momentum = sum[5] - (all.center.x() * sum[4] - all.center.y() * sum[3]);
  all.kinetic_energy = sum[6];
  all.strain_energy = sum[7];
  all.max_von_mises = max_von_mises;
  return all;
}

SolidTotals totals(const ElasticSolver& solid) {
  const Material& material = solid.setup().options.material;
  TileSums<8> sums;  // m, m x, m v, m x × v, kinetic and strain energy
  double von_mises = 0;
  for (std::size_t g = 0; g < solid.grids().size(); ++g) {
    const ComponentGrid<2>& grid = solid.grids()[g];
    const int number = static_cast<int>(g);
    sums.add(g, grid, [&](int t, const Index<2>& c, std::size_t cell) -> std::array<double, 8> {
      const ElasticState state = state_in(solid.fields()[g].tile(t), material.law, cell);
      if (state_of(grid.masks[static_cast<std::size_t>(t)], cell) == CellState::active)
        von_mises = std::max(von_mises, cauchy_stress_of(material, state).von_mises());
      const Point<2> X = solid.cell_center(number, t, c), x = X + displacement_of(material, state),
                     v = velocity_of(state);
      const double volume = solid.cell_volume(number, t, c) * solid.share(number, X), m = material.density * volume;
      return {m,
              m * x.x(),
              m * x.y(),
              m * v.x(),
              m * v.y(),
              m * (x.x() * v.y() - x.y() * v.x()),
              0.5 * m * v.squaredNorm(),
              volume * strain_energy_of(material, state)};
    });
  }
  const Communicator& comm = solid.grids().front().forest.communicator();
  const std::array<double, 8> sum = sums.total(comm);
  return totals_of(sum, comm.max(von_mises));
}

template <int Dim>
std::vector<double> SceneTotals<Dim>::state() const {
  std::vector<double> numbers{mass, energy, reference_work};
  numbers.insert(numbers.end(), momentum.begin(), momentum.end());
  return numbers;
}

template <int Dim>
void SceneTotals<Dim>::resume(const double* state) {
  mass = state[0];
  energy = state[1];
  reference_work = state[2];
  for (int d = 0; d < Dim; ++d) momentum[d] = state[3 + d];
}

namespace {

/// p̃_e of every interface, in the order of Simulation::interfaces().
template <int Dim>
std::vector<double> reference_pressures(const SimulationSetup<Dim>& setup) {
  std::vector<double> all;
  for (const SolidSetup& solid : setup.solids)
    if (solid.interface) all.push_back(solid.interface->options.reference_pressure);
  for (const StructureSetup& structure : setup.structures)
    all.push_back(structure.interface.options.reference_pressure);
  return all;
}

Closure closure_of(BoundaryKind kind) {
  const bool repeats = kind == BoundaryKind::periodic;
  return {repeats || kind == BoundaryKind::wall, repeats};
}

Closure closure_of(const ElasticSide& side) {
  const bool free = side.kind == ElasticBoundary::periodic || side.kind == ElasticBoundary::interface ||
                    (side.kind == ElasticBoundary::traction && !side.value);
  const bool resting =
      side.kind == ElasticBoundary::slip || (side.kind == ElasticBoundary::displacement && !side.value);
  return {free || resting, free};
}

template <class Sides>
void restrict_to(Closure& all, const Sides& sides) {
  for (const auto& side : sides) {
    const Closure one = closure_of(side);
    all.energy = all.energy && one.energy;
    all.momentum = all.momentum && one.momentum;
  }
}

}  // namespace

template <int Dim>
SceneTotals<Dim> scene_totals(const Simulation<Dim>& simulation) {
  const auto fluid = totals(simulation);
  SceneTotals<Dim> sum;
  sum.mass = fluid[0];
  for (int d = 0; d < Dim; ++d) sum.momentum[d] = fluid[static_cast<std::size_t>(1 + d)];
  sum.energy = fluid[Dim + 1];
  for (const RigidBody<Dim>& body : simulation.bodies()) {
    for (int d = 0; d < Dim; ++d) sum.momentum[d] += body.mass * body.y[d];
    sum.energy += body.kinetic_energy();
  }
  for (const auto& solid : simulation.solids()) {
    const SolidTotals part = totals(*solid);
    sum.mass += part.mass;
    for (int d = 0; d < Dim; ++d) sum.momentum[d] += part.momentum[d];
    sum.energy += part.kinetic_energy + part.strain_energy;
  }
  const std::vector<double> pressures = reference_pressures(simulation.setup());
  const std::vector<InterfaceState> interfaces = simulation.interfaces();
  for (std::size_t k = 0; k < interfaces.size(); ++k) sum.reference_work += pressures[k] * area_below(interfaces[k]);
  return sum;
}

template <int Dim>
Closure closure(const Simulation<Dim>& simulation) {
  Closure all{true, true};
  const EulerSetup<Dim>& fluid = simulation.fluid().setup();
  if (fluid.cells[0] > 0) restrict_to(all, fluid.boundaries.kind);
  for (const FittedBody<Dim>& body : fluid.bodies)
    if (body.mesh) restrict_to(all, std::array{body.sides[0], body.sides[1], body.sides[3]});
  for (const auto& solid : simulation.solids()) {
    if (solid->setup().cells[0] > 0) restrict_to(all, solid->setup().sides);
    if (solid->setup().fitted) restrict_to(all, solid->setup().fitted_sides);
  }
  return all;
}

template std::array<double, 3> totals<1>(const Simulation<1>&);
template std::array<double, 4> totals<2>(const Simulation<2>&);
template struct SceneTotals<1>;
template struct SceneTotals<2>;
template SceneTotals<1> scene_totals<1>(const Simulation<1>&);
template SceneTotals<2> scene_totals<2>(const Simulation<2>&);
template Closure closure<1>(const Simulation<1>&);
template Closure closure<2>(const Simulation<2>&);

}  // namespace mortise
