#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

void expect_mirrored(const GrownGrid& grid) {
  double about_x = 0, about_y = 0;
  for (int j = 0; j <= grid.layers; ++j) {
    for (int i = 0; i < grid.along; ++i) {
      const Point<2> x = grid.node(i, j), below = grid.node(-i, j), left = grid.node(grid.along / 2 - i, j);
      about_x = std::max(about_x, (below - Point<2>(x.x(), -x.y())).norm());
      about_y = std::max(about_y, (left - Point<2>(-x.x(), x.y())).norm());
    }
  }
  EXPECT_LT(about_x, 1e-13);
  EXPECT_LT(about_y, 1e-13);
}

TEST(Growth, CircleGivesConcentricCircles) {
  const GrownGrid grid = grow(Outline::circle(0.5), {.spacing = 0.02, .layers = 12});
  EXPECT_EQ(grid.along, 156);  // the multiple of 4 nearest to π/0.02 = 157.08
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i < grid.along; ++i) ASSERT_NEAR(grid.node(i, j).norm(), 0.5 + 0.02 * j, 1e-12) << i << ", " << j;
  EXPECT_NEAR(std::atan2(grid.node(1, 12).y(), grid.node(1, 12).x()), -2 * pi / 156, 1e-12) << "clockwise";
}

TEST(Growth, GridsOfSymmetricOutlinesAreSymmetric) {
  expect_mirrored(grow(Outline::circle(0.5), {.spacing = 0.03, .layers = 10}));
  expect_mirrored(grow(Outline::ellipse(0.7, 0.35), {.spacing = 0.0125, .layers = 10}));
  expect_mirrored(grow(Outline::rounded_rectangle(0.1, 0.5, 0.038).centered(), {.spacing = 0.0125, .layers = 10}));
}

TEST(Growth, ConvexOutlinesGetLayersOfTheSpacing) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038).centered();
  for (const auto& [spacing, tolerance] : {std::pair(0.0125, 0.011), std::pair(0.00625, 0.003)}) {
    const GrownGrid grid = grow(stick, {.spacing = spacing, .layers = 10});
    for (int j = 1; j <= grid.layers; ++j)
      for (int i = 0; i < grid.along; ++i)
        ASSERT_NEAR(stick.tree().nearest(grid.node(i, j)).distance, spacing * j, tolerance * spacing * j);
  }
}

TEST(Growth, FirstRowIsEquallySpacedOnTheOutline) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  const GrownGrid grid = grow(stick, {.spacing = 0.0125, .layers = 4});
  for (int i = 0; i < grid.along; ++i) EXPECT_EQ(grid.node(i, 0), stick.at(-stick.perimeter() * i / grid.along));
  EXPECT_EQ(grid.along % 4, 0);
  EXPECT_LE(std::abs(grid.along - stick.perimeter() / 0.0125), 2);
}

TEST(Growth, CoarseSpacingsKeepSixteenCells) {
  EXPECT_EQ(grow(Outline::circle(0.0625), {.spacing = 0.1, .layers = 3}).along, 16);
}

TEST(Growth, ConcaveOutlinesGiveGoodGrids) {
  std::vector<Point<2>> star, bean;
  for (int k = 0; k < 10; ++k)
    star.emplace_back((k % 2 ? 0.4 : 1) * Point<2>(std::cos(pi * k / 5), std::sin(pi * k / 5)));
  for (int k = 0; k < 40; ++k) {
    const double angle = pi * k / 20, radius = 0.5 + 0.2 * std::cos(2 * angle) + 0.1 * std::cos(angle);
    bean.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const std::vector<Point<2>> ell{{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
  for (const Outline& outline : {Outline::rounded_polygon(star, 0.05), Outline::spline(bean),
                                 Outline::rounded_polygon(ell, 0.1), Outline::rounded_polygon(ell, 0.03)}) {
    const GrownGrid grid = grow(outline, {.spacing = 0.025, .layers = 10});
    const GridQuality quality = check(grid);
    EXPECT_GT(quality.min_corner_ratio, 0.5);
    EXPECT_GT(quality.min_size, 0.4 * 0.025);
    EXPECT_LT(quality.max_aspect, 4);
    for (int i = 0; i < grid.along; ++i) EXPECT_GT(outline.tree().nearest(grid.node(i, 10)).distance, 0.9 * 0.25);
  }
}

RC_GTEST_PROP(Growth, NoCellIsEverFolded, ()) {
  const auto waves = *rc::gen::inRange(2, 6);
  const double depth = *rc::gen::inRange(0, 60) / 100.0, phase = *rc::gen::inRange(0, 100) / 100.0;
  std::vector<Point<2>> points;
  for (int k = 0; k < 60; ++k) {
    const double angle = 2 * pi * k / 60, radius = 1 + depth * std::cos(waves * angle + phase) + 0.1 * std::sin(angle);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  try {
    const GrownGrid grid = grow(Outline::spline(points), {.spacing = 0.04, .layers = 10});
    RC_ASSERT(check(grid).min_corner_ratio > 0);
  } catch (const InputError&) {
    RC_ASSERT(depth > 0.4);
  }
}

TEST(Growth, AGridThatMeetsItselfIsRefused) {
  // A C whose mouth is narrower than two grids.
  const Outline c =
      Outline::rounded_polygon({{0, 0}, {1, 0}, {1, .4}, {.3, .4}, {.3, .6}, {1, .6}, {1, 1}, {0, 1}}, 0.05);
  EXPECT_THROW(grow(c, {.spacing = 0.02, .layers = 10}), InputError);
  EXPECT_NO_THROW(grow(c, {.spacing = 0.02, .layers = 3}));
}

TEST(Growth, WrongOptionsAreRefused) {
  EXPECT_THROW(grow(Outline::circle(1), {.spacing = 0, .layers = 5}), InputError);
  EXPECT_THROW(grow(Outline::circle(1), {.spacing = 0.1, .layers = 2}), InputError);
}

TEST(GridQuality, MeasuresARing) {
  GrownGrid ring{.along = 4, .layers = 1, .spacing = 1, .nodes = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
  for (int i = 0; i < 4; ++i) ring.nodes.push_back(2 * ring.node(i, 0));
  // Each cell: a trapezoid with parallel sides √2 and 2√2, legs 1, area 3/2; inner corner triangles ½, outer 1.
  const GridQuality quality = check(ring);
  EXPECT_NEAR(quality.min_corner_ratio, 2.0 / 3, 1e-15);
  EXPECT_NEAR(quality.max_aspect, 1.5 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(quality.min_size, 1.5 / std::sqrt(8.0), 1e-15);
  std::swap(ring.nodes[4], ring.nodes[5]);
  EXPECT_LE(check(ring).min_corner_ratio, 0);
}

}  // namespace
}  // namespace mortise
