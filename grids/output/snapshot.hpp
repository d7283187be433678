// Everything that is written about one instant, gathered from all ranks: plain data, no physics.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// Values of GridSnapshot::mask.
enum CellMask : std::uint8_t { mask_active = 0, mask_fringe = 1, mask_hole = 2 };

/// One component grid. Nodes: (cells[1] + 1) × (cells[0] + 1) row-major, direction 0 fastest. Cells: cells[1] ×
/// cells[0].
struct GridSnapshot {
  std::string name;
  Index<2> cells{};                                                 // {n, 1} for a 1D grid
  int dimension = 2;                                                // 1: a line or a strip a few cells wide; 2
  bool solid = false;                                               // of an elastic solid, otherwise of a fluid
  std::vector<double> x, y;                                         // node coordinates, non-dimensional
  std::vector<std::uint8_t> mask;                                   // per cell: 0 active, 1 fringe, 2 hole
  std::vector<std::pair<std::string, std::vector<double>>> fields;  // per cell: "density", "velocity_x", …

  std::size_t cell_count() const { return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]); }
  std::size_t node_count() const {
    return (static_cast<std::size_t>(cells[0]) + 1) * (static_cast<std::size_t>(cells[1]) + 1);
  }
  std::size_t cell(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(cells[0]) + static_cast<std::size_t>(i);
  }
  std::size_t node(int i, int j) const {
    return static_cast<std::size_t>(j) * (static_cast<std::size_t>(cells[0]) + 1) + static_cast<std::size_t>(i);
  }
  /// The field of that name, or nullptr.
  const std::vector<double>* field(const std::string& key) const {
    for (const auto& [label, values] : fields)
      if (label == key) return &values;
    return nullptr;
  }
};

/// All grids at one instant: those of the fluid, background first, then those of the solids.
struct Snapshot {
  double time = 0;
  int step = 0;
  std::vector<GridSnapshot> grids;
  std::vector<std::vector<Point<2>>> outlines;  // of rigid bodies now, closed polygons; 1D: the two ends (x, 0)
  std::vector<std::vector<Point<2>>> surfaces;  // closed polygons around solids whose cells do not end on them
  std::vector<std::vector<Point<2>>> contours;  // open lines that were straight in the undeformed solids
};

/// A 1D grid as a single row of cells: nodes at y = 0 and again at y = h, the mean cell width.
inline GridSnapshot line_grid(std::string name, const std::vector<double>& nodes) {
  GridSnapshot grid;
  const auto n = static_cast<int>(nodes.size()) - 1;
  grid.name = std::move(name);
  grid.cells = {n, 1};
  grid.dimension = 1;
  grid.x = nodes;
  grid.x.insert(grid.x.end(), nodes.begin(), nodes.end());
  grid.y.assign(2 * nodes.size(), 0.0);
  std::fill(grid.y.begin() + n + 1, grid.y.end(), std::fabs(nodes.back() - nodes.front()) / n);
  grid.mask.assign(static_cast<std::size_t>(n), mask_active);
  return grid;
}

}  // namespace mortise
