// The solids of a reference-map scene for output: their cells, totals, outlines and material points.
#pragma once

#include <optional>

#include "mortise/cases/driver/totals.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise {

/// Body number `body` on the cells of the background inside it, with the solid_field_names (solid_snapshot.hpp), and appends its
/// surface, φ = 0, to the snapshot's. Collective.
void add_mapped_body(const Simulation<2>& simulation, std::size_t body, Snapshot& snapshot);

/// Sums over cells, weighted with the solid's share of them. Collective.
SolidTotals mapped_totals(const Simulation<2>& simulation, std::size_t body);

/// Smallest J in the body. Collective.
double mapped_least_j(const Simulation<2>& simulation, std::size_t body);

/// Where a material point is, and its state: (v, F, u).
struct MappedPoint {
  Point<2> x;
  ElasticState state;
};
/// Second order; none if X is not in the body. Collective.
std::optional<MappedPoint> mapped_point(const Simulation<2>& simulation, std::size_t body, const Point<2>& X);

}  // namespace mortise
