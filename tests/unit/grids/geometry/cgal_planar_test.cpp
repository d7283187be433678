#include "mortise/grids/geometry/cgal_planar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace mortise {
namespace {

using Points = std::vector<Point<2>>;

TEST(CgalPlanar, TellsSimpleFromCrossingPolygons) {
  EXPECT_TRUE(is_simple_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(is_simple_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}})) << "touches itself at (1, 0)";
}

TEST(CgalPlanar, TellsTheOrientation) {
  EXPECT_TRUE(is_counter_clockwise({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(is_counter_clockwise({{0, 0}, {0, 1}, {1, 0}}));
}

TEST(CgalPlanar, DelaunayEdgesOfAKite) {
  // The short diagonal (1, 3) is Delaunay, the long one (0, 2) is not.
  std::set<std::pair<int, int>> edges;
  for (auto [a, b] : delaunay_edges(Points{{-2, 0}, {0, -0.5}, {2, 0}, {0, 0.5}})) edges.insert(std::minmax(a, b));
  EXPECT_EQ(edges, (std::set<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {1, 3}}));
}

TEST(CgalPlanar, CoincidentPointsArePaired) {
  const auto edges = delaunay_edges(Points{{0, 0}, {1, 0}, {0, 1}, {1, 0}});
  EXPECT_EQ(std::count(edges.begin(), edges.end(), std::pair(1, 3)), 1);
}

}  // namespace
}  // namespace mortise
