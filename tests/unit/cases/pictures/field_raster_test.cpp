#include "mortise/cases/pictures/field_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "example_scene.hpp"
#include "mortise/cases/pictures/picture_values.hpp"

namespace mortise {
namespace {

const Axes axes{0, 0, 400, 300, {{-2, -1.5}, {2, 1.5}}};

Point<2> physical(int x, int y) { return {-2 + (x + 0.5) / 100, 1.5 - (y + 0.5) / 100}; }

FieldRaster rastered(const Snapshot& snapshot, const std::string& field) {
  const PictureValues values = picture_values(snapshot, field);
  FieldRaster raster(axes);
  for (std::size_t g = 0; g < snapshot.grids.size(); ++g) raster.add(snapshot.grids[g], values[g], g == 0 ? 1 : 4);
  return raster;
}

TEST(FieldRaster, ReproducesALinearField) {
  const auto linear = [](double x, double y) { return 1 + 0.3 * x - 0.2 * y; };
  const FieldRaster raster = rastered(test::scene("density", linear), "density");
  int inside = 0;
  for (int y = 3; y < 297; ++y)
    for (int x = 3; x < 397; ++x) {
      const Point<2> p = physical(x, y);
      if (p.norm() < test::scene_radius + 0.03) continue;  // the half cell at the wall takes the cell's value
      ++inside;
      EXPECT_NEAR(raster.at(x, y), linear(p.x(), p.y()), p.norm() > 1 ? 1e-6 : 2e-3) << x << ' ' << y;
    }
  EXPECT_GT(inside, 100000);
}

TEST(FieldRaster, CoversAllOfTheFluidAndNothingElse) {
  const FieldRaster raster = rastered(test::scene("density", [](double, double) { return 1.0; }), "density");
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      const double r = physical(x, y).norm();
      if (r > test::scene_radius) {
        EXPECT_FLOAT_EQ(static_cast<float>(raster.at(x, y)), 1) << x << ' ' << y;
      } else if (r < test::scene_radius - 0.01) {
        EXPECT_TRUE(std::isnan(raster.at(x, y))) << x << ' ' << y;
      }
    }
}

TEST(FieldRaster, GridsThatDisagreeMeetWithoutASeam) {
  Snapshot snapshot = test::scene("density", [](double, double) { return 0.0; });
  for (double& value : snapshot.grids[1].fields[0].second) value = 1;
  const FieldRaster raster = rastered(snapshot, "density");
  double steepest = 0;
  for (int x = 251; x < 399; ++x) steepest = std::max(steepest, std::fabs(raster.at(x, 150) - raster.at(x - 1, 150)));
  EXPECT_FLOAT_EQ(static_cast<float>(raster.at(256, 150)), 1);  // body grid alone
  EXPECT_EQ(raster.at(300, 150), 0);                            // background alone
  EXPECT_LT(steepest, 0.25);                                    // 5 pixels a cell: a step would be 1
}

TEST(FieldRaster, GridsOutsideTheWindowAreHarmless) {
  GridSnapshot far = test::annulus(), vast = test::annulus();
  for (double& x : far.x) x += 100;
  for (std::size_t k = 0; k < vast.x.size(); ++k) {
    vast.x[k] *= 1e12;
    vast.y[k] *= 1e12;
  }
  const std::vector<double> values(far.cell_count(), 1.0);
  FieldRaster raster(axes);
  raster.add(far, values, 1);
  raster.add(vast, values, 1);
  for (int y = 0; y < 300; y += 7)
    for (int x = 0; x < 400; x += 7) EXPECT_TRUE(std::isnan(raster.at(x, y)));
}

TEST(FieldRaster, EveryPixelOfASkewedGridIsFound) {
  GridSnapshot grid = test::background();
  grid.mask.assign(grid.cell_count(), mask_active);
  for (std::size_t k = 0; k < grid.x.size(); ++k) {
    const double x = grid.x[k], y = grid.y[k];
    grid.x[k] = 1.3 * x + 0.3 * std::sin(2 * y);
    grid.y[k] = 1.3 * y + 0.3 * std::sin(2 * x);
  }
  FieldRaster raster(axes);
  raster.add(grid, std::vector<double>(grid.cell_count(), 2.5), 1);
  for (int y = 40; y < 260; ++y)
    for (int x = 40; x < 360; ++x) EXPECT_EQ(raster.at(x, y), 2.5) << x << ' ' << y;
}

}  // namespace
}  // namespace mortise
