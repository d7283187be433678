#include "mortise/coupler/reference_map/tile_window.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(TileWindow, CommonCellsAndTheSmallestAroundBoth) {
  const TileWindow a{{0, 0}, {4, 6}}, b{{2, -1}, {8, 3}}, far{{10, 10}, {12, 12}};
  EXPECT_EQ((a & b).low, (Index<2>{2, 0}));
  EXPECT_EQ((a & b).high, (Index<2>{4, 3}));
  EXPECT_EQ((a | b).low, (Index<2>{0, -1}));
  EXPECT_EQ((a | b).high, (Index<2>{8, 6}));
  EXPECT_TRUE((a & far).empty());
  EXPECT_EQ((TileWindow{} | a).high, a.high);
}

/// Cells near a corner of one tile are near cells of all four tiles around it, across periodic sides, too, and not
/// across others.
TEST(TileWindow, WindowsReachIntoNeighboursAndTheirGhosts) {
  for (const bool periodic : {false, true}) {
    const ComponentGrid<2> grid("grid", Communicator(), {32, 32}, {periodic, periodic}, TileShape<2>({16, 16}));
    std::vector<TileWindow> boxes(4);
    int corner = -1, opposite = -1;
    for (int t = 0; t < 4; ++t) {
      if (grid.first_cell(t) == Index<2>{0, 0}) corner = t;
      if (grid.first_cell(t) == Index<2>{16, 16}) opposite = t;
    }
    boxes[static_cast<std::size_t>(corner)] = {{1, 2}, {3, 4}};
    const std::vector<TileWindow> windows = windows_around(grid, boxes, 5);
    const TileWindow own = windows[static_cast<std::size_t>(corner)],
                     other = windows[static_cast<std::size_t>(opposite)];
    EXPECT_EQ(own.low, (Index<2>{-2, -2}));
    EXPECT_EQ(own.high, (Index<2>{8, 9}));
    EXPECT_EQ(other.empty(), !periodic);
    if (!periodic) continue;
    EXPECT_EQ(other.low, (Index<2>{12, 13}));
    EXPECT_EQ(other.high, (Index<2>{18, 18}));
  }
}

}  // namespace
}  // namespace mortise
