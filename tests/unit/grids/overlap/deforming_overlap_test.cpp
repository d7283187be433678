// Bodies that change shape, bodies around the gas, and bodies made of a fitted grid and a Cartesian core.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/grids/forest/ghost_exchange.hpp"
#include "mortise/grids/overlap/overlap.hpp"

namespace mortise {
namespace {

using AtlasPointer = std::shared_ptr<const BodyAtlas>;
using Curve = std::vector<Point<2>>;

constexpr double unset = 1e30;

/// A background on a square in tiles of ten cells, and body grids of any shape in it, carrying one scalar.
class DeformingScene {
 public:
  DeformingScene(double spacing, double half_width, const std::vector<AtlasPointer>& atlases, OverlapOptions options) {
    const int n = 10 * static_cast<int>(std::lround(half_width / (5 * spacing)));
    grids_.emplace_back("background", comm_, Index<2>{n, n}, std::array<bool, 2>{false, false}, TileShape<2>({10, 10}));
    grids_[0].origin = Point<2>::Constant(-n * spacing / 2);
    grids_[0].spacing = {spacing, spacing};
    std::vector<OverlapBody<2>> bodies;
    for (const AtlasPointer& atlas : atlases) {
      const GrownGrid& grid = atlas->grid();
      const Index<2> cells{grid.along, grid.layers};
      grids_.emplace_back("body", comm_, cells, std::array<bool, 2>{true, false}, TileShape<2>(cells));
      grids_.back().body = static_cast<int>(bodies.size());
      bodies.push_back({atlas, grid.thickness, grid.layers});
      atlases_.push_back(atlas);
    }
    for (const ComponentGrid<2>& grid : grids_) fields_.emplace_back(grid.shape, 1, grid.forest.local_count());
    const Box<2> domain{grids_[0].origin, -grids_[0].origin};
    overlap_ = std::make_unique<Overlap<2>>(comm_, grids_, bodies, domain, options);
    poses_.resize(bodies.size());
    overlap_->update(poses_, true);
  }

  void reshape(std::size_t body, const AtlasPointer& atlas) {
    atlases_[body] = atlas;
    overlap_->reshape(body, atlas);
  }

  /// The largest interpolation error of f in fringe and exposed cells of the grids from `first` on, after an update if
  /// `moved`.
  template <class F>
  double step(bool moved, std::size_t first, F&& f) {
    std::vector<std::uint8_t> before, now;
    for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>&, double&) { before.push_back(active(g, mask, k)); });
    if (moved) {
      EXPECT_TRUE(overlap_->update(poses_, false));
    }
    EXPECT_EQ(overlap_->report().orphans, 0) << overlap_->report().first_orphan;
    std::size_t cell = 0;
    for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double& value) {
      value = active(g, mask, k) && before[cell++] ? f(x) : unset;
      if (!active(g, mask, k)) ++cell;
    });
    return error(first, f);
  }

  template <class Visit>
  void for_all(Visit&& visit) {
    for (std::size_t g = 0; g < grids_.size(); ++g)
      for (int t = 0; t < fields_[g].tiles(); ++t)
        for_each_cell<2>(grids_[g].shape, 0, [&](const Index<2>& c) {
          const Index<2> from = grids_[g].first_cell(t);
          const Index<2> global{from[0] + c[0], from[1] + c[1]};
          const bool background = grids_[g].background();
          const Point<2> x = background ? grids_[g].center(global)
                                        : atlases_[static_cast<std::size_t>(grids_[g].body)]->center(global[0], global[1]);
          const std::size_t k = grids_[g].shape.at(c);
          visit(g, grids_[g].masks[static_cast<std::size_t>(t)], k, x, fields_[g].tile(t).component(0)[k]);
        });
  }

  std::vector<CellState> states() {
    std::vector<CellState> all;
    for_all([&](std::size_t, const TileMask& mask, std::size_t k, const Point<2>&, double&) { all.push_back(state(mask, k)); });
    return all;
  }

  static CellState state(const TileMask& mask, std::size_t k) { return mask.cut() ? mask.state[k] : CellState::active; }
  const Overlap<2>& overlap() const { return *overlap_; }

 private:
  static bool active(std::size_t, const TileMask& mask, std::size_t k) { return !mask.cut() || mask.active[k]; }

  template <class F>
  double error(std::size_t first, F&& f) {
    const double filler[] = {unset};
    for (std::size_t g = 0; g < grids_.size(); ++g)
      GhostExchange<2>(grids_[g].forest, grids_[g].shape, 1).fill(fields_[g], filler);
    const auto same = [](const double* from, double* to) { *to = *from; };
    overlap_->fill<1>(fields_, same, same);
    double largest = 0;
    for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double& value) {
      if (g >= first && state(mask, k) != CellState::hole) largest = std::max(largest, std::abs(value - f(x)));
    });
    return largest;
  }

  Communicator comm_;
  std::vector<ComponentGrid<2>> grids_;
  std::vector<AtlasPointer> atlases_;
  std::vector<Field<2>> fields_;
  std::vector<Pose<2>> poses_;
  std::unique_ptr<Overlap<2>> overlap_;
};

double linear(const Point<2>& x) { return 1 + 2 * x[0] - 3 * x[1]; }
double quadratic(const Point<2>& x) { return linear(x) + x[0] * x[0] - 2 * x[0] * x[1] + 0.5 * x[1] * x[1]; }

/// An ellipse turned by `angle`, clockwise, or counter-clockwise for inward grids.
Curve ellipse(double a, double b, double angle, int count, bool inward) {
  Curve curve;
  for (int i = 0; i < count; ++i) {
    const double t = (inward ? 2 : -2) * std::numbers::pi * i / count;
    const Point<2> x(a * std::cos(t), b * std::sin(t));
    curve.push_back({std::cos(angle) * x[0] - std::sin(angle) * x[1], std::sin(angle) * x[0] + std::cos(angle) * x[1]});
  }
  return curve;
}

AtlasPointer atlas_of(const Curve& curve, double spacing, int layers, bool inward) {
  const GrowthOptions options{.spacing = spacing, .layers = layers, .inward = inward};
  return std::make_shared<const BodyAtlas>(grow_from(curve, options, 4), inward);
}

TEST(DeformingOverlap, AnEllipseBreathesAndTurnsBesideADisk) {
  constexpr double h = 0.025;
  const auto shape = [&](int step) {
    const double phase = 2 * std::numbers::pi * step / 200;
    return atlas_of(ellipse(0.3 + 0.05 * std::sin(phase), 0.25 - 0.05 * std::sin(2 * phase), phase, 68, false), h, 8, false);
  };
  Curve disk = ellipse(0.2, 0.2, 0, 52, false);
  for (Point<2>& x : disk) x += Point<2>(0.6, 0.55);
  DeformingScene scene(h, 1, {shape(0), atlas_of(disk, h, 8, false)}, {.clip = false});
  std::int64_t exposed = 0;
  for (int step = 1; step <= 200; ++step) {
    scene.reshape(0, shape(step));
    ASSERT_LT(scene.step(true, 0, linear), 1e-11) << step << ", tight: " << scene.overlap().report().tight;
    exposed += scene.overlap().report().exposed;
  }
  EXPECT_GT(exposed, 100);
  const std::vector<CellState> settled = scene.states();
  DeformingScene fresh(h, 1, {shape(200), atlas_of(disk, h, 8, false)}, {.clip = false});
  EXPECT_EQ(settled, fresh.states());
}

TEST(DeformingOverlap, NothingMovesWithoutReshape) {
  constexpr double h = 0.05;
  const AtlasPointer disk = atlas_of(ellipse(0.3, 0.3, 0, 36, false), h, 8, false);
  DeformingScene scene(h, 1.2, {disk}, {});
  Overlap<2>& overlap = const_cast<Overlap<2>&>(scene.overlap());
  EXPECT_FALSE(overlap.update({Pose<2>{}}, false) && overlap.update({Pose<2>{}}, false));
  overlap.reshape(0, disk);
  EXPECT_TRUE(overlap.update({Pose<2>{}}, false));
}

TEST(DeformingOverlap, GasWithinABreathingBody) {
  constexpr double h = 0.025;
  const auto shape = [&](int step) {
    const double phase = 2 * std::numbers::pi * step / 60;
    return atlas_of(ellipse(0.7 + 0.06 * std::sin(phase), 0.7 - 0.06 * std::sin(phase), 0.5 * phase, 176, true), h, 8, true);
  };
  DeformingScene scene(h, 1, {shape(0)}, {.clip = false});
  for (int step = 1; step <= 60; ++step) {
    const AtlasPointer atlas = shape(step);
    scene.reshape(0, atlas);
    ASSERT_LT(scene.step(true, 0, linear), 1e-11) << step;
    ASSERT_LT(scene.step(false, 1, quadratic), 1e-11) << "from the background, " << step;
    if (step % 20 != 7) continue;
    const std::vector<CellState> settled = scene.states();
    DeformingScene fresh(h, 1, {atlas}, {.clip = false});
    ASSERT_EQ(settled, fresh.states()) << step;
  }
  int covered = 0;
  scene.for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double&) {
    if (g > 0 || x.norm() < 0.7) return;
    ++covered;
    EXPECT_EQ(DeformingScene::state(mask, k), CellState::hole) << x.transpose();
  });
  EXPECT_GT(covered, 3000);
}

/// A body of a grid within its outline and a Cartesian core: everything is interpolated, to full order.
void expect_composite(const Outline& outline, double spacing, int layers) {
  const GrownGrid grid = grow(outline, {.spacing = spacing, .layers = layers, .inward = true});
  const auto atlas = std::make_shared<const BodyAtlas>(outline, grid, true);
  const double half_width = outline.bounds().high.maxCoeff() + 4 * spacing;
  DeformingScene scene(spacing, half_width, {atlas}, composite_options<2>({atlas, grid.thickness, layers}, spacing));
  EXPECT_EQ(scene.overlap().report().tight, 0);
  EXPECT_LT(scene.step(false, 0, linear), 1e-11);
  EXPECT_LT(scene.step(false, 1, quadratic), 1e-11);
}

TEST(Composite, Stick) {
  const Outline stick = Outline::rounded_rectangle(0.1, 0.5, 0.038);
  for (const int layers : {5, 6}) {
    SCOPED_TRACE(layers);
    expect_composite(stick, 0.0125, layers);
    expect_composite(stick, 0.00625, layers);
  }
}

TEST(Composite, Disk) { expect_composite(Outline::circle(0.4), 0.025, 6); }
TEST(Composite, Ellipse) { expect_composite(Outline::ellipse(0.4, 0.25), 0.02, 6); }

TEST(Composite, PlateWithAHole) {
  constexpr double h = 0.04;
  const Outline hole = Outline::circle(0.3);
  const auto atlas = std::make_shared<const BodyAtlas>(hole, grow(hole, {.spacing = h, .layers = 6}));
  DeformingScene scene(h, 1, {atlas}, composite_options<2>({atlas, h, 6}, h));
  EXPECT_EQ(scene.overlap().report().tight, 0);
  EXPECT_LT(scene.step(false, 0, linear), 1e-11);
  EXPECT_LT(scene.step(false, 1, quadratic), 1e-11);
}

}  // namespace
}  // namespace mortise
