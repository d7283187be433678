// The Euler solver on meshes without background: free stream, sides, walls, conservation, tiles, sampling.
#include <gtest/gtest.h>

#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/frame.hpp"
#include "unit/fluid/mesh_run.hpp"

namespace mortise {
namespace {

using namespace testing;

Primitive<2> uniform_state(const Point<2>&, double) { return {1.3, {0.7, -0.4}, 0.9}; }

/// Largest change of uniform flow over some steps.
double free_stream_error(MeshRun run, int steps) {
  for (int k = 0; k < steps; ++k) run.step();
  EXPECT_GT(run.time(), 0.2);
  return run.largest_difference(uniform_state);
}

TEST(MeshFreeStream, StaysUniformOnAWobblingStrip) {
  EXPECT_LE(free_stream_error({wobbling_square(20, 20, true), false, around_and_exact, uniform_state}, 150), 1e-13);
}

TEST(MeshFreeStream, StaysUniformOnAWobblingRing) {
  EXPECT_LE(free_stream_error({wobbling_ring(64, 16, 1), false, around_and_exact, uniform_state}, 150), 1e-13);
}

TEST(MeshFreeStream, StaysUniformBetweenFourSides) {
  EXPECT_LE(free_stream_error({wobbling_square(20, 20, false), false, all_exact, uniform_state}, 150), 1e-13);
}

TEST(MeshFreeStream, PassesInflowAndOutflow) {
  const MeshRun::Sides sides = {BoundaryKind::inflow, BoundaryKind::outflow, BoundaryKind::wall, BoundaryKind::outflow};
  EXPECT_LE(free_stream_error({wobbling_square(20, 20, false), false, sides, uniform_state}, 150), 1e-13);
}

TEST(MeshSides, TakeInflowAndLetWavesOut) {
  const MeshRun::Sides sides = {BoundaryKind::inflow, BoundaryKind::outflow, BoundaryKind::wall, BoundaryKind::outflow};
  const auto fast = [](double density) { return Primitive<2>{density, {4, 0}, 1}; };
  MeshRun run(wobbling_square(20, 12, false, 0.3), false, sides, [&](const Point<2>& x, double t) { return fast(x[0] > 0.3 + 4 * t ? 2 : 1); });
  run.run(0.5);  // all gas of the beginning has left
  EXPECT_TRUE(run.admissible());
  EXPECT_LE(run.largest_difference([&](const Point<2>&, double) { return fast(1); }), 1e-3);
}

Primitive<2> entropy_wave(const Point<2>& x, double t) {
  return {1 + 0.2 * std::sin(4 * (x[0] - 0.8 * t) + 3 * (x[1] - 0.5 * t)), {0.8, 0.5}, 1};
}

TEST(MeshSides, ExactDataFollowTheMesh) {
  StepOptions options;
  options.limiter = Limiter::none;
  std::array<double, 2> errors;
  for (const int level : {0, 1}) {
    const int n = 16 << level;
    MeshRun run(wobbling_square(n, n, false), false, all_exact, entropy_wave, {0, 0}, options);
    run.run(0.4);
    errors[static_cast<std::size_t>(level)] = run.largest_difference(entropy_wave);
  }
  EXPECT_GE(std::log2(errors[0] / errors[1]), 1.8) << errors[0] << " " << errors[1];
  EXPECT_LE(errors[1], 1e-3);
}

Primitive<2> bubbling(const Point<2>& x, double) { return wavy_state(3 * x[0], 3 * x[1]); }
/// Of period 1 in x.
Primitive<2> bubbling_strip(const Point<2>& x, double) {
  return wavy_state(std::sin(2 * std::numbers::pi * x[0]), 3 * x[1]);
}

/// A strip whose south side moves and whose north side rests, the mesh between them sheared.
MovingMesh driven_strip(int along, int layers) {
  return {along, layers, true, Point<2>(1, 0), [=](int i, int j, double t) -> Point<2> {
            const Point<2> X(static_cast<double>(i) / along, static_cast<double>(j) / layers);
            return X + (1 - X[1]) * 2 * wobble(Point<2>(X[0], 0), t);
          }};
}

/// The same between two walls at rest, along which nodes slide.
MovingMesh driven_box(int along, int layers) {
  return {along, layers, false, Point<2>(0, 0), [=](int i, int j, double t) -> Point<2> {
            const Point<2> X(static_cast<double>(i) / along, static_cast<double>(j) / layers);
            Point<2> moved = (1 - X[1]) * 2 * wobble(Point<2>(X[0], 0), t);
            moved[0] *= 4 * X[0] * (1 - X[0]);
            return X + moved;
          }};
}

TEST(MeshWalls, KeepMassAndDoTheWorkOfTheirPressure) {
  struct Closed {
    const char* name;
    MovingMesh mesh;
    MeshRun::Sides sides;
    StateFunction<2> initial;
  };
  constexpr MeshRun::Sides walls = {BoundaryKind::wall, BoundaryKind::wall, BoundaryKind::wall, BoundaryKind::wall};
  for (const Closed& closed : {Closed{"strip", driven_strip(24, 16), around_and_wall, bubbling_strip},
                               Closed{"ring", wobbling_ring(48, 12, 0), around_and_wall, bubbling},
                               Closed{"box", driven_box(24, 16), walls, bubbling}}) {
    MeshRun run(closed.mesh, true, closed.sides, closed.initial);
    const Point<2> first = run.totals();
    double work = 0, exchanged = 0;
    for (int k = 0; k < 100; ++k) {
      const double start = run.time();
      run.step();
      const std::vector<Point<2>> areas = wall_areas(run.mesh_before(), run.mesh());
      for (int i = 0; i < run.mesh().along; ++i) {
        const auto moved = [&](int node) -> Point<2> { return run.mesh().node(node, 0) - run.mesh_before().node(node, 0); };
        const double done = run.pressure()[static_cast<std::size_t>(i)] * areas[static_cast<std::size_t>(i)].dot(0.5 * (moved(i) + moved(i + 1)));
        work += done;
        exchanged += std::fabs(done);
      }
      ASSERT_GT(run.time(), start);
    }
    EXPECT_TRUE(run.admissible());
    const Point<2> last = run.totals();
    EXPECT_NEAR(last[0] / first[0], 1, 1e-13) << closed.name;
    EXPECT_GT(exchanged, 0.01 * first[1]);
    EXPECT_NEAR((last[1] - work) / first[1], 1, 1e-13) << closed.name;
  }
}

TEST(MeshWalls, AFlatNorthWallReflectsLikeAMirror) {
  const auto piston = [](const Point<2>& x, double) { return Primitive<2>{1 + 0.1 * x[1], {0, 0.3 * x[1] * (1 - x[1])}, 1}; };
  const auto still = [](int layers, double height) {
    return MovingMesh{4, layers, true, Point<2>(1, 0),
                      [=](int i, int j, double) { return Point<2>(0.25 * i, height * j / layers); }};
  };
  const auto mirrored_piston = [&](const Point<2>& x, double t) {
    Primitive<2> W = piston(Point<2>(x[0], std::min(x[1], 2 - x[1])), t);
    if (x[1] > 1) W.velocity[1] = -W.velocity[1];
    return W;
  };
  MeshRun half(still(20, 1), true, around_and_wall, piston), whole(still(40, 2), true, around_and_wall, mirrored_piston);
  for (int k = 0; k < 9; ++k) {  // two cells a step: the other end of `whole` is not felt yet
    half.step_by(0.02);
    whole.step_by(0.02);
  }
  const std::vector<double> below = half.densities(), all = whole.densities();
  for (std::size_t k = 0; k < below.size(); ++k) EXPECT_NEAR(below[k], all[k], 1e-13) << k;
}

TEST(MeshMotion, RigidAndNodeByNodeAreTheSame) {
  const auto ring = wobbling_ring(48, 12, 1).at(0);
  const auto turned = [&](double t) {
    const Pose<2> pose{Point<2>(0.3 * t, -0.1 * t), 0.5 * t};
    GrownGrid grid = *ring;
    for (Point<2>& node : grid.nodes) node = Frame<2>(pose).to_space(node);
    return std::pair(pose, std::make_shared<const GrownGrid>(std::move(grid)));
  };
  PhaseTimers timers;
  EulerSetup<2> setup;
  setup.boundaries.exact = uniform_state;
  setup.bodies.resize(1);
  setup.bodies[0].mesh = ring;
  setup.bodies[0].sides = around_and_exact;
  EulerSolver<2> rigid(Communicator(), setup, timers), deforming(Communicator(), setup, timers);
  rigid.initialize(bubbling, resting<2>({Pose<2>{}}), 0);
  deforming.initialize(bubbling, path_to(ring), 0);
  constexpr double dt = 0.003;
  for (int k = 0; k < 30; ++k) {
    const auto [start, before] = turned(k * dt);
    const auto [end, after] = turned((k + 1) * dt);
    std::vector<BodyPath<2>> path = resting<2>({start}), nodes = path_to(after);
    path[0].end = end;
    const auto advance = [&](EulerSolver<2>& solver, const std::vector<BodyPath<2>>& along) {
      return solver.step(along, {piston_pressure(solver.wall_traces(along, dt)[0], *before, *after, dt)}, dt);
    };
    ASSERT_TRUE(advance(rigid, path) && advance(deforming, nodes));
    rigid.commit(path, (k + 1) * dt);
    deforming.commit(nodes, (k + 1) * dt);
  }
  const TileShape<2>& shape = rigid.grids()[0].shape;
  for_each_cell<2>(shape, 0, [&](const Index<2>& c) {
    EXPECT_LE(distance(get<2>(rigid.fields()[0].tile(0), shape.at(c)), get<2>(deforming.fields()[0].tile(0), shape.at(c))), 1e-12);
    EXPECT_LE((rigid.cell_center(0, 0, c) - deforming.cell_center(0, 0, c)).norm(), 1e-14);
  });
}

TEST(MeshTiles, DoNotChangeABit) {
  const auto densities = [](Index<2> tile) {
    MeshRun run(driven_strip(24, 32), true, around_and_wall, bubbling_strip, tile);
    for (int k = 0; k < 20; ++k) run.step();
    return run.densities();
  };
  const std::vector<double> whole = densities({24, 32});
  for (const Index<2>& tile : {Index<2>{4, 32}, Index<2>{24, 4}, Index<2>{12, 8}, Index<2>{2, 2}}) EXPECT_EQ(densities(tile), whole) << tile[0];
}

/// Sod's problem upwards through a strip of four cells and on a line.
Primitive<1> sod(double x) { return x < 0.5 ? Primitive<1>{1, {0}, 1} : Primitive<1>{0.125, {0}, 0.1}; }
Primitive<2> sod_strip(const Point<2>& x, double) {
  const Primitive<1> W = sod(x[1]);
  return {W.density, {0, W.velocity[0]}, W.pressure};
}

TEST(MeshStrip, OfFourCellsIsALine) {
  constexpr int n = 200;
  constexpr double dt = 0.002;
  const MovingMesh still = {4, n, true, Point<2>(40.0 / n, 0), [](int i, int j, double) { return Point<2>(10.0 * i / n, 1.0 * j / n); }};
  MeshRun strip(still, true, {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::wall, BoundaryKind::outflow}, sod_strip);

  PhaseTimers timers;
  EulerSetup<1> setup;
  setup.options = StepOptions{};
  setup.boundaries.kind = {BoundaryKind::wall, BoundaryKind::outflow};
  setup.domain = {Point<1>(0), Point<1>(1)};
  setup.cells = {n};
  setup.tile = {n};
  EulerSolver<1> line(Communicator(), setup, timers);
  line.initialize([](const Point<1>& x, double) { return sod(x[0]); }, {}, 0);
  for (int k = 0; k < 100; ++k) {
    strip.step_by(dt);
    ASSERT_TRUE(line.step({}, {}, dt));
    line.commit({}, (k + 1) * dt);
  }
  const std::vector<double> densities = strip.densities();
  const TileBlock& block = line.fields()[0].tile(0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(densities[static_cast<std::size_t>(4 * j + i)], block.component(0)[line.grids()[0].shape.at(j)], 1e-12) << i << ", " << j;
}

TEST(MeshStrip, ThatBreathesFindsTheSameShockTube) {
  const auto strip_error = [](double breath) {
    constexpr int n = 100;
    const MovingMesh mesh = {4, n, true, Point<2>(40.0 / n, 0), [=](int i, int j, double t) {
                               const double X = 1.0 * j / n;
                               return Point<2>(10.0 * i / n, X + breath * std::sin(std::numbers::pi * X) * std::sin(20 * t));
                             }};
    MeshRun run(mesh, true, {BoundaryKind::periodic, BoundaryKind::periodic, BoundaryKind::wall, BoundaryKind::outflow}, sod_strip);
    run.run(0.2);
    double error = 0, volume = 0;
    run.for_each([&](const Point<2>& x, double of_cell, const Conserved<2>& U) {
      error += of_cell * std::fabs(U.density - sample(sod(0), sod(1), gamma_air, (x[1] - 0.5) / 0.2).density);
      volume += of_cell;
    });
    return error / volume;
  };
  EXPECT_LE(strip_error(0.03), 1.2 * strip_error(0));
}

TEST(MeshSampling, IsExactForLinearFlowInside) {
  const auto linear = [](const Point<2>& x, double) { return Primitive<2>{1 + x[0] - 0.5 * x[1], {0.1, 0.2}, 2}; };
  const MovingMesh slanted = {12, 20, false, Point<2>(0, 0), [](int i, int j, double) { return Point<2>(i / 12.0 + 0.3 * j / 20.0, j / 20.0 - 0.1 * i / 12.0); }};
  MeshRun run(slanted, true, all_exact, linear, {4, 10});
  const std::vector<Point<2>> points = {{0.5, 0.3}, {0.61, 0.52}, {0.7, 0.7}, {-0.5, 0.1}};
  const auto values = run.solver().sample(points);
  ASSERT_EQ(values.size(), points.size());
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(values[p][0], linear(points[p], 0).density, 1e-13) << p;
    EXPECT_NEAR(values[p][1], 0.1, 1e-13);
    EXPECT_NEAR(values[p][2], 0.2, 1e-13);
    EXPECT_NEAR(values[p][3], 2, 1e-13);
  }
  for (const double value : values[3]) EXPECT_TRUE(std::isnan(value));
}

TEST(MeshNodes, AreThoseOfTheLastStep) {
  MeshRun run(wobbling_ring(32, 8, 0.5), false, around_and_exact, uniform_state);
  for (int k = 0; k < 3; ++k) run.step();
  const MovingMesh mesh = wobbling_ring(32, 8, 0.5);
  for (const Index<2>& node : {Index<2>{0, 0}, Index<2>{32, 3}, Index<2>{7, 8}})
    EXPECT_EQ(run.solver().present_node(0, node), mesh.at(run.time())->node(node[0], node[1]));
  EXPECT_EQ(run.solver().present_node(0, {0, 5}), run.solver().present_node(0, {32, 5}));
}

TEST(MeshSolver, DoesNothingWithoutGas) {
  PhaseTimers timers;
  EulerSetup<2> setup;
  setup.bodies.resize(1);  // a solid in no gas
  EulerSolver<2> solver(Communicator(), setup, timers);
  const std::vector<BodyPath<2>> paths = resting<2>({Pose<2>{}});
  solver.initialize(nullptr, paths, 0);
  solver.measure_rates(paths, 0.1);
  EXPECT_EQ(solver.rate(), 0);
  EXPECT_TRUE(solver.wall_traces(paths, 0.1).at(0).empty());
  EXPECT_TRUE(solver.step(paths, {{}}, 0.1));
  solver.commit(paths, 0.1);
  EXPECT_FALSE(solver.has_overlap());
  EXPECT_EQ(solver.first_bad_cell(paths), "");
  EXPECT_TRUE(std::isnan(solver.sample(std::vector<Point<2>>{{0, 0}}).at(0)[0]));
  EXPECT_EQ(solver.overlap_census().orphans, 0);
}

TEST(MeshSolver, RefusesWhatDoesNotFit) {
  const auto build = [](const MovingMesh& mesh, const MeshRun::Sides& sides, Index<2> tile) { MeshRun(mesh, false, sides, uniform_state, tile); };
  EXPECT_THROW(build(wobbling_square(5, 8, true), around_and_exact, {0, 0}), InputError);       // odd
  EXPECT_THROW(build(wobbling_square(8, 8, true), around_and_exact, {3, 8}), InputError);       // does not divide
  EXPECT_THROW(build(wobbling_square(8, 8, true), all_exact, {0, 0}), InputError);              // periodic unlike its sides
  EXPECT_THROW(build(wobbling_square(8, 8, false), around_and_exact, {0, 0}), InputError);
}

TEST(MeshSolver, NamesTheBadCellWhereItWillBe) {
  MeshRun run(wobbling_square(8, 8, true), true, around_and_exact, uniform_state);
  const std::vector<BodyPath<2>> paths = path_to(wobbling_square(8, 8, true).at(1));
  ASSERT_FALSE(run.solver().step(paths, {std::vector<double>(8, 1e4)}, 1));
  EXPECT_NE(run.solver().first_bad_cell(paths).find("grid body, cell ("), std::string::npos);
}

}  // namespace
}  // namespace mortise
