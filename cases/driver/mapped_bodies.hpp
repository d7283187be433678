// Solids that live on the cells of a fluid by their reference maps, for output: fields, totals, surfaces, material
// points.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mortise/cases/driver/totals.hpp"
#include "mortise/coupler/reference_map/flow_solids.hpp"
#include "mortise/coupler/reference_map/incompressible_solver.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// Of several cells in a row.
struct CellVelocities {
  Pack u, v;
};

/// One of them; a view.
struct MappedSolid {
  std::string name;
  const ComponentGrid<2>* grid;
  const BodyMap* map;
  Material material;
  double blur;                                                            // half width of the blur zone, a length
  std::function<CellVelocities(int tile, std::size_t first)> velocities;  // of the cells from `first` on, also ghosts

  Point<2> velocity(int tile, std::size_t cell) const {
    const CellVelocities all = velocities(tile, cell);
    return {all.u[0], all.v[0]};
  }
};

/// In the order of the case file; none where there is no reference map.
std::vector<MappedSolid> mapped_solids(const Simulation<2>& simulation);
inline std::vector<MappedSolid> mapped_solids(const Simulation<1>&) { return {}; }
std::vector<MappedSolid> mapped_solids(const FlowSolids& solids, const IncompressibleSolver& flow);

/// The cells inside it, with the solid_field_names (solid_snapshot.hpp), its surface, φ = 0, and, if wanted, contours
/// of its map. Collective.
void add_mapped_solid(const MappedSolid& solid, bool contours, Snapshot& snapshot);

/// Sums over cells, weighted with the solid's share of them; without strain energy and stress unless with_stress.
/// Collective.
SolidTotals totals(const MappedSolid& solid, bool with_stress = true);

/// Smallest J in it. Collective.
double least_j(const MappedSolid& solid);

/// Where a material point is, and its state: (v, F, u).
struct MappedPoint {
  Point<2> x = Point<2>::Zero();
  ElasticState state{};
};
/// Second order; none if X is not in the solid. Collective.
std::optional<MappedPoint> material_point(const MappedSolid& solid, const Point<2>& X);

}  // namespace mortise
