#include "mortise/cases/study/snapshot_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Function = double (*)(double x, double y);

/// A quarter of a ring, 1 ≤ r ≤ 2, n × n cells with means of the four fields' function (value at the middle).
Snapshot ring(int n, Function function, bool solid = false) {
  GridSnapshot grid;
  grid.name = "ring";
  grid.cells = {n, n};
  grid.solid = solid;
  grid.mask.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), mask_active);
  const auto place = [n](double i, double j) {
    const double r = 1 + j / n, angle = 0.5 * std::numbers::pi * i / n;
    return Point<2>(r * std::cos(angle), r * std::sin(angle));
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) grid.x.push_back(place(i, j).x()), grid.y.push_back(place(i, j).y());
  std::vector<double> values, ones(grid.mask.size(), 1.0), X, Y;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point<2> x = place(i + 0.5, j + 0.5);
      X.push_back(x.x()), Y.push_back(x.y());
      values.push_back(function(x.x(), x.y()));
    }
  if (solid) {
    for (const char* name :
         {"displacement_x", "displacement_y", "velocity_x", "velocity_y", "stress_xx", "stress_xy", "stress_yy"})
      grid.fields.emplace_back(name, values);
    grid.fields.emplace_back("reference_x", X);
    grid.fields.emplace_back("reference_y", Y);
    for (double& x : grid.x) x += 100;  // it has moved: material points count, not places
  } else {
    grid.fields = {{"density", ones}, {"velocity_x", values}, {"velocity_y", values}, {"pressure", values}};
  }
  Snapshot snapshot;
  snapshot.grids.push_back(grid);
  return snapshot;
}

double linear(double x, double y) { return 1 + 2 * x - 3 * y; }
double wave(double x, double y) { return std::sin(2 * x + y); }
double other_wave(double x, double y) { return std::sin(2 * x + y) + 0.1; }
double more(double x, double y) { return wave(x, y) + x; }

TEST(SnapshotDifference, IsNothingWhereBothAreOneFunction) {
  // Means over curved cells and over their quarters differ by O(h²).
  double last = 0;
  for (const int n : {8, 16, 32}) {
    const double error = snapshot_difference(ring(n, wave), ring(2 * n, wave)).at("fluid.pressure").max;
    EXPECT_LT(error, 1.2 / (n * n));
    if (last > 0) {
      EXPECT_LT(error, last / 3.4);
    }
    last = error;
  }
  EXPECT_LT(snapshot_difference(ring(32, linear), ring(64, linear)).at("fluid.pressure").max, 2e-3);
}

TEST(SnapshotDifference, IsTheDifferenceOfTheFunctions) {
  const auto norms = snapshot_difference(ring(32, wave), ring(64, other_wave));
  EXPECT_NEAR(norms.at("fluid.pressure").l1, 0.1, 1e-3);
  EXPECT_NEAR(norms.at("fluid.pressure").l2, 0.1, 1e-3);
  EXPECT_NEAR(norms.at("fluid.temperature").l1, 0.1, 1e-3);
  EXPECT_EQ(norms.at("fluid.density").max, 0);
  // ∫ x dA / A over the ring: (7/3) / (3π/4)
  EXPECT_NEAR(snapshot_difference(ring(32, wave), ring(64, more)).at("fluid.velocity_x").l1,
              28 / (9 * std::numbers::pi), 2e-3);
}

TEST(SnapshotDifference, OfSolidsIsThatOfTheSameMaterialPoint) {
  const auto norms = snapshot_difference(ring(32, wave, true), ring(64, other_wave, true));
  EXPECT_NEAR(norms.at("solid.displacement").l1, 0.1 * std::sqrt(2.0), 2e-3);
  EXPECT_NEAR(norms.at("solid.stress").l1, 0.1 * 2, 2e-3);
  EXPECT_EQ(norms.count("fluid.pressure"), 0u);
}

TEST(SnapshotDifference, CellsTheFineSolutionDoesNotCoverAreLeftOut) {
  Snapshot fine = ring(64, other_wave);
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 32; ++i) fine.grids[0].mask[fine.grids[0].cell(i, j)] = mask_hole;
  EXPECT_NEAR(snapshot_difference(ring(32, wave), fine).at("fluid.pressure").max, 0.1, 5e-3);
}

TEST(SnapshotDifference, OfAStripIsThatAlongIt) {
  const auto strip = [](int n, double value) {
    std::vector<double> nodes;
    for (int i = 0; i <= n; ++i) nodes.push_back(double(i) / n);
    GridSnapshot grid = line_grid("line", nodes);
    std::vector<double> values(static_cast<std::size_t>(n), value);
    grid.fields = {{"density", values}, {"velocity_x", values}, {"pressure", values}};
    Snapshot snapshot;
    snapshot.grids.push_back(grid);
    return snapshot;
  };
  EXPECT_NEAR(snapshot_difference(strip(20, 1), strip(40, 1.25)).at("fluid.density").l1, 0.25, 1e-14);
}

TEST(SnapshotDifference, NeedsSomethingInCommon) {
  EXPECT_THROW(snapshot_difference(ring(8, wave), ring(8, wave, true)), InputError);
}

}  // namespace
}  // namespace mortise
