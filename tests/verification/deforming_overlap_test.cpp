// A body grid that deforms over a background while gas passes through it: the exact answer knows nothing of the grids.
#include <gtest/gtest.h>

#include <numbers>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/euler_solver.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

/// Nodes of an ellipse that breathes, wobbles and drifts, clockwise.
std::vector<Point<2>> wobbling_ellipse(int along, double t) {
  std::vector<Point<2>> curve;
  for (int i = 0; i < along; ++i) {
    const double angle = -2 * pi * i / along;
    const double swell = 1 + 0.1 * std::sin(3 * t) + 0.06 * std::sin(3 * angle + 4 * t);
    curve.emplace_back(0.1 * std::sin(2 * t) + 0.5 * swell * std::cos(angle), 0.35 * swell * std::sin(angle) - 0.05 * t);
  }
  return curve;
}

class WobblingScene {
 public:
  WobblingScene(int n, StateFunction<2> exact, StepOptions options)
      : along_(n),
        growth_{.spacing = 4.0 / n, .layers = 9},
        exact_(std::move(exact)),
        solver_(Communicator(), setup(n, options), timers_) {
    solver_.initialize(exact_, path_at(0), 0);
    solver_.measure_rates(path_at(1e-6), 1e-6);
  }

  void run(double end) {
    while (time_ < end) {
      const double dt = std::min(0.9 / solver_.rate(), end - time_);
      const std::vector<BodyPath<2>> paths = path_at(time_ + dt);
      ASSERT_TRUE(solver_.step(paths, {{}}, dt)) << solver_.first_bad_cell(paths);
      time_ += dt;
      ++steps_;
      solver_.commit(paths, time_);
    }
  }
  int steps() const { return steps_; }
  /// Largest error of ρ, u and p̃ in active cells.
  double largest_error() const {
    double largest = 0;
    for (std::size_t g = 0; g < solver_.grids().size(); ++g)
      for (int t = 0; t < solver_.fields()[g].tiles(); ++t) {
        const ComponentGrid<2>& grid = solver_.grids()[g];
        const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
        if (mask.hole) continue;
        for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
          const std::size_t k = grid.shape.at(c);
          if (mask.cut() && !mask.active[k]) return;
          const Primitive<2> W = to_primitive(get<2>(solver_.fields()[g].tile(t), k), 1.4);
          const Primitive<2> E = exact_(solver_.cell_center(static_cast<int>(g), t, c), time_);
          largest = std::max({largest, std::fabs(W.density - E.density), std::fabs(W.velocity[0] - E.velocity[0]),
                              std::fabs(W.velocity[1] - E.velocity[1]), std::fabs(W.pressure - E.pressure)});
        });
      }
    return largest;
  }

 private:
  std::vector<BodyPath<2>> path_at(double t) const {
    BodyPath<2> path;
    path.end_atlas = atlas_at(t);
    path.end_mesh = std::shared_ptr<const GrownGrid>(path.end_atlas, &path.end_atlas->grid());
    return {path};
  }
  std::shared_ptr<const BodyAtlas> atlas_at(double t) const {
    return std::make_shared<const BodyAtlas>(grow_from(wobbling_ellipse(along_, t), growth_, 2));
  }
  EulerSetup<2> setup(int n, const StepOptions& options) const {
    EulerSetup<2> setup;
    setup.options = options;
    setup.boundaries.kind.fill(BoundaryKind::exact);
    setup.boundaries.exact = exact_;
    setup.domain = {Point<2>(-2, -2), Point<2>(2, 2)};
    setup.cells = {n, n};
    setup.tile = {n / 2, n / 4};
    setup.bodies.resize(1);
    setup.bodies[0].name = "ellipse";
    setup.bodies[0].shape = {atlas_at(0), growth_.spacing, growth_.layers};
    setup.bodies[0].wall = false;
    return setup;
  }

  int along_;
  GrowthOptions growth_;
  StateFunction<2> exact_;
  PhaseTimers timers_;
  EulerSolver<2> solver_;
  double time_ = 0;
  int steps_ = 0;
};

TEST(DeformingOverlap, KeepsUniformFlowToRoundOff) {
  for (const Limiter limiter : {Limiter::none, Limiter::mc, Limiter::van_albada}) {
    StepOptions options;
    options.limiter = limiter;
    WobblingScene scene(
        56,
        [](const Point<2>&, double) {
          return Primitive<2>{1.3, {0.7, -0.4}, 0.9};
        },
        options);
    scene.run(2);
    EXPECT_GT(scene.steps(), 80);
    EXPECT_LE(scene.largest_error(), 1e-13);
  }
}

TEST(DeformingOverlap, CarriesAnEntropyWaveAtSecondOrder) {
  const auto wave = [](const Point<2>& x, double t) {
    return Primitive<2>{1 + 0.2 * std::sin(2 * (x[0] - 0.8 * t) + 1.5 * (x[1] - 0.5 * t)), {0.8, 0.5}, 1};
  };
  StepOptions options;
  options.limiter = Limiter::none;
  std::array<double, 2> errors;
  for (const std::size_t level : {0u, 1u}) {
    WobblingScene scene(56 << level, wave, options);
    scene.run(0.8);
    errors[level] = scene.largest_error();
  }
  EXPECT_GE(std::log2(errors[0] / errors[1]), 1.9) << errors[0] << " " << errors[1];
  EXPECT_LE(errors[1], 1e-3);
}

}  // namespace
}  // namespace mortise
