#include "mortise/coupler/reference_map/body_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace mortise {
namespace {

using std::numbers::pi;

/// [−1, 1]² in tiles, a body, by default a disk of radius 0.5 around (0.1, 0), and what a flow makes of it.
class Scene {
 public:
  explicit Scene(int cells, const std::function<Point<2>(const Point<2>&)>& velocity,
                 std::function<Point<2>(const Point<2>&)> initial = {}, bool keeps_volume = false,
                 const Outline& outline = Outline::circle(0.5).placed({{0.1, 0}, 0}))
      : grid("background", Communicator(), {cells, cells}, {false, false}, TileShape<2>({cells / 4, cells / 4})) {
    grid.origin = {-1, -1};
    grid.spacing = {2.0 / cells, 2.0 / cells};
    const auto level_set = std::make_shared<LevelSet>(outline, 0.5 * grid.spacing.x(), 14 * grid.spacing.x());
    if (!initial) initial = [](const Point<2>& x) { return x; };
    BodyMap::Setup setup{"disk", {1, 1, 1, 1, 1.4, true}, level_set, initial};
    setup.keeps_volume = keeps_volume;
    map = std::make_unique<BodyMap>(setup, grid);
    EXPECT_TRUE(map->initialize());
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      u.emplace_back(grid.shape.plane, 0.0);
      v.emplace_back(grid.shape.plane, 0.0);
      for_each_cell<2>(grid.shape, 2, [&](const Index<2>& c) {
        const Point<2> w = velocity(center(t, c));
        u.back()[grid.shape.at(c)] = w.x();
        v.back()[grid.shape.at(c)] = w.y();
      });
    }
  }

  Point<2> center(int t, const Index<2>& c) const {
    const Index<2> first = grid.first_cell(t);
    return grid.center({first[0] + c[0], first[1] + c[1]});
  }
  void step(double dt) { ASSERT_TRUE(drift(dt)); }
  bool drift(double dt) {
    const auto velocity = [&](int t) {
      const std::size_t first = grid.shape.at(0, 0);
      return TileVelocity{u[static_cast<std::size_t>(t)].data() + first, v[static_cast<std::size_t>(t)].data() + first};
    };
    return map->drift_to_half(0.5 * dt, velocity) && map->drift_to_end(0.5 * dt, velocity);
  }
  /// Largest deviation of ξ from what it should be, inside and up to `layer` of the band.
  double error(const std::function<Point<2>(const Point<2>&)>& exact, double layer) const {
    double worst = 0;
    int cells = 0;
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      const TileBlock& block = map->field().tile(t);
      if (!block.allocated()) continue;
      for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
        const std::size_t k = grid.shape.at(c);
        if (block.component(3)[k] > layer) return;
        ++cells;
        worst = std::max(worst, (Point<2>(block.component(0)[k], block.component(1)[k]) - exact(center(t, c))).norm());
      });
    }
    EXPECT_GT(cells, 100);
    return worst;
  }
  int inside() const {
    int count = 0;
    for (int t = 0; t < grid.forest.local_count(); ++t)
      if (map->field().tile(t).allocated())
        for_each_cell<2>(grid.shape, 0,
                         [&](const Index<2>& c) { count += map->field().tile(t).component(3)[grid.shape.at(c)] == 0; });
    return count;
  }

  ComponentGrid<2> grid;
  std::unique_ptr<BodyMap> map;
  std::vector<std::vector<double>> u, v;
};

TEST(BodyMap, LinearMapsAreContinuedExactly) {
  Gradient G;
  G << 0.8, 0.1, -0.2, 1.1;
  const auto map = [G](const Point<2>& x) -> Point<2> { return G * (x - Point<2>(0.1, 0)) + Point<2>(0.1, 0); };
  const Scene scene(
      64, [](const Point<2>&) { return Point<2>::Zero(); }, map);
  EXPECT_LT(scene.error(map, scene.map->layers()), 1e-12);
  EXPECT_EQ(scene.map->orphans(), 0);
}

TEST(BodyMap, TranslationIsExactAndMovesToOtherTiles) {
  const Point<2> w(-0.4, 0.3);
  Scene scene(64, [w](const Point<2>&) { return w; });
  const int before = scene.inside();
  for (int k = 0; k < 50; ++k) scene.step(0.02);
  EXPECT_LT(scene.error([w](const Point<2>& x) -> Point<2> { return x - w; }, scene.map->layers()), 1e-11);
  EXPECT_NEAR(scene.inside(), before, 12);
  EXPECT_EQ(scene.map->orphans(), 0);
}

TEST(BodyMap, RigidRotationIsOfSecondOrder) {
  double errors[2];
  for (int level = 0; level < 2; ++level) {
    Scene scene(64 << level, [](const Point<2>& x) { return Point<2>(-x.y(), x.x()); });
    const int steps = 50 << level;
    for (int k = 0; k < steps; ++k) scene.step(1.0 / steps);
    const Eigen::Rotation2Dd back(-1.0);
    errors[level] = scene.error([&](const Point<2>& x) -> Point<2> { return back * x; }, 0);
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9);
}

/// What a checkpoint keeps, the cells inside, makes the same map again to the last bit.
void expect_resumes(Scene& scene, Scene&& fresh) {
  for (int t = 0; t < scene.grid.forest.local_count(); ++t) {
    TileBlock &here = scene.map->field().tile(t), &there = fresh.map->field().tile(t);
    if (there.allocated()) there.release();
    if (!here.allocated()) continue;
    fresh.map->field().allocate(t);
    std::ranges::copy(here.all(), there.all().begin());
  }
  fresh.map->resume();
  EXPECT_EQ(fresh.map->folded(), scene.map->folded());
  for (int t = 0; t < scene.grid.forest.local_count(); ++t) {
    TileBlock &here = scene.map->field().tile(t), &there = fresh.map->field().tile(t);
    ASSERT_EQ(here.allocated(), there.allocated());
    EXPECT_TRUE(!here.allocated() || std::ranges::equal(here.all(), there.all())) << t;
  }
}

/// The two outermost cells at the top of the disk are torn off: they hold hardly more than the ξ of the third one.
void tear(Scene& scene) {
  const TileShape<2>& shape = scene.grid.shape;
  for (int t = 0; t < scene.grid.forest.local_count(); ++t) {
    TileBlock& block = scene.map->field().tile(t);
    if (!block.allocated()) continue;
    for (int i = 0; i < shape.cells[0]; ++i) {
      int top = shape.cells[1] - 1;
      while (top > 2 && block.component(3)[shape.at(i, top)] != 0) --top;
      const Point<2> x = scene.center(t, {i, top});
      if (top <= 2 || std::abs(x.x() - 0.1) > 0.2 || x.y() < 0.4) continue;
      for (const int above : {1, 2})
        block.component(1)[shape.at(i, top - 2 + above)] =
            block.component(1)[shape.at(i, top - 2)] + 1e-3 * above * scene.grid.spacing.y();
    }
  }
}

TEST(BodyMap, TornCellsBesideTheSurfaceAreContinuedFromInside) {
  const auto rest = [](const Point<2>&) { return Point<2>::Zero(); };
  const auto identity = [](const Point<2>& x) -> Point<2> { return x; };
  Scene left(64, rest), repaired(64, rest, {}, true);
  for (Scene* scene : {&left, &repaired}) tear(*scene);
  EXPECT_FALSE(left.drift(0.1));
  EXPECT_TRUE(repaired.drift(0.1));
  EXPECT_LT(repaired.error(identity, 0), 0.2 * repaired.grid.spacing.x());
  EXPECT_EQ(left.map->repaired(), 0);
  EXPECT_GT(repaired.map->repaired(), 20);
  EXPECT_LT(repaired.map->repaired(), 60);
  expect_resumes(repaired, Scene(64, rest, {}, true));
}

/// A bar bent to a ring whose ends are `gap` cells apart, rotating.
class BentBar {
 public:
  BentBar(int cells, double gap)
      : scene(
            cells, [](const Point<2>& x) { return Point<2>(-x.y(), x.x()); }, bent, true,
            Outline::rounded_rectangle(2 * pi * radius - gap * 2.0 / cells, 0.3, 0.02)) {}

  static Point<2> bent(const Point<2>& x) { return {radius * std::atan2(x.y(), x.x()), radius - x.norm()}; }

  static constexpr double radius = 0.5;
  Scene scene;
};

// Half way between the ends of the bar, ξ is that of its middle if it is an average of theirs.
TEST(BodyMap, EndsOfABentBarStayApart) {
  for (const double gap : {1.5, 3.0, 5.0}) {
    BentBar bar(64, gap);
    Scene& scene = bar.scene;
    EXPECT_TRUE(scene.map->folded()) << gap;
    const int before = scene.inside();
    const double turn = 0.9;
    for (int k = 0; k < 45; ++k) scene.step(turn / 45);
    EXPECT_TRUE(scene.map->folded()) << gap;
    EXPECT_NEAR(scene.inside(), before, 0.02 * before) << gap;
    const Eigen::Rotation2Dd back(-turn);
    EXPECT_LT(scene.error([&](const Point<2>& x) { return BentBar::bent(back * x); }, 0), scene.grid.spacing.x())
        << gap;
    EXPECT_EQ(scene.map->repaired(), 0) << gap;
    expect_resumes(scene, BentBar(64, gap).scene);
  }
}

TEST(BodyMap, BodiesThatKeepTheirDistanceAreNotFolded) {
  const Scene disk(64, [](const Point<2>&) { return Point<2>::Zero(); });
  EXPECT_FALSE(disk.map->folded());
}

TEST(BodyMap, MemoryIsThatOfTheTilesNearTheBody) {
  const Scene scene(256, [](const Point<2>&) { return Point<2>::Zero(); });  // 16 tiles of half a unit
  int held = 0;
  for (int t = 0; t < scene.grid.forest.local_count(); ++t) {
    const bool holds = scene.map->field().tile(t).allocated();
    const Box<2> box = scene.grid.box(t);
    const Point<2> nearest = Point<2>(0.1, 0).cwiseMax(box.low).cwiseMin(box.high);
    const double reach = (scene.map->reach() + 1) * scene.grid.spacing.x();
    if ((nearest - Point<2>(0.1, 0)).lpNorm<Eigen::Infinity>() > 0.5 + reach) {
      EXPECT_FALSE(holds) << t;
    }
    if ((nearest - Point<2>(0.1, 0)).norm() < 0.5) {
      EXPECT_TRUE(holds) << t;
    }
    held += holds;
  }
  EXPECT_LE(held, 12);
  EXPECT_EQ(scene.map->memory_bytes(),
            static_cast<std::size_t>(held) * TileBlock(scene.grid.shape.plane, MapField::components).bytes());
}

TEST(LevelSet, IsTheDistance) {
  const LevelSet circle(Outline::circle(0.5), 0.01, 0.1);
  for (double r = 0; r < 0.58; r += 0.037)
    for (double a = 0; a < 2 * pi; a += 0.7)
      EXPECT_NEAR(circle(r * std::cos(a), r * std::sin(a)), r - 0.5, r < 0.02 ? 0.01 : 1e-3 / std::max(r, 0.05) * 0.1);
  EXPECT_GT(circle(3, 0), 2.3);
}

TEST(LevelSet, ShareOfTheSolidFallsFromOneToNothing) {
  EXPECT_EQ(solid_share(-1.0, 1), 1);
  EXPECT_EQ(solid_share(1.0, 1), 0);
  EXPECT_NEAR(solid_share(0.0, 1), 0.5, 1e-15);
  for (double s = -0.95; s < 1; s += 0.1) {
    EXPECT_NEAR(solid_share(s, 1) + solid_share(-s, 1), 1, 1e-14);
    EXPECT_LT(solid_share(s + 0.01, 1), solid_share(s, 1));
  }
}

}  // namespace
}  // namespace mortise
