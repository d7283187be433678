#include "mortise/cases/pictures/picture_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "example_scene.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

TEST(PictureValues, GradientOfALinearFieldIsExactOnAnyGrid) {
  Snapshot snapshot = test::scene("density", [](double x, double y) { return 2 + 0.3 * x - 0.4 * y; });
  GridSnapshot& skewed = snapshot.grids[0];  // no longer Cartesian
  skewed.fields.clear();
  for (std::size_t k = 0; k < skewed.x.size(); ++k) {
    skewed.x[k] += 0.02 * std::sin(7 * skewed.y[k]);
    skewed.y[k] += 0.4 * skewed.x[k];
  }
  test::fill_field(skewed, "density", [](double x, double y) { return 2 + 0.3 * x - 0.4 * y; });
  const PictureValues values = picture_values(snapshot, "schlieren");
  int holes = 0, cells = 0;
  for (std::size_t g = 0; g < 2; ++g)
    for (std::size_t c = 0; c < values[g].size(); ++c) {
      const bool hole = snapshot.grids[g].mask[c] == mask_hole;
      (hole ? holes : cells)++;
      if (hole)
        EXPECT_TRUE(std::isnan(values[g][c]));
      else
        EXPECT_NEAR(values[g][c], 0.5, 1e-11) << g << ' ' << c;
    }
  EXPECT_GT(holes, 300);
  EXPECT_GT(cells, 4000);
}

TEST(PictureValues, GradientIsSecondOrderOnTheClosedAnnulus) {
  const auto density = [](double x, double y) { return std::sin(2 * x) * std::cos(y); };
  const Snapshot snapshot = test::scene("density", density);
  const PictureValues values = picture_values(snapshot, "schlieren");
  const GridSnapshot& grid = snapshot.grids[1];
  for (int j = 1; j < 7; ++j)
    for (const int i : {0, 17, 71}) {  // the first and last column are neighbours
      const double angle = -2 * std::numbers::pi * (i + 0.5) / 72,
                   r = test::scene_radius + test::scene_spacing * (j + 0.5);
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      EXPECT_NEAR(values[1][grid.cell(i, j)],
                  std::hypot(2 * std::cos(2 * x) * std::cos(y), std::sin(2 * x) * std::sin(y)), 0.02);
    }
}

TEST(PictureValues, SpeedAndPlainFields) {
  Snapshot snapshot = test::scene("velocity_x", [](double, double) { return 3.0; });
  for (GridSnapshot& grid : snapshot.grids) test::fill_field(grid, "velocity_y", [](double, double) { return -4.0; });
  EXPECT_EQ(picture_values(snapshot, "velocity")[1][5], 5);
  EXPECT_EQ(picture_values(snapshot, "velocity_y")[1][5], -4);
  EXPECT_EQ(value_range(snapshot, picture_values(snapshot, "velocity"), "velocity"), (std::array<double, 2>{5, 5}));
}

TEST(PictureValues, AFieldOnSomeGridsIsEnough) {
  Snapshot snapshot = test::scene("density", [](double, double) { return 1.0; });
  test::fill_field(snapshot.grids[1], "von_mises", [](double x, double) { return x; });
  const PictureValues values = picture_values(snapshot, "stress");
  EXPECT_TRUE(std::isnan(values[0][0]));
  EXPECT_FALSE(std::isnan(values[1][0]));
}

TEST(PictureValues, UnknownFieldsAreAnsweredWithTheNearestOne) {
  const Snapshot snapshot = test::scene("pressure", [](double, double) { return 1.0; });
  try {
    picture_values(snapshot, "presure");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"pressure\"?"), std::string::npos) << error.what();
  }
  EXPECT_THROW(picture_values(snapshot, "schlieren"), InputError);
}

TEST(PictureValues, RangeIsOfActiveCellsOnly) {
  Snapshot snapshot = test::scene("pressure", [](double x, double) { return 1 + 0.1 * x; });
  auto& values = snapshot.grids[0].fields[0].second;
  for (std::size_t c = 0; c < values.size(); ++c)
    if (snapshot.grids[0].mask[c] != mask_active) values[c] = 77;
  const auto range = value_range(snapshot, picture_values(snapshot, "pressure"), "pressure");
  EXPECT_NEAR(range[0], 0.8 + 0.0025, 1e-12);
  EXPECT_NEAR(range[1], 1.2 - 0.0025, 1e-12);
}

TEST(PictureValues, OneSharpCellDoesNotSetTheScaleOfSchlieren) {
  Snapshot snapshot = test::scene("density", [](double x, double) { return x; });
  snapshot.grids[0].fields[0].second[50] = 1e6;
  const auto range = value_range(snapshot, picture_values(snapshot, "schlieren"), "schlieren");
  EXPECT_EQ(range[0], 0);
  EXPECT_NEAR(range[1], 1, 1e-9);
}

TEST(PictureValues, ClosedGridsAreRecognized) {
  EXPECT_TRUE(closed_along(test::annulus()));
  EXPECT_FALSE(closed_along(test::background()));
}

}  // namespace
}  // namespace mortise
