#include "mortise/grids/geometry/find_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

GrownGrid ring(int along, int layers) {
  GrownGrid grid{.along = along, .layers = layers, .spacing = 1.0 / layers, .nodes = {}};
  for (int j = 0; j <= layers; ++j)
    for (int i = 0; i < along; ++i) {
      const double angle = -2 * std::numbers::pi * i / along, radius = 1 + static_cast<double>(j) / layers;
      grid.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  return grid;
}

TEST(FindCell, InvertsTheBilinearMap) {
  const GrownGrid grid = ring(24, 5);
  for (const Index<2>& cell : {Index<2>{0, 0}, Index<2>{23, 4}, Index<2>{11, 2}})
    for (const Point<2>& within : {Point<2>(0.5, 0.5), Point<2>(0.1, 0.7), Point<2>(0.99, 0.02)}) {
      const auto [i, j] = cell;
      const Point<2> low = (1 - within[0]) * grid.node(i, j) + within[0] * grid.node(i + 1, j);
      const Point<2> high = (1 - within[0]) * grid.node(i, j + 1) + within[0] * grid.node(i + 1, j + 1);
      CellPoint found;
      ASSERT_TRUE(find_cell(grid, (1 - within[1]) * low + within[1] * high, found));
      EXPECT_EQ(found.cell, cell);
      EXPECT_LE((found.within - within).norm(), 1e-12);
    }
}

TEST(FindCell, FindsNothingOutside) {
  CellPoint found;
  EXPECT_FALSE(find_cell(ring(24, 5), Point<2>(0, 0), found));
  EXPECT_FALSE(find_cell(ring(24, 5), Point<2>(2.1, 0), found));
}

}  // namespace
}  // namespace mortise
