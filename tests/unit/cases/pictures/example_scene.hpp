// A scene for the tests of pictures: a uniform background with a hole, and an annulus around a circle.
#pragma once

#include <cmath>
#include <numbers>

#include "mortise/grids/output/image.hpp"
#include "mortise/grids/output/snapshot.hpp"

namespace mortise::test {

inline constexpr double scene_spacing = 0.05, scene_radius = 0.5;

/// Fills the cell field `name` with function(x, y) at cell centres; holes get a value that must never show.
template <class Function>
void fill_field(GridSnapshot& grid, const std::string& name, Function function) {
  std::vector<double> values;
  for (int j = 0; j < grid.cells[1]; ++j)
    for (int i = 0; i < grid.cells[0]; ++i) {
      const std::size_t a = grid.node(i, j), b = grid.node(i, j + 1);
      const double x = (grid.x[a] + grid.x[a + 1] + grid.x[b] + grid.x[b + 1]) / 4,
                   y = (grid.y[a] + grid.y[a + 1] + grid.y[b] + grid.y[b + 1]) / 4;
      values.push_back(grid.mask[grid.cell(i, j)] == mask_hole ? -1e30 : function(x, y));
    }
  grid.fields.emplace_back(name, values);
}

/// [−2, 2] × [−1.5, 1.5]; active cells end 4 h, fringe cells 2 h from the circle.
inline GridSnapshot background() {
  GridSnapshot grid;
  grid.name = "background";
  const double h = scene_spacing;
  grid.cells = {80, 60};
  for (int j = 0; j <= 60; ++j)
    for (int i = 0; i <= 80; ++i) {
      grid.x.push_back(-2 + h * i);
      grid.y.push_back(-1.5 + h * j);
    }
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 80; ++i) {
      const double distance = std::hypot(-2 + h * (i + 0.5), -1.5 + h * (j + 0.5)) - scene_radius;
      grid.mask.push_back(distance > 4 * h ? mask_active : distance > 2 * h ? mask_fringe : mask_hole);
    }
  return grid;
}

/// 72 × 8 cells around the circle, clockwise, the two outer layers fringe.
inline GridSnapshot annulus() {
  GridSnapshot grid;
  grid.name = "disk";
  grid.cells = {72, 8};
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 72; ++i) {
      const double angle = -2 * std::numbers::pi * (i % 72) / 72, radius = scene_radius + scene_spacing * j;
      grid.x.push_back(radius * std::cos(angle));
      grid.y.push_back(radius * std::sin(angle));
    }
  for (int c = 0; c < 72 * 8; ++c) grid.mask.push_back(c / 72 < 6 ? mask_active : mask_fringe);
  return grid;
}

template <class Function>
Snapshot scene(const std::string& field, Function function) {
  Snapshot snapshot;
  snapshot.time = 0.25;
  snapshot.grids = {background(), annulus()};
  for (GridSnapshot& grid : snapshot.grids) fill_field(grid, field, function);
  snapshot.outlines.emplace_back();
  for (int k = 0; k < 400; ++k) {
    const double angle = 2 * std::numbers::pi * k / 400;
    snapshot.outlines[0].emplace_back(scene_radius * std::cos(angle), scene_radius * std::sin(angle));
  }
  return snapshot;
}

/// Pixel of a physical point in a picture of the example scene that is 600 wide, with a colour bar or without.
inline Rgb pixel(const Image& image, double x, double y, bool bar = true) {
  const double unit = 0.5, left = std::lround(66 * unit), scale = (600 - (66 + (bar ? 104 : 24)) * unit) / 4;
  return image.at(static_cast<int>(left + (x + 2) * scale), static_cast<int>(44 * unit + (1.5 - y) * scale));
}

}  // namespace mortise::test
