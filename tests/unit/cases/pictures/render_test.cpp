#include "mortise/cases/pictures/render.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "example_scene.hpp"
#include "mortise/cases/pictures/axes.hpp"
#include "mortise/cases/pictures/colormap.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

bool grey(Rgb c) { return c.red == c.green && c.green == c.blue; }

using test::pixel;

RenderOptions options(const std::string& field) {
  RenderOptions result;
  result.field = field;
  result.width = 600;
  return result;
}

bool same(const Image& a, const Image& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (!(a.at(x, y) == b.at(x, y))) return false;
  return true;
}

TEST(Render, ColoursFollowTheValues) {
  const Snapshot snapshot = test::scene("pressure", [](double x, double) { return 10 + x; });
  RenderOptions chosen = options("pressure");
  chosen.range = {{8, 12}};
  const Image image = render(snapshot, chosen);
  for (const double x : {-1.7, -0.8, 0.9, 1.8}) {
    const Rgb seen = pixel(image, x, 0.9), expected = color_at(sequential_map(), (x + 2) / 4);
    EXPECT_NEAR(seen.red, expected.red, 6) << x;
    EXPECT_NEAR(seen.green, expected.green, 6) << x;
    EXPECT_NEAR(seen.blue, expected.blue, 6) << x;
  }
  EXPECT_EQ(pixel(image, 0, 0), ink::body);
}

TEST(Render, ValuesOfBothSignsAreNeutralAtZero) {
  const Image image = render(test::scene("velocity_y", [](double, double y) { return y; }), options("velocity_y"));
  const Rgb zero = pixel(image, 1.5, 0), up = pixel(image, 1.5, 1.4), down = pixel(image, 1.5, -1.4);
  EXPECT_LE(std::abs(zero.red - zero.blue), 12);
  EXPECT_GT(up.red, up.blue + 60);
  EXPECT_GT(down.blue, down.red + 60);
}

TEST(Render, SchlierenAreDarkWhereDensityJumps) {
  const Image image =
      render(test::scene("density", [](double x, double) { return x < -1 ? 1.0 : 2.7; }), options("schlieren"));
  EXPECT_LT(pixel(image, -1, 0.7, false).red, 40);
  EXPECT_EQ(pixel(image, -1.6, 0.7, false), white);
  EXPECT_EQ(pixel(image, 1.2, -0.7, false), white);
}

TEST(Render, SmoothFieldsShowNoSeamBetweenGrids) {
  const Snapshot snapshot = test::scene("pressure", [](double x, double y) { return 3 + std::sin(x) + 0.5 * y; });
  const Image image = render(snapshot, options("pressure"));
  int steepest = 0;
  for (double radius = 0.56; radius < 1.2; radius += 0.01)
    for (int k = 0; k < 360; ++k) {
      const double a = 2 * std::numbers::pi * k / 360;
      const Rgb inner = pixel(image, radius * std::cos(a), radius * std::sin(a)),
                outer = pixel(image, (radius + 0.01) * std::cos(a), (radius + 0.01) * std::sin(a));
      steepest = std::max({steepest, std::abs(inner.red - outer.red), std::abs(inner.green - outer.green),
                           std::abs(inner.blue - outer.blue)});
    }
  EXPECT_LE(steepest, 8);
}

TEST(Render, IsReproducibleAndEvenSized) {
  const Snapshot snapshot = test::scene("density", [](double x, double y) { return 1 + x * y; });
  for (const char* field : {"schlieren", "density", "grids"}) {
    RenderOptions chosen = options(field);
    chosen.width = 501;
    const Image image = render(snapshot, chosen);
    EXPECT_EQ(image.width(), 500);
    EXPECT_EQ(image.height() % 2, 0);
    EXPECT_TRUE(same(image, render(snapshot, chosen))) << field;
  }
}

TEST(Render, WindowZoomsIn) {
  const Snapshot snapshot = test::scene("pressure", [](double x, double) { return x; });
  RenderOptions chosen = options("pressure");
  chosen.window = {{-0.2, -0.2}, {0.2, 0.1}};  // inside the body
  const Image image = render(snapshot, chosen);
  EXPECT_EQ(image.at(200, 100), ink::body);
  EXPECT_EQ(image.at(400, 300), ink::body);
}

TEST(Render, GridsLeaveHolesEmptyAndColourBodyGrids) {
  const Image image = render(test::scene("density", [](double, double) { return 1.0; }), options("grids"));
  int coloured = 0;
  for (int k = 0; k < 720; ++k) {
    const double a = 2 * std::numbers::pi * k / 720;
    for (const double radius : {0.52, 0.6, 0.7}) {
      const Rgb c = pixel(image, radius * std::cos(a), radius * std::sin(a), false);
      coloured += c.red > c.blue + 40 ? 1 : 0;
    }
  }
  EXPECT_GT(coloured, 500);
  EXPECT_EQ(pixel(image, 0, 0, false), ink::body);
}

TEST(Render, UniformFieldsAndUnknownFields) {
  const Snapshot snapshot = test::scene("pressure", [](double, double) { return 1.0; });
  EXPECT_EQ(pixel(render(snapshot, options("pressure")), 1.5, 1.0), sequential_map().front());
  EXPECT_THROW(render(snapshot, options("temperature")), InputError);
}

TEST(Render, OneDimensionIsCurvesWithBodiesShaded) {
  Snapshot snapshot;
  std::vector<double> nodes;
  for (int i = 0; i <= 50; ++i) nodes.push_back(-1 + 0.04 * i);
  snapshot.grids = {line_grid("line", nodes)};
  GridSnapshot& grid = snapshot.grids[0];
  for (std::size_t c = 0; c < 50; ++c)
    if (nodes[c] > 0.19 && nodes[c] < 0.39) grid.mask[c] = mask_hole;
  for (const char* name : {"density", "velocity_x", "pressure"})
    test::fill_field(grid, name, [](double x, double) { return x < 0 ? 2.0 : 1.0; });
  snapshot.outlines = {{Point<2>(0.2, 0), Point<2>(0.4, 0)}};
  const Image image = render(snapshot, options("schlieren"));
  const double left = 49, right = 588;  // of the panels, at this width
  const auto column = [&](double x) { return static_cast<int>(left + (x + 1) / 2 * (right - left)); };
  EXPECT_EQ(image.at(column(0.3), 60), ink::body);
  const auto curve_row = [&](double x) {
    for (int y = 24; y < 138; ++y)
      if (const Rgb c = image.at(column(x), y); !grey(c) && c.blue > c.red + 60) return y;
    return -1;
  };
  EXPECT_GT(curve_row(-0.5), 0);
  EXPECT_GT(curve_row(0.7), curve_row(-0.5) + 80);  // 1 lies below 2
  EXPECT_EQ(curve_row(0.3), -1);                    // nothing of the hole's values
}

}  // namespace
}  // namespace mortise
