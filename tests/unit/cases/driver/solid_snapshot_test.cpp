#include "mortise/cases/driver/solid_snapshot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mortise {
namespace {

using std::numbers::pi;

Material material(StressLaw law) { return {law, 1.0, 2.0, 0.5}; }

/// A grid with nodes at place(ξ, η), 0 ≤ ξ, η ≤ 1, whose cells have the displacement u(X) and everything else zero.
template <class Place, class Displacement>
SolidGrid linear_grid(Index<2> cells, Place place, Displacement u) {
  SolidGrid grid{.name = "solid", .cells = cells, .nodes = {}, .mask = {}, .states = {}};
  const auto at = [&](double i, double j) { return Point<2>(place(i / cells[0], j / cells[1])); };
  for (int j = 0; j <= cells[1]; ++j)
    for (int i = 0; i <= cells[0]; ++i) grid.nodes.push_back(at(i, j));
  for (int j = 0; j < cells[1]; ++j)
    for (int i = 0; i < cells[0]; ++i) {
      const Point<2> X = 0.25 * (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1));
      const Point<2> here = u(X);
      grid.states.push_back({0, 0, 0, 0, 0, here.x(), here.y(), 0});
      grid.mask.push_back(mask_active);
    }
  return grid;
}

Point<2> stretched(const Point<2>& X) { return {0.1 + 0.3 * X.x() - 0.2 * X.y(), -0.05 * X.x() + 0.4 * X.y()}; }

Point<2> sheared_square(double xi, double eta) { return {2 * xi + 0.5 * eta, eta}; }

Point<2> node(const GridSnapshot& grid, std::size_t k) { return {grid.x[k], grid.y[k]}; }

TEST(SolidSnapshot, NodesOfAHomogeneousDeformationAreExact) {
  const SolidGrid grid = linear_grid({7, 5}, sheared_square, stretched);
  const GridSnapshot out = solid_snapshot(grid, material(StressLaw::linear));
  EXPECT_TRUE(out.solid);
  for (std::size_t k = 0; k < grid.nodes.size(); ++k)
    EXPECT_LT((node(out, k) - grid.nodes[k] - stretched(grid.nodes[k])).norm(), 1e-14) << k;
}

TEST(SolidSnapshot, HolesAreLeftOutOfTheNodes) {
  SolidGrid grid = linear_grid({8, 8}, sheared_square, stretched);
  for (int j = 3; j < 6; ++j)
    for (int i = 2; i < 5; ++i) {
      grid.mask[static_cast<std::size_t>(8 * j + i)] = mask_hole;
      grid.states[static_cast<std::size_t>(8 * j + i)].fill(1e30);
    }
  const GridSnapshot out = solid_snapshot(grid, material(StressLaw::linear));
  int inside = 0;
  for (std::size_t k = 0; k < grid.nodes.size(); ++k) {
    const Point<2> u = node(out, k) - grid.nodes[k];
    if (u.norm() < 1e-14)
      ++inside;  // touches nothing but holes
    else
      EXPECT_LT((u - stretched(grid.nodes[k])).norm(), 1e-14) << k;
  }
  EXPECT_EQ(inside, 4);
  EXPECT_EQ(out.field("von_mises")->at(8 * 4 + 3), 0);
}

TEST(SolidSnapshot, NodesAreOfSecondOrder) {
  const auto ring = [](double xi, double eta) {
    return Point<2>((1 - 0.4 * eta) * std::cos(2 * pi * xi), (1 - 0.4 * eta) * std::sin(2 * pi * xi));
  };
  const auto wavy = [](const Point<2>& X) { return Point<2>(0.1 * std::sin(2 * X.x() + X.y()), 0.1 * X.x() * X.y()); };
  double error[2];
  for (int level = 0; level < 2; ++level) {
    SolidGrid grid = linear_grid({64 << level, 16 << level}, ring, wavy);
    grid.periodic = true;
    const std::vector<Point<2>> u = node_displacements(grid, material(StressLaw::linear));
    const int row = grid.cells[0] + 1;
    for (int j = 0; j <= grid.cells[1]; ++j)
      EXPECT_EQ(u[static_cast<std::size_t>(j * row)], u[static_cast<std::size_t>(j * row + row - 1)]);
    error[level] = 0;
    for (std::size_t k = 0; k < u.size(); ++k)
      error[level] = std::max(error[level], (u[k] - wavy(grid.nodes[k])).norm());
  }
  EXPECT_LT(error[1], 3e-4);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.8);
}

TEST(SolidSnapshot, FieldsOfAHyperelasticState) {
  SolidGrid grid = linear_grid({3, 3}, sheared_square, stretched);
  for (ElasticState& state : grid.states) state = {0.5, -0.25, 1.3, -0.2, -0.05, 1.4, 0.1, 0.2};
  const Material m = material(StressLaw::neo_hookean);
  const GridSnapshot out = solid_snapshot(grid, m);
  const CauchyStress s = cauchy_stress_of(m, grid.states[0]);
  EXPECT_EQ(out.field("velocity_y")->at(4), -0.25);
  EXPECT_EQ(out.field("displacement_x")->at(4), 0.1);
  EXPECT_EQ(out.field("stress_xy")->at(4), s.xy);
  EXPECT_EQ(out.field("von_mises")->at(4), s.von_mises());
  EXPECT_DOUBLE_EQ(out.field("jacobian")->at(4), 1.3 * 1.4 - 0.2 * 0.05);
}

TEST(SolidSnapshot, TheFirstLayerIsTheInterface) {
  const SolidGrid grid = linear_grid({4, 2}, sheared_square, stretched);
  const GridSnapshot before = solid_snapshot(grid, material(StressLaw::linear));
  std::vector<Point<2>> interface;
  for (int i = 0; i < 4; ++i) interface.emplace_back(i, 10 + i);
  GridSnapshot repeating = before;
  place_first_layer(repeating, interface);
  EXPECT_EQ(node(repeating, 3), Point<2>(3, 13));
  EXPECT_LT((node(repeating, 4) - node(repeating, 0) - (node(before, 9) - node(before, 5))).norm(), 1e-14);
  EXPECT_EQ(node(repeating, 5), node(before, 5));
  interface.emplace_back(7, 8);
  GridSnapshot open = before;
  place_first_layer(open, interface);
  EXPECT_EQ(node(open, 4), Point<2>(7, 8));
  interface.emplace_back(9, 9);
  GridSnapshot other = before;
  place_first_layer(other, interface);
  EXPECT_EQ(node(other, 0), node(before, 0));
}

}  // namespace
}  // namespace mortise
