// Fields and rates of a scene tile by tile, for checkpoints.
#pragma once

#include <cstdint>
#include <vector>

#include "mortise/coupler/reference_map/flow_solids.hpp"
#include "mortise/coupler/reference_map/incompressible_solver.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// All tiles of the fluid's grids, then of the solids' or their maps', in their global order; the same for any number
/// of ranks. Unallocated tiles have no values.
struct TileRecords {
  std::vector<std::int64_t> keys;  // number of the grid, global tile, allocated: three per tile
  std::vector<double> rates;       // per tile
  std::vector<double> values;      // cells of the allocated tiles, component by component
};

/// Collective; every rank gets all.
template <int Dim>
TileRecords gather_tiles(Simulation<Dim>& simulation);

/// The holes of the simulation are those of the records: tiles wholly inside bodies are left alone.
template <int Dim>
void scatter_tiles(const TileRecords& records, Simulation<Dim>& simulation);

/// Whether the records are those of the simulation's tiles, one by one.
template <int Dim>
bool fits(const TileRecords& records, const Simulation<Dim>& simulation);

/// The same of an incompressible flow and the maps of its solids (nullptr: none). Values of the flow are its
/// state(tile), of maps the cells of their tiles.
TileRecords gather_tiles(const IncompressibleSolver& flow, const FlowSolids* solids);
bool fits(const TileRecords& records, const IncompressibleSolver& flow, const FlowSolids* solids);
/// Brings maps and flow to the records, which fit, and to their time. Collective.
void scatter_tiles(const TileRecords& records, double time, IncompressibleSolver& flow, const FlowSolids* solids);

}  // namespace mortise
