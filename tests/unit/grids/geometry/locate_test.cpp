#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {
namespace {

struct Body {
  Outline outline;
  BodyAtlas atlas;

  Body(const Outline& shape, double spacing, int layers)
      : outline(shape.centered()), atlas(outline, grow(outline, {.spacing = spacing, .layers = layers})) {}
};

Body stick() { return Body(Outline::rounded_rectangle(0.1, 0.5, 0.038), 0.0125, 10); }
Body ell() {
  return Body(Outline::rounded_polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.1), 0.025, 10);
}

Point<2> interpolated(const BodyAtlas& atlas, const StencilPoint& where) {
  const auto weights = [](double t) { return std::array<double, 3>{t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2}; };
  const auto along = weights(where.offset[0]), across = weights(where.offset[1]);
  Point<2> x = Point<2>::Zero();
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k)
      x += along[static_cast<std::size_t>(k)] * across[static_cast<std::size_t>(l)] *
           atlas.center(where.center[0] + k - 1, where.center[1] + l - 1);
  return x;
}

/// Random points of the grid: a point of each of `count` cells.
std::vector<Point<2>> points_on(const GrownGrid& grid, int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Point<2>> points;
  for (int n = 0; n < count; ++n) {
    const int i = static_cast<int>(part(random) * grid.along), j = static_cast<int>(part(random) * grid.layers);
    const double u = part(random), v = part(random);
    points.push_back((1 - v) * ((1 - u) * grid.node(i, j) + u * grid.node(i + 1, j)) +
                     v * ((1 - u) * grid.node(i, j + 1) + u * grid.node(i + 1, j + 1)));
  }
  return points;
}

TEST(Locate, CellCentersHaveTheirOwnIndices) {
  for (const Body& body : {stick(), ell()}) {
    const GrownGrid& grid = body.atlas.grid();
    for (int j = 0; j < grid.layers; ++j) {
      for (int i = 0; i < grid.along; ++i) {
        Point<2> logical;
        ASSERT_TRUE(body.atlas.locate(body.atlas.center(i, j), logical)) << i << ", " << j;
        ASSERT_LT((logical - Point<2>(i, j)).norm(), 1e-11) << i << ", " << j;
      }
    }
  }
}

TEST(Locate, InterpolationReproducesEveryPointOfTheGrid) {
  for (const Body& body : {stick(), ell(), Body(Outline::ellipse(0.7, 0.1), 0.02, 8)}) {
    const GrownGrid& grid = body.atlas.grid();
    for (const Point<2>& x : points_on(grid, 20000)) {
      StencilPoint where;
      ASSERT_TRUE(body.atlas.locate(x, where)) << x.transpose();
      ASSERT_LT((interpolated(body.atlas, where) - x).norm(), 1e-12 * grid.spacing) << x.transpose();
      ASSERT_TRUE(where.center[0] >= 0 && where.center[0] < grid.along);
      ASSERT_TRUE(where.center[1] >= 1 && where.center[1] <= grid.layers - 2);
      ASSERT_LE(std::abs(where.offset[0]), 0.75);
      Point<2> logical;
      body.atlas.locate(x, logical);
      ASSERT_TRUE(logical[0] >= -0.5 && logical[0] < grid.along - 0.5);
    }
  }
}

TEST(Locate, InvertsTheMapOfAStencil) {
  const Body body = stick();
  for (const Index<2>& middle : {Index<2>{0, 1}, Index<2>{20, 4}, Index<2>{91, 8}}) {
    const StencilPoint given{.center = middle, .offset = {0.3, -0.2}};
    StencilPoint found;
    ASSERT_TRUE(body.atlas.locate(interpolated(body.atlas, given), found));
    EXPECT_EQ(found.center, given.center);
    EXPECT_LT((found.offset - given.offset).norm(), 1e-11);
  }
}

TEST(Locate, PointsOfASymmetricBodyAreMirrored) {
  const Body body = stick();
  const int along = body.atlas.grid().along;
  for (const Point<2>& x : points_on(body.atlas.grid(), 1000)) {
    StencilPoint here, mirrored;
    ASSERT_TRUE(body.atlas.locate(x, here));
    ASSERT_TRUE(body.atlas.locate({x.x(), -x.y()}, mirrored));
    if (std::abs(here.offset[0]) > 0.49 || std::abs(here.offset[1]) > 0.49) continue;  // either stencil may serve
    EXPECT_EQ(mirrored.center, (Index<2>{along - 1 - here.center[0], here.center[1]}));
    EXPECT_LT((mirrored.offset - Point<2>(-here.offset[0], here.offset[1])).norm(), 1e-11);
  }
}

TEST(Locate, PointsOffTheGridAreRefused) {
  const Body body = stick();
  Point<2> logical;
  EXPECT_FALSE(body.atlas.locate({0, 0}, logical));
  EXPECT_FALSE(body.atlas.locate({0.04, 0}, logical)) << "inside the body";
  EXPECT_FALSE(body.atlas.locate({0.05 + 0.1275, 0.001}, logical)) << "beyond the last layer";
  EXPECT_FALSE(body.atlas.locate({100, 0}, logical)) << "outside the table";
  EXPECT_FALSE(body.atlas.locate({-1e300, 0}, logical));
  EXPECT_TRUE(body.atlas.locate({0.0501, 0}, logical));
  EXPECT_NEAR(logical[1], -0.5, 0.01);
}

TEST(LocateClamped, AgreesWithLocateOnTheGrid) {
  const Body body = stick();
  for (const Point<2>& x : points_on(body.atlas.grid(), 500)) {
    Point<2> exact, clamped;
    ASSERT_TRUE(body.atlas.locate(x, exact));
    ASSERT_TRUE(body.atlas.locate_clamped(x, clamped));
    EXPECT_EQ(exact, clamped);
  }
}

TEST(LocateClamped, PointsInsideTheBodyGoToTheFirstRow) {
  const Body body = stick();
  int served = 0;
  for (int k = 0; k < 2000; ++k) {
    const Point<2> x = body.outline.at(0.0005 * k) * 0.93;
    Point<2> plain;
    StencilPoint where;
    if (body.atlas.locate(x, plain)) continue;
    ASSERT_TRUE(body.atlas.locate_clamped(x, where)) << x.transpose();
    ASSERT_EQ(where.center[1] + where.offset[1], 0);
    const Point<2> nearest = interpolated(body.atlas, where);
    for (int i = 0; i < body.atlas.grid().along; ++i)
      ASSERT_LT((nearest - x).norm(), (body.atlas.center(i, 0) - x).norm() + 1e-3 * body.atlas.grid().spacing);
    ++served;
  }
  EXPECT_GT(served, 1000);
}

TEST(LocateClamped, DeepPointsAreRefused) {
  const Body body = stick();
  Point<2> logical;
  EXPECT_TRUE(body.atlas.locate_clamped({0.05 - 2.9 * 0.0125, 0.1}, logical));
  EXPECT_EQ(logical[1], 0);
  EXPECT_FALSE(body.atlas.locate_clamped({0.05 - 3.1 * 0.0125, 0.1}, logical));
  EXPECT_FALSE(body.atlas.locate_clamped({0.05 + 0.14, 0.1}, logical)) << "outside the grid";
}

}  // namespace
}  // namespace mortise
