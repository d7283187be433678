// One grid of an elastic solid for output: where its material points are now, and the stress there.
//
// Nodes: x = X + u, u at a node being the mean over the adjoining cells of u_c ± ½ δ_ξ u ± ½ δ_η u (δ: differences
// along the grid, central where both neighbours hold data, one-sided otherwise): order 2 up to the edges of the grid.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "mortise/grids/output/snapshot.hpp"
#include "mortise/solid/elastic_measures.hpp"

namespace mortise {

/// The cell fields of solids in the order they are written: Cauchy stress; reference: the place X of the cell in the
/// undeformed solid.
inline constexpr std::array<const char*, 11> solid_field_names = {
    "displacement_x", "displacement_y", "velocity_x", "velocity_y",  "stress_xx",  "stress_xy",
    "stress_yy",      "von_mises",      "jacobian",   "reference_x", "reference_y"};
std::array<double, solid_field_names.size()> solid_field_values(const Material& material, const Point<2>& X,
                                                                const ElasticState& state);

/// A grid of a solid, gathered from all ranks. Nodes and cells are numbered as in GridSnapshot.
struct SolidGrid {
  std::string name;
  Index<2> cells{};
  bool periodic = false;             // in direction 0: cell n is cell 0
  std::vector<Point<2>> nodes;       // reference positions
  std::vector<std::uint8_t> mask;    // per cell
  std::vector<ElasticState> states;  // per cell, unused in holes
};

/// Displacements of the nodes; zero where no adjoining cell holds data.
std::vector<Point<2>> node_displacements(const SolidGrid& grid, const Material& material);

/// The grid in its present place with the solid_field_names.
GridSnapshot solid_snapshot(const SolidGrid& grid, const Material& material);

/// Puts the nodes of layer 0 where the interface is: one node per cell (a closed curve, or one that repeats itself) or
/// one more. An interface with any other number of nodes is not this grid's and changes nothing.
void place_first_layer(GridSnapshot& grid, std::span<const Point<2>> interface);

}  // namespace mortise
