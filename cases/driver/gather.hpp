// What a run writes down: snapshots, probes, norms of the error and totals, gathered so that they do not depend on the ranks.
#pragma once

#include <map>
#include <string>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/summary/summary.hpp"
#include "mortise/coupler/simulation.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// All grids with density, velocity, pressure and Mach number; complete on every rank. Collective.
template <int Dim>
Snapshot gather_snapshot(const Simulation<Dim>& simulation);

/// Norms over active cells of the errors of "fluid.density", "fluid.velocity_x", …, "fluid.pressure", "fluid.temperature" (T = p/ρ) at the present time. Collective.
template <int Dim>
std::map<std::string, ErrorNorms> fluid_errors(const Simulation<Dim>& simulation, const ExactSolution<Dim>& exact);

/// ∫ρ, ∫ρu, ∫E over the fluid (E with p̃), overlapping cells shared out smoothly. Collective.
template <int Dim>
std::array<double, static_cast<std::size_t>(euler_components<Dim>)> totals(const Simulation<Dim>& simulation);

/// Fields and rates of all tiles in the global order of tiles, for checkpoints; the same for any number of ranks.
/// Unallocated tiles are left out. Collective; every rank gets all.
struct TileRecords {
  std::vector<std::int64_t> keys;  // grid, global tile, allocated: three per tile
  std::vector<double> rates;       // per tile
  std::vector<double> values;      // cells of the allocated tiles, component by component
};
template <int Dim>
TileRecords gather_tiles(Simulation<Dim>& simulation);
/// The holes of the simulation are those of the records: tiles wholly inside bodies are left alone.
template <int Dim>
void scatter_tiles(const TileRecords& records, Simulation<Dim>& simulation);

}  // namespace mortise
