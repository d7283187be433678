#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/cases/pictures/axes.hpp"
#include "mortise/cases/pictures/colormap.hpp"
#include "mortise/cases/pictures/picture_values.hpp"
#include "mortise/cases/pictures/render.hpp"

namespace mortise {
namespace {

constexpr double outer_radius = 0.6, inner_radius = 0.25;  // radii of a ring on the cells of the fluid
constexpr int cells_across = 40;

/// A square, [−1, 1]², of which the ring covers cells as a reference map does: those partly solid hold no fluid.
Snapshot ring_in_fluid() {
  const double h = 2.0 / cells_across;
  Snapshot snapshot;
  for (const bool solid : {false, true}) {
    GridSnapshot grid;
    grid.solid = solid;
    grid.cells = {cells_across, cells_across};
    for (int j = 0; j <= cells_across; ++j)
      for (int i = 0; i <= cells_across; ++i) grid.x.push_back(i * h - 1), grid.y.push_back(j * h - 1);
    std::vector<double> values;
    for (int j = 0; j < cells_across; ++j)
      for (int i = 0; i < cells_across; ++i) {
        const double x = (i + 0.5) * h - 1, r = std::hypot(x, (j + 0.5) * h - 1);
        const double distance = std::max(r - outer_radius, inner_radius - r);
        grid.mask.push_back((solid ? distance < 0 : distance > 1.3 * h) ? mask_active : mask_hole);
        values.push_back(solid ? 1.0 : 2 + x);
      }
    grid.fields.emplace_back(solid ? "von_mises" : "density", values);
    snapshot.grids.push_back(grid);
  }
  for (const double radius : {outer_radius, inner_radius}) {
    snapshot.surfaces.emplace_back();
    for (int k = 0; k < 128; ++k)
      snapshot.surfaces.back().emplace_back(radius * std::cos(std::numbers::pi * k / 64),
                                            radius * std::sin(std::numbers::pi * k / 64));
  }
  return snapshot;
}

int difference(Rgb a, Rgb b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

TEST(MappedSolidPicture, SolidAndFluidMeetAtTheSurface) {
  RenderOptions options;
  options.field = "density";
  options.width = 600;
  const Image image = render(ring_in_fluid(), options);
  const double left = std::lround(66 * 0.5), scale = (600 - (66 + 104) * 0.5) / 2, pixel = 1 / scale;
  const auto at = [&](double r, double angle) {
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    return image.at(static_cast<int>(left + (x + 1) * scale), static_cast<int>(22 + (1 - y) * scale));
  };
  for (int k = 0; k < 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200;
    const auto fluid = [&](double r) { return color_at(sequential_map(), (r * std::cos(angle) + 0.975) / 1.95); };
    for (const double r : {outer_radius + 3 * pixel, inner_radius - 3 * pixel})
      EXPECT_LT(difference(at(r, angle), fluid(r)), 30) << r << " " << angle;
    for (const double r : {outer_radius - 3 * pixel, inner_radius + 3 * pixel})
      EXPECT_LT(difference(at(r, angle), color_at(stress_map(), 1)), 4) << r << " " << angle;
  }
}

}  // namespace
}  // namespace mortise
