#include "mortise/cases/study/difference.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/solid/elastic_measures.hpp"

namespace mortise {
namespace {

/// Energy and amplitude of a cell, per volume.
template <int Dim>
Difference of_gas(const Primitive<Dim>& W, const Primitive<Dim>& other, double gamma) {
  const double stiffness = gamma * W.pressure, c = std::sqrt(stiffness / W.density), dp = other.pressure - W.pressure;
  double square = 0;
  for (std::size_t d = 0; d < Dim; ++d)
    square += (other.velocity[d] - W.velocity[d]) * (other.velocity[d] - W.velocity[d]);
  return {0.5 * (W.density * square + dp * dp / stiffness), std::max(std::sqrt(square) / c, std::abs(dp) / stiffness)};
}

Difference of_solid(const Material& material, const ElasticState& state, const ElasticState& other) {
  const Gradient stress = stress_of(material, other) - stress_of(material, state);
  const double trace = stress.trace(), share = material.lambda / (2 * (material.lambda + material.mu));
  const double square = (velocity_of(other) - velocity_of(state)).squaredNorm();
  const double strain_energy = 0.25 / material.mu * (stress.squaredNorm() - share * trace * trace);
  return {0.5 * material.density * square + strain_energy, std::sqrt(square) / material.pressure_wave_speed()};
}

template <int Dim>
void add_gas(const Simulation<Dim>& base, const Simulation<Dim>& other, Difference& sum) {
  const EulerSolver<Dim>& fluid = base.fluid();
  TileSums<1> energy;
  double amplitude = 0;
  for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
    const ComponentGrid<Dim>&grid = fluid.grids()[g], &twin = other.fluid().grids()[g];
    const int number = static_cast<int>(g);
    energy.add(g, grid, [&](int t, const Index<Dim>& c, std::size_t cell) -> std::array<double, 1> {
      const auto tile = static_cast<std::size_t>(t);
      if (state_of(twin.masks[tile], cell) == CellState::hole) return {0};
      const double gamma = fluid.setup().gas.gamma;
      const Difference one = of_gas(to_primitive(get<Dim>(fluid.fields()[g].tile(t), cell), gamma),
                                    to_primitive(get<Dim>(other.fluid().fields()[g].tile(t), cell), gamma), gamma);
      amplitude = std::max(amplitude, one.amplitude);
      return {fluid.cell_volume(number, t, c) * fluid.share(number, fluid.cell_center(number, t, c)) * one.energy};
    });
  }
  sum.energy += energy.total(fluid.communicator())[0];
  sum.amplitude = std::max(sum.amplitude, fluid.communicator().max(amplitude));
}

void add_solid(const ElasticSolver& base, const ElasticSolver& other, Difference& sum) {
  const Material& material = base.setup().options.material;
  TileSums<1> energy;
  double amplitude = 0;
  for (std::size_t g = 0; g < base.grids().size(); ++g) {
    const int number = static_cast<int>(g);
    energy.add(g, base.grids()[g], [&](int t, const Index<2>& c, std::size_t cell) -> std::array<double, 1> {
      const Difference one = of_solid(material, state_in(base.fields()[g].tile(t), material.law, cell),
                                      state_in(other.fields()[g].tile(t), material.law, cell));
      amplitude = std::max(amplitude, one.amplitude);
      return {base.cell_volume(number, t, c) * base.share(number, base.cell_center(number, t, c)) * one.energy};
    });
  }
  const Communicator& comm = base.grids().front().forest.communicator();
  sum.energy += energy.total(comm)[0];
  sum.amplitude = std::max(sum.amplitude, comm.max(amplitude));
}

template <int Dim>
double energy_of_body(const RigidBody<Dim>& body, const RigidBody<Dim>& other) {
  const Velocity<Dim> change = other.y - body.y;
  return 0.5 * body.mass_diagonal().dot(change.cwiseProduct(change));
}

}  // namespace

template <int Dim>
Difference difference(const Simulation<Dim>& base, const Simulation<Dim>& other) {
  Difference sum;
  add_gas(base, other, sum);
  for (std::size_t k = 0; k < base.solids().size(); ++k) add_solid(*base.solids()[k], *other.solids()[k], sum);
  for (std::size_t b = 0; b < base.bodies().size(); ++b)
    sum.energy += energy_of_body(base.bodies()[b], other.bodies()[b]);
  return sum;
}

template Difference difference<1>(const Simulation<1>&, const Simulation<1>&);
template Difference difference<2>(const Simulation<2>&, const Simulation<2>&);

}  // namespace mortise
