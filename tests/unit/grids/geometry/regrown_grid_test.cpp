// Grids that are grown inward, grown again around a curve that has moved, or stretched between two curves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/body_grid.hpp"

namespace mortise {
namespace {

using Curve = std::vector<Point<2>>;

Curve first_layer(const GrownGrid& grid) { return Curve(grid.nodes.begin(), grid.nodes.begin() + grid.row()); }

TEST(InwardGrid, CirclesGiveConcentricCircles) {
  const GrownGrid grid = grow(Outline::circle(0.5), {.spacing = 0.02, .layers = 10, .inward = true});
  EXPECT_EQ(grid.along, 156);
  EXPECT_EQ(grid.thickness, 0.02);
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i < grid.along; ++i) {
      const Point<2> x = grid.node(i, j);
      ASSERT_NEAR(x.norm(), grid.node(0, j).norm(), 1e-12) << i << ", " << j;
      ASSERT_NEAR(x.norm(), 0.5 - 0.02 * j, 0.02 * 0.02 * j + 1e-12) << i << ", " << j;
      const double angle = 2 * std::numbers::pi * i / 156;
      ASSERT_NEAR(x.dot(Point<2>(std::cos(angle), std::sin(angle))), x.norm(), 1e-12) << "counter-clockwise";
    }
}

TEST(InwardGrid, ThinSticksKeepACoreAndGoodCells) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  for (const double spacing : {0.0125, 0.00625})
    for (const int layers : {3, 4, 5, 6}) {
      const GrownGrid grid = grow(stick, {.spacing = spacing, .layers = layers, .inward = true});
      EXPECT_LE(layers * grid.thickness, 0.8 * 0.05 + 1e-9);
      const GridQuality quality = check(grid);
      EXPECT_GT(quality.min_corner_ratio, 0.65) << spacing << ' ' << layers;
      EXPECT_GT(quality.min_size, 0.25 * spacing) << spacing << ' ' << layers;
      EXPECT_LT(quality.max_aspect, 3.1) << spacing << ' ' << layers;
      for (int i = 0; i < grid.along; ++i) EXPECT_LT(stick.tree().nearest(grid.node(i, layers)).distance, -0.7 * layers * grid.thickness);
    }
}

TEST(RegrownGrid, IsTheGridItCameFrom) {
  const Outline outline = Outline::rounded_polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.08);
  for (const bool inward : {false, true}) {
    const GrowthOptions options{.spacing = 0.02, .layers = 5, .inward = inward};
    const GrownGrid grid = grow(outline, options);
    const GrownGrid again = grow_from(first_layer(grid), options, grid.smoothing);
    EXPECT_EQ(again.nodes, grid.nodes);
    EXPECT_EQ(again.thickness, grid.thickness);
  }
}

TEST(RegrownGrid, NamesTheFoldedCell) {
  Curve curve = first_layer(grow(Outline::circle(0.5), {.spacing = 0.05, .layers = 4}));
  std::swap(curve[7], curve[8]);
  try {
    grow_from(curve, {.spacing = 0.05, .layers = 4}, 2);
    FAIL();
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("folded at ("), std::string::npos) << error.what();
  }
}

TEST(GrownGrid, NodesContinueInAllDirections) {
  Curve near, far;
  for (int i = 0; i < 4; ++i) {
    near.push_back({1.0 * i, 0.1 * i});
    far.push_back({1.0 * i, 0.1 * i + 2});
  }
  const GrownGrid open = stretch_between(near, far, 4, 1, false);
  EXPECT_EQ(open.along, 3);
  EXPECT_EQ(open.thickness, 0.5);
  const GrownGrid channel = stretch_between(near, far, 4, 1, true, {4, 0.4});
  EXPECT_EQ(channel.along, 4);
  for (int j = -3; j < 8; ++j)
    for (int i = -9; i < 13; ++i) {
      const Point<2> expected(i, 0.1 * i + 0.5 * j);
      EXPECT_LT((open.node(i, j) - expected).norm(), 1e-13) << i << ' ' << j;
      EXPECT_LT((channel.node(i, j) - expected).norm(), 1e-13) << i << ' ' << j;
    }
  std::swap(near[1], near[2]);
  EXPECT_THROW(stretch_between(near, far, 4, 1, false), NumericalError);
  EXPECT_THROW(stretch_between(near, {far[0], far[1]}, 4, 1, false), InputError);
}

TEST(GrownGrid, FirstFoldedCell) {
  GrownGrid grid = grow(Outline::circle(0.5), {.spacing = 0.05, .layers = 4});
  EXPECT_EQ(first_folded_cell(grid), (Index<2>{-1, -1}));
  grid.nodes[static_cast<std::size_t>(3 * grid.along + 9)] *= 1.15;
  EXPECT_EQ(first_folded_cell(grid), (Index<2>{8, 3})) << "the node is beyond the layer outside it";
  grid.nodes[5] = Point<2>::Constant(std::nan(""));
  EXPECT_EQ(first_folded_cell(grid), (Index<2>{4, 0}));
}

/// The atlas of a grid alone against that of its outline: distances differ where layers are thicker or lines slant.
void expect_same_answers(const Outline& outline, const GrowthOptions& options, double tolerance) {
  const GrownGrid grid = grow(outline, options);
  const BodyAtlas exact(outline, grid, options.inward), fast(grid, options.inward);
  const double h = options.spacing, sign = options.inward ? -1 : 1;
  const Box<2> box = fast.vicinity().grown(2 * h);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  int on_grid = 0;
  for (int k = 0; k < 5000; ++k) {
    const Point<2> part(uniform(random), uniform(random));
    const Point<2> X = box.low + part.cwiseProduct(box.high - box.low);
    const double distance = sign * outline.tree().nearest(X).distance;
    if (std::abs(distance) > h / 10) {
      ASSERT_EQ(fast.distance(X) > 0, distance > 0) << X.transpose() << ' ' << distance;
      ASSERT_EQ(exact.distance(X) > 0, distance > 0) << X.transpose() << ' ' << distance;
    }
    if (distance > 1.1 * fast.width()) {
      ASSERT_GT(fast.distance(X), fast.width() * 0.9);
    }
    StencilPoint here, there;
    const bool found = exact.locate(X, here);
    ASSERT_EQ(fast.locate(X, there), found) << X.transpose();
    if (!found) continue;
    ++on_grid;
    ASSERT_EQ(here.center, there.center);
    ASSERT_LT((here.offset - there.offset).norm(), 1e-10);
    ASSERT_NEAR(fast.distance(X), distance, tolerance * h) << X.transpose();
  }
  EXPECT_GT(on_grid, 250);
}

TEST(FastAtlas, AnswersAsTheExactOne) {
  for (const bool inward : {false, true}) {
    SCOPED_TRACE(inward);
    expect_same_answers(Outline::circle(0.5), {.spacing = 0.02, .layers = 8, .inward = inward}, 0.15);
    expect_same_answers(Outline::ellipse(0.5, 0.3), {.spacing = 0.02, .layers = 6, .inward = inward}, 1.5);
    expect_same_answers(Outline::rounded_rectangle(0.3, 0.5, 0.1), {.spacing = 0.02, .layers = 5, .inward = inward}, 1.5);
  }
  expect_same_answers(Outline::rounded_rectangle(0.1, 0.5, 0.038), {.spacing = 0.0125, .layers = 8}, 0.5);
  expect_same_answers(Outline::rounded_polygon({{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}}, 0.08),
                      {.spacing = 0.02, .layers = 8}, 2);
}

TEST(FastAtlas, InwardBodiesAreBoundless) {
  const GrownGrid grid = grow(Outline::circle(0.5), {.spacing = 0.02, .layers = 8, .inward = true});
  const BodyAtlas atlas(grid, true);
  EXPECT_TRUE(atlas.reach().contains(Point<2>(1e6, -1e6)));
  EXPECT_LT(atlas.distance({1e6, -1e6}), 0);
  EXPECT_GT(atlas.distance({0, 0}), atlas.width());
  EXPECT_TRUE(atlas.near_grid({{0.4, -0.1}, {0.45, 0.1}}));
  EXPECT_FALSE(atlas.near_grid({{-0.05, -0.05}, {0.05, 0.05}}));
  EXPECT_FALSE(atlas.near_grid({{2, 2}, {3, 3}}));
}

}  // namespace
}  // namespace mortise
