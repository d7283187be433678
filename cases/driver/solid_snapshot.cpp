#include "mortise/cases/driver/solid_snapshot.hpp"

#include <array>

namespace mortise {
namespace {

/// The cells of a grid that hold data, and differences between them.
class Cells {
 public:
  Cells(const SolidGrid& grid, const Material& material) : grid_(grid) {
    for (const ElasticState& state : grid.states) displacements_.push_back(displacement_of(material, state));
  }

  /// Number of the cell, −1 where there is none or it is a hole.
  std::ptrdiff_t find(int i, int j) const {
    const int n = grid_.cells[0];
    if (grid_.periodic) i = (i + n) % n;
    if (i < 0 || i >= n || j < 0 || j >= grid_.cells[1]) return -1;
    const std::ptrdiff_t cell = static_cast<std::ptrdiff_t>(j) * n + i;
    return grid_.mask[static_cast<std::size_t>(cell)] == mask_hole ? -1 : cell;
  }

  const Point<2>& displacement(std::ptrdiff_t cell) const { return displacements_[static_cast<std::size_t>(cell)]; }

  /// Difference of u from one cell to the next along a direction.
  Point<2> difference(int i, int j, int direction) const {
    const int a = direction == 0 ? 1 : 0, b = 1 - a;
    const std::ptrdiff_t here = find(i, j), before = find(i - a, j - b), after = find(i + a, j + b);
    const int steps = (before >= 0) + (after >= 0);
    if (steps == 0) return Point<2>::Zero();
    return (displacement(after >= 0 ? after : here) - displacement(before >= 0 ? before : here)) / steps;
  }

 private:
  const SolidGrid& grid_;
  std::vector<Point<2>> displacements_;
};

/// u at node (i, j).
Point<2> node_displacement(const Cells& cells, int i, int j) {
  Point<2> sum = Point<2>::Zero();
  int count = 0;
  for (const int b : {j - 1, j})
    for (const int a : {i - 1, i}) {
      const std::ptrdiff_t cell = cells.find(a, b);
      if (cell < 0) continue;
      sum += cells.displacement(cell) + (i - a - 0.5) * cells.difference(a, b, 0) +
             (j - b - 0.5) * cells.difference(a, b, 1);
      ++count;
    }
  return count > 0 ? Point<2>(sum / count) : sum;
}

/// Mean of the four corners.
Point<2> cell_center(const GridSnapshot& grid, const std::vector<Point<2>>& nodes, std::size_t cell) {
  const auto n = static_cast<std::size_t>(grid.cells[0]), low = cell + cell / n, high = low + n + 1;
  return 0.25 * (nodes[low] + nodes[low + 1] + nodes[high] + nodes[high + 1]);
}

}  // namespace

std::array<double, solid_field_names.size()> solid_field_values(const Material& material, const Point<2>& X, const ElasticState& state) {
  const Point<2> u = displacement_of(material, state), v = velocity_of(state);
  const CauchyStress s = cauchy_stress_of(material, state);
  return {u.x(), u.y(), v.x(), v.y(), s.xx, s.xy, s.yy, s.von_mises(), jacobian_of(material, state), X.x(), X.y()};
}

std::vector<Point<2>> node_displacements(const SolidGrid& grid, const Material& material) {
  const Cells cells(grid, material);
  std::vector<Point<2>> all;
  for (int j = 0; j <= grid.cells[1]; ++j)
    for (int i = 0; i <= grid.cells[0]; ++i)
      all.push_back(node_displacement(cells, grid.periodic ? i % grid.cells[0] : i, j));
  return all;
}

GridSnapshot solid_snapshot(const SolidGrid& grid, const Material& material) {
  GridSnapshot out;
  out.name = grid.name;
  out.cells = grid.cells;
  out.solid = true;
  out.mask = grid.mask;
  const std::vector<Point<2>> displacements = node_displacements(grid, material);
  for (std::size_t k = 0; k < grid.nodes.size(); ++k) {
    out.x.push_back(grid.nodes[k].x() + displacements[k].x());
    out.y.push_back(grid.nodes[k].y() + displacements[k].y());
  }
  for (const char* name : solid_field_names) out.fields.emplace_back(name, std::vector<double>(out.cell_count(), 0.0));
  for (std::size_t c = 0; c < out.cell_count(); ++c) {
    const Point<2> X = cell_center(out, grid.nodes, c);
    const auto values = solid_field_values(material, X, grid.states[c]);
    const std::size_t first = grid.mask[c] == mask_hole ? values.size() - 2 : 0;  // holes have a place only
    for (std::size_t f = first; f < values.size(); ++f) out.fields[f].second[c] = values[f];
  }
  return out;
}

void place_first_layer(GridSnapshot& grid, std::span<const Point<2>> interface) {
  const auto n = static_cast<std::size_t>(grid.cells[0]);
  if (interface.size() != n && interface.size() != n + 1) return;
  for (std::size_t i = 0; i < interface.size(); ++i) {
    grid.x[i] = interface[i].x();
    grid.y[i] = interface[i].y();
  }
  if (interface.size() > n) return;  // open
  const std::size_t first = grid.node(0, 1), last = grid.node(grid.cells[0], 1);
  grid.x[n] = interface[0].x() + grid.x[last] - grid.x[first];
  grid.y[n] = interface[0].y() + grid.y[last] - grid.y[first];
}

}  // namespace mortise
