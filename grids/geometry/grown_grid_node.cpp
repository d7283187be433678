#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {

Point<2> GrownGrid::node(int i, int j) const {
  if (j < 0) return node(i, 0) + static_cast<double>(j) * (node(i, 1) - node(i, 0));
  if (j > layers) return node(i, layers) + static_cast<double>(j - layers) * (node(i, layers) - node(i, layers - 1));
  if (!periodic && i < 0) return node(0, j) + static_cast<double>(i) * (node(1, j) - node(0, j));
  if (!periodic && i > along) return node(along, j) + static_cast<double>(i - along) * (node(along, j) - node(along - 1, j));
  if (!periodic) return nodes[static_cast<std::size_t>(j * row() + i)];
  const int k = (i % along + along) % along;
  return nodes[static_cast<std::size_t>(j * along + k)] + static_cast<double>((i - k) / along) * period;
}

}  // namespace mortise
