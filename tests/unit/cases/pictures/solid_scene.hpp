// Scenes with elastic solids for the tests of pictures.
#pragma once

#include "example_scene.hpp"

namespace mortise::test {

/// The solid in the hole of example_scene.hpp: a core and a grid grown inward from the circle, counter-clockwise.
inline std::array<GridSnapshot, 2> disk() {
  const double h = scene_spacing;
  std::array<GridSnapshot, 2> grids;
  GridSnapshot &core = grids[0], &fitted = grids[1];
  core.name = "disk_core";
  core.cells = {20, 20};
  for (int j = 0; j <= 20; ++j)
    for (int i = 0; i <= 20; ++i) {
      core.x.push_back(h * (i - 10));
      core.y.push_back(h * (j - 10));
    }
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) {
      const double depth = scene_radius - std::hypot(h * (i - 9.5), h * (j - 9.5));
      core.mask.push_back(depth > 3 * h ? mask_active : depth > h ? mask_fringe : mask_hole);
    }
  fitted.name = "disk";
  fitted.cells = {64, 6};
  for (int j = 0; j <= 6; ++j)
    for (int i = 0; i <= 64; ++i) {
      const double angle = 2 * std::numbers::pi * (i % 64) / 64, radius = scene_radius - h * j;
      fitted.x.push_back(radius * std::cos(angle));
      fitted.y.push_back(radius * std::sin(angle));
    }
  for (int c = 0; c < 64 * 6; ++c) fitted.mask.push_back(c / 64 < 4 ? mask_active : mask_fringe);
  for (GridSnapshot& grid : grids) grid.solid = true;
  return grids;
}

/// The example scene with the disk elastic; von Mises stress and speed rise with x.
template <class Function>
Snapshot elastic_scene(const std::string& field, Function function) {
  Snapshot snapshot = scene(field, function);
  snapshot.outlines.clear();
  for (GridSnapshot& grid : disk()) {
    fill_field(grid, "von_mises", [](double x, double) { return 1 + x; });
    fill_field(grid, "velocity_x", [](double x, double) { return x; });
    snapshot.grids.push_back(std::move(grid));
  }
  return snapshot;
}

/// A strip four cells wide along a direction: solid on −1 ≤ s ≤ 0, gas on 0 ≤ s ≤ 1, numbered away from the interface.
inline Snapshot strip(const Point<2>& along, int cells) {
  Snapshot snapshot;
  const Point<2> across(-along.y(), along.x());
  for (const bool solid : {false, true}) {
    GridSnapshot grid;
    grid.name = solid ? "solid" : "gas";
    grid.solid = solid;
    grid.dimension = 1;
    grid.cells = {4, cells};
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= 4; ++i) {
        const Point<2> x = (solid ? -1.0 : 1.0) * j / cells * along + (i - 2.0) / cells * across;
        grid.x.push_back(x.x());
        grid.y.push_back(x.y());
      }
    grid.mask.assign(grid.cell_count(), mask_active);
    const auto place = [&](double x, double y) { return along.dot(Point<2>(x, y)); };
    const auto set = [&](const std::string& name, auto function) {
      fill_field(grid, name, [&](double x, double y) { return function(place(x, y)); });
    };
    const auto velocity = [](double s) { return 0.3 + 0.1 * s; };
    set("velocity_x", [&](double s) { return velocity(s) * along.x(); });
    set("velocity_y", [&](double s) { return velocity(s) * along.y(); });
    if (solid) {
      const auto sigma = [](double s) { return -2 - s; };
      set("stress_xx", [&](double s) { return sigma(s) * along.x() * along.x(); });
      set("stress_xy", [&](double s) { return sigma(s) * along.x() * along.y(); });
      set("stress_yy", [&](double s) { return sigma(s) * along.y() * along.y(); });
      set("von_mises", [&](double s) { return -sigma(s); });
    } else {
      set("density", [](double s) { return 1 - 0.2 * s; });
      set("pressure", [](double s) { return 2 - s; });
    }
    snapshot.grids.push_back(std::move(grid));
  }
  return snapshot;
}

}  // namespace mortise::test
