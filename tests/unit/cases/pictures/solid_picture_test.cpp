#include <gtest/gtest.h>

#include <cmath>

#include "mortise/cases/pictures/axes.hpp"
#include "mortise/cases/pictures/colormap.hpp"
#include "mortise/cases/pictures/picture_values.hpp"
#include "mortise/cases/pictures/render.hpp"
#include "mortise/grids/core/error.hpp"
#include "solid_scene.hpp"

namespace mortise {
namespace {

using test::pixel;

Image rendered(const Snapshot& snapshot, const std::string& field) {
  RenderOptions options;
  options.field = field;
  options.width = 600;
  return render(snapshot, options);
}

void expect_near(Rgb seen, Rgb expected, const std::string& where) {
  EXPECT_NEAR(seen.red, expected.red, 8) << where;
  EXPECT_NEAR(seen.green, expected.green, 8) << where;
  EXPECT_NEAR(seen.blue, expected.blue, 8) << where;
}

/// Colour of the von Mises stress 1 + x at a place of the disk.
Rgb stress_color(double x) { return color_at(stress_map(), (1 + x) / 1.4752); }

TEST(SolidPicture, StressesAreShownOverTheGas) {
  const Snapshot gas = test::elastic_scene("density", [](double x, double) { return x < -1 ? 1.0 : 2.7; });
  for (const char* field : {"schlieren", "density", "stress"}) {
    const Image image = rendered(gas, field);
    for (const double x : {-0.43, -0.2, 0.0, 0.2, 0.43})
      expect_near(pixel(image, x, 0.02), stress_color(x), std::string(field) + " " + std::to_string(x));
  }
  const Rgb shock = pixel(rendered(gas, "schlieren"), -1, 0.7), faint = pixel(rendered(gas, "stress"), -1, 0.7);
  EXPECT_LT(shock.red, 40);
  EXPECT_GT(faint.red, 150);
  EXPECT_LT(faint.red, 220);
}

TEST(SolidPicture, OutlineIsDrawnOnceAround) {
  Snapshot snapshot = test::elastic_scene("density", [](double, double) { return 1.0; });
  for (GridSnapshot& grid : snapshot.grids)
    for (auto& [name, values] : grid.fields)
      if (name == "von_mises") std::fill(values.begin(), values.end(), 0.0);  // pale
  const Image image = rendered(snapshot, "stress");
  const auto darkest = [&](double radius, double angle) {
    int least = 255;
    for (double r = radius - 0.01; r < radius + 0.01; r += 0.002)
      least = std::min<int>(least, pixel(image, r * std::cos(angle), r * std::sin(angle)).green);
    return least;
  };
  for (int k = 0; k < 24; ++k) {
    EXPECT_LT(darkest(test::scene_radius, 0.26 * k), 190) << k;
    EXPECT_GT(darkest(0.32, 0.26 * k), 230) << k;  // no edge where the core ends
  }
}

TEST(SolidPicture, AFieldOfBothDomainsHasOneScale) {
  const Snapshot snapshot = test::elastic_scene("velocity_x", [](double x, double) { return x; });
  const Image image = rendered(snapshot, "velocity_x");
  for (const double x : {-1.5, -0.3, 0.3, 1.5})
    expect_near(pixel(image, x, 0.02), color_at(diverging_map(), 0.5 + 0.5 * x / 1.975), std::to_string(x));
}

TEST(SolidPicture, ASolidAlone) {
  Snapshot snapshot = test::elastic_scene("density", [](double, double) { return 1.0; });
  snapshot.grids.erase(snapshot.grids.begin(), snapshot.grids.begin() + 2);
  const Image image = rendered(snapshot, "stress");
  const int left = 33, right = 600 - 52;
  EXPECT_NEAR(image.at(left + 4, 28).red, 255, 1);  // outside the disk, inside its box
  expect_near(image.at((left + right) / 2, 22 + (right - left) / 2 + 8), stress_color(0), "middle");
  EXPECT_NO_THROW(rendered(snapshot, "velocity"));
  EXPECT_NO_THROW(rendered(snapshot, "grids"));
  EXPECT_THROW(rendered(snapshot, "schlieren"), InputError);
}

TEST(SolidPicture, RoundOffHasNoColours) {
  Snapshot snapshot = test::elastic_scene("density", [](double, double) { return 1.0; });
  for (GridSnapshot& grid : snapshot.grids)
    for (auto& [name, values] : grid.fields)
      if (name == "von_mises")
        for (double& value : values) value = 1e-16 * std::fabs(std::sin(1e4 * value));
  EXPECT_EQ(pixel(rendered(snapshot, "stress"), 0.1, 0.1), stress_map().front());
}

TEST(SolidPicture, StripsAreCurvesAlongThem) {
  for (const Point<2>& along : {Point<2>(1, 0), Point<2>(0, 1), Point<2>(std::sqrt(0.5), std::sqrt(0.5))}) {
    const Snapshot snapshot = test::strip(along, 40);
    const Image image = rendered(snapshot, "schlieren");
    const double left = 49, right = 588;  // of the panels, at this width
    const auto column = [&](double s) { return static_cast<int>(left + (s + 1) / 2 * (right - left)); };
    const auto row_of = [&](double s, int panel, bool solid) {
      const int top = 22 + panel * 125;
      for (int y = top + 2; y < top + 114; ++y) {
        const Rgb c = image.at(column(s), y);
        if (solid ? c.red > c.blue + 100 : c.blue > c.red + 60) return y - top;
      }
      return -1;
    };
    EXPECT_EQ(row_of(-0.5, 0, true), -1);  // no density of the solid
    EXPECT_LT(image.at(column(-0.5), 40).blue, image.at(column(0.5), 120).blue - 10);  // which is shaded
    EXPECT_GT(row_of(0.5, 0, false), 0);
    EXPECT_GT(row_of(-0.5, 1, true), row_of(0.5, 1, false) + 30);  // the velocity rises through both
    EXPECT_GT(row_of(0.5, 2, false), 0);
    EXPECT_GT(row_of(0.9, 2, false), row_of(0.1, 2, false) + 30);    // the pressure falls in the gas
    EXPECT_GT(row_of(-0.9, 2, true), row_of(-0.1, 2, true) + 20);    // and −σ rises in the solid
    EXPECT_NEAR(row_of(-0.02, 2, true), row_of(0.02, 2, false), 6);  // they meet
  }
}

TEST(SolidPicture, AStripOfASolidAlone) {
  Snapshot snapshot = test::strip({1, 0}, 30);
  snapshot.grids.erase(snapshot.grids.begin());
  EXPECT_NEAR(rendered(snapshot, "stress").height(), rendered(test::strip({1, 0}, 30), "stress").height() - 125, 1);
}

}  // namespace
}  // namespace mortise
