#include "mortise/cases/driver/map_contours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace mortise {
namespace {

constexpr double radius = 0.6;

/// A disk about (0.1, 0) on the grid of [−1, 1]², 64² cells; its map is known in it and 0.2 around it.
class Disk {
 public:
  explicit Disk(const std::function<Point<2>(const Point<2>&)>& xi)
      : grid("background", Communicator(), {64, 64}, {false, false}, TileShape<2>({32, 32})) {
    grid.origin = {-1, -1};
    grid.spacing = {1.0 / 32, 1.0 / 32};
    samples.size = {64, 64};
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        const Point<2> x = grid.center({i, j});
        const double phi = (x - Point<2>(0.1, 0)).norm() - radius;
        samples.phi.push_back(phi < 0.2 ? phi : unknown_phi);
        samples.xi.push_back(phi < 0.2 ? xi(x) : Point<2>(0, 0));
      }
  }
  ComponentGrid<2> grid;
  MapSamples samples;
};

double length(const std::vector<Point<2>>& line) {
  double sum = 0;
  for (std::size_t k = 1; k < line.size(); ++k) sum += (line[k] - line[k - 1]).norm();
  return sum;
}

TEST(MapContours, LinesOfAnUndeformedDiskAreItsChords) {
  const Disk disk([](const Point<2>& x) { return x; });
  const auto lines = lines_of(disk.samples, disk.grid, {0.1, 0}, 0.25);
  ASSERT_EQ(lines.size(), 10U);  // five in each direction, at −.5, −.25, 0, .25 and .5 from the middle
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const int direction = k < 5 ? 0 : 1;
    const double offset = 0.25 * (static_cast<double>(k % 5) - 2);
    EXPECT_NEAR(length(lines[k]), 2 * std::sqrt(radius * radius - offset * offset), 2e-3) << k;
    for (const Point<2>& x : lines[k]) EXPECT_NEAR(x[direction], offset + (direction == 0 ? 0.1 : 0.0), 1e-12) << k;
    EXPECT_NEAR((lines[k].front() - Point<2>(0.1, 0)).norm(), radius, 1e-3);
    EXPECT_NEAR((lines[k].back() - Point<2>(0.1, 0)).norm(), radius, 1e-3);
  }
}

TEST(MapContours, LinesFollowTheMap) {
  const auto sheared = [](const Point<2>& x) { return Point<2>(x.x() - 0.1 - 0.5 * x.y(), x.y()); };
  const Disk disk(sheared);
  const auto lines = lines_of(disk.samples, disk.grid, {0, 0}, 0.2);
  ASSERT_GE(lines.size(), 10U);
  int slanted = 0;
  for (const auto& line : lines) {
    const Point<2> first = sheared(line.front()), last = sheared(line.back());
    EXPECT_LT((first - last).cwiseAbs().minCoeff(), 1e-12);
    slanted += std::abs(first.x() - last.x()) < 1e-12;
  }
  EXPECT_GE(slanted, 5);
}

TEST(MapContours, LinesInTwoPartsOfABodyAreNotJoined) {
  Disk disk([](const Point<2>& x) { return x; });
  for (std::size_t k = 0; k < disk.samples.phi.size(); ++k)  // a slit along x = 0.1
    if (std::abs(disk.samples.xi[k].x() - 0.1) < 0.05) disk.samples.phi[k] = std::max(disk.samples.phi[k], 0.01);
  const auto lines = lines_of(disk.samples, disk.grid, {0.1, 0}, 0.5);
  int across = 0;
  for (const auto& line : lines)
    if (std::abs(line.front().y()) < 1e-12 && std::abs(line.back().y()) < 1e-12) ++across;
  EXPECT_EQ(across, 2);
}

TEST(MapContours, SurfaceIsTheCircle) {
  const Disk disk([](const Point<2>& x) { return x; });
  const auto surfaces = surfaces_of(disk.samples, disk.grid);
  ASSERT_EQ(surfaces.size(), 1U);
  for (const Point<2>& x : surfaces[0]) EXPECT_NEAR((x - Point<2>(0.1, 0)).norm(), radius, 1e-3);
  EXPECT_NEAR(length(surfaces[0]), 2 * M_PI * radius, 0.05);
}

TEST(MapContours, ReferenceBoxIsThatOfTheOutline) {
  const LevelSet stick(Outline::rounded_rectangle(1, 0.2, 0.1).placed({{0.5, 0.25}, 0}), 0.01, 0.1);
  const Box<2> box = reference_box(stick, 0.01);
  EXPECT_NEAR(box.low.x(), 0, 0.011);
  EXPECT_NEAR(box.high.x(), 1, 0.011);
  EXPECT_NEAR(box.low.y(), 0.15, 0.011);
  EXPECT_NEAR(box.high.y(), 0.35, 0.011);
}

}  // namespace
}  // namespace mortise
