#include <array>
#include <cmath>
#include <sstream>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/body_grid.hpp"
#include "mortise/grids/geometry/grown_grid.hpp"

namespace mortise {

Point<2> GrownGrid::continued(int i, int j) const {
  if (periodic && (i < 0 || i >= along)) {
    const int turns = (i >= 0 ? i : i - along + 1) / along;
    return node(i - turns * along, j) + turns * period;
  }
  if (j < 0) return node(i, 0) + static_cast<double>(j) * (node(i, 1) - node(i, 0));
  if (j > layers) return node(i, layers) + static_cast<double>(j - layers) * (node(i, layers) - node(i, layers - 1));
  if (i < 0) return node(0, j) + static_cast<double>(i) * (node(1, j) - node(0, j));
  return node(along, j) + static_cast<double>(i - along) * (node(along, j) - node(along - 1, j));
}

Index<2> first_folded_cell(const GrownGrid& grid) {
  for (int j = 0; j < grid.layers; ++j)
    for (int i = 0; i < grid.along; ++i) {
      const Point<2> a = grid.node(i, j), b = grid.node(i + 1, j), c = grid.node(i + 1, j + 1), d = grid.node(i, j + 1);
      const Point<2> bottom = b - a, right = c - b, top = d - c, left = a - d;
      const std::array<double, 4> corner{cross(left, bottom), cross(bottom, right), cross(right, top), cross(top, left)};
      for (const double area : corner)
        if (!(area > 0) || !std::isfinite(area)) return {i, j};
    }
  return {-1, -1};
}

void require_unfolded(const GrownGrid& grid) {
  const Index<2> cell = first_folded_cell(grid);
  if (cell[0] < 0) return;
  std::ostringstream text;
  text << "cell (" << cell[0] << ", " << cell[1] << ") of a body grid is folded at (" << grid.node(cell[0], cell[1]).x()
       << ", " << grid.node(cell[0], cell[1]).y() << ")";
  throw NumericalError(text.str());
}

GrownGrid stretch_between(const std::vector<Point<2>>& near, const std::vector<Point<2>>& far, int layers,
                          double spacing, bool periodic, const Point<2>& period) {
  if (near.size() != far.size() || layers < 1)
    throw InputError("a grid between two curves needs equally many nodes on both and at least one layer");
  GrownGrid grid{.along = static_cast<int>(near.size()) - (periodic ? 0 : 1),
                 .layers = layers,
                 .spacing = spacing,
                 .nodes = {},
                 .periodic = periodic,
                 .period = period};
  grid.nodes.reserve(near.size() * static_cast<std::size_t>(layers + 1));
  for (int j = 0; j <= layers; ++j)
    for (std::size_t i = 0; i < near.size(); ++i) {
      const double t = static_cast<double>(j) / layers;
      grid.nodes.push_back((1 - t) * near[i] + t * far[i]);
    }
  for (std::size_t i = 0; i < near.size(); ++i)
    grid.thickness += (far[i] - near[i]).norm() / (layers * static_cast<double>(near.size()));
  require_unfolded(grid);
  return grid;
}

}  // namespace mortise
