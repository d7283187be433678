#include "mortise/grids/overlap/overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/grids/forest/ghost_exchange.hpp"

namespace mortise {
namespace {

/// A background on [−1, 1]² and bodies with grids around them, carrying one scalar.
struct OverlapScene {
  OverlapScene(double spacing, const std::vector<Outline>& outlines) {
    const int n = static_cast<int>(std::lround(2 / spacing));
    grids.emplace_back("background", comm, Index<2>{n, n}, std::array<bool, 2>{false, false}, TileShape<2>({n / 2, n / 2}));
    grids[0].origin = {-1, -1};
    grids[0].spacing = {spacing, spacing};
    std::vector<OverlapBody<2>> bodies;
    for (const Outline& outline : outlines) {
      constexpr int layers = 10;
      const auto atlas = std::make_shared<BodyAtlas>(outline, grow(outline, {spacing, layers}));
      const int along = atlas->grid().along;
      grids.emplace_back("body", comm, Index<2>{along, layers}, std::array<bool, 2>{true, false}, TileShape<2>({along, layers}));
      grids.back().body = static_cast<int>(bodies.size());
      bodies.push_back({atlas, spacing, layers});
      atlases.push_back(atlas);
    }
    for (const ComponentGrid<2>& grid : grids) fields.emplace_back(grid.shape, 1, grid.forest.local_count());
    overlap = std::make_unique<Overlap<2>>(comm, grids, bodies, Box<2>{{-1, -1}, {1, 1}}, OverlapOptions{});
  }

  Point<2> center(std::size_t g, int tile, const Index<2>& c, const std::vector<Pose<2>>& poses) const {
    const ComponentGrid<2>& grid = grids[g];
    const Index<2> first = grid.first_cell(tile);
    if (grid.background()) return grid.center({first[0] + c[0], first[1] + c[1]});
    const auto b = static_cast<std::size_t>(grid.body);
    return Frame<2>(poses[b]).to_space(atlases[b]->center(first[0] + c[0], first[1] + c[1]));
  }

  /// Sets active cells to f(x), all others to 1e30.
  template <class F>
  void set(const std::vector<Pose<2>>& poses, F&& f) {
    for_all([&](std::size_t g, int t, const Index<2>& c, double& value) {
      const TileMask& mask = grids[g].masks[static_cast<std::size_t>(t)];
      const bool active = !mask.cut() || mask.active[grids[g].shape.at(c)];
      value = active ? f(center(g, t, c, poses)) : 1e30;
    });
  }

  template <class Visit>
  void for_all(Visit&& visit) {
    for (std::size_t g = 0; g < grids.size(); ++g)
      for (int t = 0; t < fields[g].tiles(); ++t)
        for_each_cell<2>(grids[g].shape, 0, [&](const Index<2>& c) { visit(g, t, c, fields[g].tile(t).component(0)[grids[g].shape.at(c)]); });
  }

  void fill() {
    const double filler[] = {1e30};
    for (std::size_t g = 0; g < grids.size(); ++g) GhostExchange<2>(grids[g].forest, grids[g].shape, 1).fill(fields[g], filler);
    const auto same = [](const double* from, double* to) { *to = *from; };
    overlap->fill<1>(fields, same, same);
  }

  Communicator comm;
  std::vector<ComponentGrid<2>> grids;
  std::vector<std::shared_ptr<BodyAtlas>> atlases;
  std::vector<Field<2>> fields;
  std::unique_ptr<Overlap<2>> overlap;
};

/// Smooth and without extrema, where clipping would cost an order.
double smooth(const Point<2>& x) { return std::exp(x[0] + 0.7 * x[1]); }

/// Largest interpolation error in fringe cells for two rotated ellipses.
double fringe_error(double spacing) {
  OverlapScene scene(spacing, {Outline::ellipse(0.25, 0.12), Outline::ellipse(0.2, 0.15)});
  const std::vector<Pose<2>> poses = {{{-0.35, 0.1}, 0.5}, {{0.4, -0.1}, 1.1}};
  scene.overlap->update(poses, true);
  EXPECT_EQ(scene.overlap->report().orphans, 0) << scene.overlap->report().first_orphan;
  EXPECT_GT(scene.overlap->census().holes, 0);
  scene.set(poses, smooth);
  scene.fill();
  double error = 0;
  scene.for_all([&](std::size_t g, int t, const Index<2>& c, double& value) {
    const TileMask& mask = scene.grids[g].masks[static_cast<std::size_t>(t)];
    if (mask.cut() && mask.state[scene.grids[g].shape.at(c)] == CellState::fringe)
      error = std::max(error, std::fabs(value - smooth(scene.center(g, t, c, poses))));
  });
  return error;
}

TEST(Overlap, InterpolatesSmoothFieldsToThirdOrder) {
  const double coarse = fringe_error(0.025), fine = fringe_error(0.0125);
  EXPECT_LT(coarse, 2e-4);
  EXPECT_GT(std::log2(coarse / fine), 2.5);
}

TEST(Overlap, EveryActiveStencilIsFilled) {
  OverlapScene scene(0.02, {Outline::rounded_rectangle(0.1, 0.5, 0.038), Outline::circle(0.15)});
  const std::vector<Pose<2>> poses = {{{-0.2, 0.05}, 0.4}, {{0.24, 0.1}, 0}};  // grids overlap one another
  scene.overlap->update(poses, true);
  EXPECT_EQ(scene.overlap->report().orphans, 0);
  scene.set(poses, [](const Point<2>&) { return 1.0; });
  scene.fill();
  const double filler[] = {1e30};
  for (std::size_t g = 0; g < scene.grids.size(); ++g)
    GhostExchange<2>(scene.grids[g].forest, scene.grids[g].shape, 1).fill(scene.fields[g], filler);
  scene.for_all([&](std::size_t g, int t, const Index<2>& c, double&) {
    const ComponentGrid<2>& grid = scene.grids[g];
    const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
    if (mask.cut() && !mask.active[grid.shape.at(c)]) return;
    const Index<2> first = grid.first_cell(t);
    for (int dj = -2; dj <= 2; ++dj)
      for (int di = -2; di <= 2; ++di) {
        const Index<2> n = {c[0] + di, c[1] + dj};
        const Index<2> global = {first[0] + n[0], first[1] + n[1]};
        if (std::abs(di) + std::abs(dj) > 2 || global[1] < 0 || (grid.background() && (global[0] < 0 || global[0] >= grid.cells[0] || global[1] >= grid.cells[1])))
          continue;  // walls and the edge of the domain have their own boundary conditions
        EXPECT_EQ(scene.fields[g].tile(t).component(0)[grid.shape.at(n)], 1.0) << grid.name << ' ' << global[0] << ' ' << global[1];
      }
  });
}

TEST(Overlap, CellsInsideBodiesAreHoles) {
  OverlapScene scene(0.02, {Outline::circle(0.3)});
  const std::vector<Pose<2>> poses = {{{0.1, 0}, 0}};
  scene.overlap->update(poses, true);
  scene.for_all([&](std::size_t g, int t, const Index<2>& c, double&) {
    if (g != 0) return;
    const TileMask& mask = scene.grids[0].masks[static_cast<std::size_t>(t)];
    const double r = (scene.center(g, t, c, poses) - poses[0].position).norm();
    const CellState state = mask.cut() ? mask.state[scene.grids[0].shape.at(c)] : CellState::active;
    if (r < 0.3) {
      EXPECT_EQ(state, CellState::hole);
    } else if (r > 0.3 + 10 * 0.02) {
      EXPECT_EQ(state, CellState::active);
    }
  });
}

TEST(Overlap, ExposedCellsTakeValuesFromTheMovedGrid) {
  OverlapScene scene(0.02, {Outline::circle(0.3)});
  scene.overlap->update({{{0, 0}, 0}}, true);
  const std::vector<Pose<2>> moved = {{{0.015, 0.005}, 0.02}};
  EXPECT_TRUE(scene.overlap->update(moved, false));
  EXPECT_GT(scene.overlap->report().exposed, 0);
  EXPECT_EQ(scene.overlap->report().orphans, 0);
  scene.set(moved, smooth);
  scene.for_all([&](std::size_t g, int, const Index<2>&, double& value) { value = g == 0 ? value + 1 : value; });  // background is off by one
  scene.fill();
  int near_one_body_value = 0;
  scene.for_all([&](std::size_t g, int t, const Index<2>& c, double& value) {
    const TileMask& mask = scene.grids[g].masks[static_cast<std::size_t>(t)];
    if (g == 0 && mask.cut() && mask.active[scene.grids[0].shape.at(c)] && std::fabs(value - smooth(scene.center(g, t, c, moved))) < 1e-3)
      ++near_one_body_value;
  });
  EXPECT_EQ(near_one_body_value, scene.overlap->report().exposed);
}

TEST(Overlap, NothingIsDoneForBodiesAtRest) {
  OverlapScene scene(0.02, {Outline::circle(0.3)});
  EXPECT_TRUE(scene.overlap->update({{{0, 0}, 0}}, true));
  EXPECT_TRUE(scene.overlap->update({{{0, 0}, 0}}, false));  // once more, to forget what was exposed
  EXPECT_FALSE(scene.overlap->update({{{0, 0}, 0}}, false));
}

TEST(Overlap, TouchingOnlyWhatMovedGivesTheSameCut) {
  const std::vector<Outline> outlines = {Outline::circle(0.2), Outline::ellipse(0.2, 0.1), Outline::circle(0.1)};
  OverlapScene stepwise(0.02, outlines), afresh(0.02, outlines);
  std::vector<Pose<2>> poses = {{{-0.5, -0.5}, 0}, {{0.5, 0.5}, 0.3}, {{0.2, 0.25}, 0}};
  stepwise.overlap->update(poses, true);
  for (int step = 0; step < 12; ++step) {
    if (step < 8) poses[0].position += Point<2>(0.011, 0.006);
    if (step > 2 && step < 6) poses[2].position += Point<2>(0.004, -0.01);
    stepwise.overlap->update(poses, false);
    afresh.overlap->update(poses, true);
    for (std::size_t g = 0; g < stepwise.grids.size(); ++g)
      for (std::size_t t = 0; t < stepwise.grids[g].masks.size(); ++t) {
        EXPECT_EQ(stepwise.grids[g].masks[t].active, afresh.grids[g].masks[t].active) << step << ' ' << g;
        EXPECT_EQ(stepwise.grids[g].masks[t].state, afresh.grids[g].masks[t].state) << step << ' ' << g;
        EXPECT_EQ(stepwise.grids[g].masks[t].active_count, afresh.grids[g].masks[t].active_count);
      }
  }
  stepwise.set(poses, smooth);
  afresh.set(poses, smooth);
  stepwise.fill();
  afresh.fill();
  stepwise.for_all([&](std::size_t g, int t, const Index<2>& c, double& value) {
    EXPECT_EQ(value, afresh.fields[g].tile(t).component(0)[afresh.grids[g].shape.at(c)]);
  });
}

TEST(Overlap, SharesSumToOne) {
  OverlapScene scene(0.02, {Outline::circle(0.3)});
  scene.overlap->update({{{0, 0}, 0}}, true);
  for (const double r : {0.31, 0.35, 0.4, 0.42, 0.45, 0.5, 0.8})
    EXPECT_NEAR(scene.overlap->share(0, {r, 0}) + scene.overlap->share(1, {r, 0}), 1, 1e-14);
}

}  // namespace
}  // namespace mortise
