// The elastic solver as a whole: overlapping grids, balances, corners, tiles left out, samples and failures.
#include "mortise/grids/core/error.hpp"
#include "verification/elastic_run.hpp"

namespace mortise {
namespace {

using namespace testing;

/// The square [−1, 1]² with a hole of radius 0.3 around the middle.
ElasticSetup plate_with_hole(const Material& material, int n) {
  const double h = 1.0 / n;
  const Outline circle = Outline::circle(0.3);
  ElasticSetup setup;
  setup.name = "plate";
  setup.options.material = material;
  setup.fitted = std::make_shared<GrownGrid>(grow(circle, {.spacing = h, .layers = 8}));
  setup.atlas = std::make_shared<BodyAtlas>(circle, *setup.fitted);
  setup.domain.include(Point<2>::Constant(-1));
  setup.domain.include(Point<2>::Constant(1));
  setup.cells = {2 * n, 2 * n};
  setup.tile = {n, n};
  setup.sides.fill({ElasticBoundary::exact, {}});
  return setup;
}

constexpr auto south = static_cast<std::size_t>(Side::south);

/// The largest error of a shear wave in the disk, whose circle follows it.
double error_on_a_disk(StressLaw law, ElasticBoundary kind, int n) {
  const PlaneWave wave{unit_speed(law), Point<2>(4, 2.5), true, 0.03};
  ElasticSetup setup = disk(wave.material, n);
  setup.exact = wave;
  setup.fitted_sides[south] = following(kind, wave.material, wave);
  ElasticRun run(setup, wave);
  run.advance_to(0.6);
  return run.largest_error(wave);
}

TEST(ElasticSolver, SecondOrderOnADiskOfTwoGrids) {
  for (const StressLaw law : {StressLaw::linear, StressLaw::neo_hookean})
    for (const ElasticBoundary kind :
         {ElasticBoundary::displacement, ElasticBoundary::traction, ElasticBoundary::exact})
      expect_order(error_on_a_disk(law, kind, 24), error_on_a_disk(law, kind, 48), 1.9);
}

/// Between prescribed sides, where nothing but the kernel's own fluxes could spoil the order.
TEST(ElasticSolver, SecondOrderOnAHyperelasticRingWithPrescribedSides) {
  const PlaneWave wave{unit_speed(StressLaw::neo_hookean), Point<2>(4, 2.5), true, 0.03};
  const auto error = [&](ElasticBoundary kind, int across) {
    ElasticSetup setup;
    setup.name = "ring";
    setup.options.material = wave.material;
    setup.fitted = ring(0.4, 6 * across, across);
    setup.fitted_sides.fill(following(kind, wave.material, wave));
    ElasticRun run(setup, wave);
    run.advance_to(0.6);
    return run.largest_error(wave);
  };
  for (const ElasticBoundary kind : {ElasticBoundary::displacement, ElasticBoundary::traction})
    expect_order(error(kind, 24), error(kind, 48), 1.9);
}

TEST(ElasticSolver, SecondOrderOnAPlateWithAHole) {
  const PlaneWave wave{unit_speed(StressLaw::linear), Point<2>(4, 2.5), false};
  const auto error = [&](int n) {
    ElasticSetup setup = plate_with_hole(wave.material, n);
    setup.exact = wave;
    setup.fitted_sides[south] = following(ElasticBoundary::traction, wave.material, wave);
    ElasticRun run(setup, wave);
    run.advance_to(0.6);
    return run.largest_error(wave);
  };
  expect_order(error(32), error(64), 1.9);
}

TEST(ElasticSolver, SamplesAreTheSolutionAndNothingOutside) {
  const PlaneWave wave{unit_speed(StressLaw::neo_hookean), Point<2>(4, 2.5), true, 0.03};
  const std::vector<Point<2>> inside = {{0.31, 0.62}, {0.93, 0.1}, {-0.5, -0.74}},
                              outside = {{1.3, 0.2}, {-1.02, -1.02}};
  const auto check = [&](ElasticSetup setup, const std::vector<Point<2>>& points, double bound) {
    setup.exact = wave;
    ElasticRun run(setup, wave);
    const std::vector<ElasticState> samples = run.solver().sample(points), nothing = run.solver().sample(outside);
    for (std::size_t p = 0; p < points.size(); ++p)
      for (std::size_t c = 0; c < 8; ++c) EXPECT_NEAR(samples[p][c], wave(points[p], 0)[c], bound) << p << ' ' << c;
    for (const ElasticState& sample : nothing) EXPECT_TRUE(std::isnan(sample[0]));
  };
  check(disk(wave.material, 24), inside, 5e-4);
  ElasticSetup annulus;
  annulus.name = "ring";
  annulus.options.material = wave.material;
  annulus.fitted = ring(0.4, 120, 16);
  check(annulus, inside, 5e-4);
  check(square(wave.material, 32, 16, ElasticBoundary::exact), {{0.31, 0.62}, {0.99, 0.01}}, 5e-4);
}

TEST(ElasticSolver, MomentumChangesByWhatTheTractionsGive) {
  const PlaneWave wave{unit_speed(StressLaw::neo_hookean), Point<2>(4, 2.5), true, 0.03};
  ElasticSetup setup;
  setup.name = "ring";
  setup.options.material = wave.material;
  const std::shared_ptr<GrownGrid> grid = ring(0.4, 64, 10);
  setup.fitted = grid;
  setup.fitted_sides.fill({ElasticBoundary::traction, [](const Point<2>& X, const Point<2>& N, double t) -> Point<2> {
                             return 0.01 * Point<2>(X.x() + t, 1 - X.y() * t) + 0.02 * X.y() * N;
                           }});
  ElasticRun run(setup, wave);
  const auto momentum = [&] {
    Point<2> sum = Point<2>::Zero();
    run.for_each_active_cell([&](int g, int t, const Index<2>& cell, const Point<2>&, const ElasticState& state) {
      sum += run.solver().cell_volume(g, t, cell) * velocity_of(state);
    });
    return sum;
  };
  Point<2> expected = momentum();
  for (int n = 0; n < 20; ++n) {
    const double dt = 0.8 / run.solver().rate(), half = run.time() + 0.5 * dt;
    for (const int layer : {0, grid->layers})
      for (int i = 0; i < grid->along; ++i) {
        const Point<2> a = grid->node(i, layer), b = grid->node(i + 1, layer);
        const BoundaryFace face = boundary_face(a, b, layer == 0 ? Side::south : Side::north);
        expected += dt * (b - a).norm() * setup.fitted_sides[south].value(face.center, face.normal, half);
      }
    run.step(dt);
  }
  EXPECT_LT((momentum() - expected).norm(), 1e-13);
}

TEST(ElasticSolver, AnInterfaceDoesWhatItIsGiven) {
  const PlaneWave wave{unit_speed(StressLaw::neo_hookean), Point<2>(4, 2.5), true, 0.03};
  ElasticSetup setup;
  setup.name = "ring";
  setup.options.material = wave.material;
  setup.fitted = ring(0.4, 160, 10);
  setup.fitted_sides[south].kind = ElasticBoundary::traction;
  ElasticRun free(setup, wave);
  setup.fitted_sides[south].kind = ElasticBoundary::interface;
  ElasticRun coupled(setup, wave);
  for (int n = 1; n <= 5; ++n) {
    const double dt = 0.8 / free.solver().rate();
    std::vector<Point<2>> traction, velocity;
    for (const ElasticTrace& trace : coupled.solver().interface_traces(dt)) {
      const BoundarySolution solution = prescribed_traction(trace, Point<2>::Zero());
      traction.push_back(solution.traction);
      velocity.push_back(solution.velocity);
    }
    free.step(dt);
    ASSERT_TRUE(coupled.solver().step(traction, velocity, dt));
    coupled.solver().commit(free.time());
  }
  std::vector<ElasticState> expected;
  free.for_each_active_cell(
      [&](int, int, const Index<2>&, const Point<2>&, const ElasticState& a) { expected.push_back(a); });
  std::size_t k = 0;
  coupled.for_each_active_cell(
      [&](int, int, const Index<2>&, const Point<2>&, const ElasticState& a) { EXPECT_EQ(a, expected[k++]); });
}

/// A smooth state without meaning: sums of waves of low wave numbers.
ElasticState smooth_noise(const Material& material, const Point<2>& X) {
  double v[2] = {0, 0};
  for (int k = 1; k < 4; ++k)
    for (int d = 0; d < 2; ++d)
      v[d] += 0.01 / k * std::sin(pi * k * X.x() + 1.7 * k * k + d) * std::cos(pi * k * X.y() + 0.9 * k - d);
  return elastic_state(material, {v[0], v[1]}, Gradient::Zero(), {0, 0});
}

/// Kinetic energy and, of a linear solid, that of the stress, times the number of cells.
double energy(const ElasticRun& run, const Material& material) {
  double sum = 0;
  run.for_each_active_cell([&](int, int, const Index<2>&, const Point<2>&, const ElasticState& a) {
    sum += 0.5 * (a[0] * a[0] + a[1] * a[1]);
    if (material.law == StressLaw::linear) {  // ½ σ : C⁻¹ σ
      const double trace = a[2] + a[4], square = a[2] * a[2] + 2 * a[3] * a[3] + a[4] * a[4];
      sum += 0.25 / material.mu * (square - material.lambda / (2 * (material.lambda + material.mu)) * trace * trace);
    }
  });
  return sum;
}

TEST(ElasticSolver, CornersOfDifferentSidesStayQuietForTenThousandSteps) {
  for (const StressLaw law : {StressLaw::linear, StressLaw::neo_hookean}) {
    const Material material = unit_speed(law);
    ElasticSetup setup = square(material, 16, 8, ElasticBoundary::slip);
    setup.sides[static_cast<std::size_t>(Side::west)] = {ElasticBoundary::exact, {}};
    setup.sides[static_cast<std::size_t>(Side::east)] = {ElasticBoundary::displacement, {}};
    setup.exact = [&](const Point<2>&, double) { return elastic_state(material, {0, 0}, Gradient::Zero(), {0, 0}); };
    ElasticRun run(setup, [&](const Point<2>& X, double) { return smooth_noise(material, X); });
    const double before = energy(run, material), dt = 0.8 / run.solver().rate();
    for (int n = 0; n < 10000 && !HasFatalFailure(); ++n) run.step(dt);
    EXPECT_LT(energy(run, material), 0.01 * before);
  }
}

/// Bit for bit, fringe cells and holes included.
void expect_same_cells(const ElasticSolver& a, const ElasticSolver& b) {
  for (std::size_t g = 0; g < a.grids().size(); ++g)
    for (int t = 0; t < a.fields()[g].tiles(); ++t) {
      const TileShape<2>& shape = a.grids()[g].shape;
      for_each_cell<2>(shape, 0, [&](const Index<2>& cell) {
        for (int c = 0; c < a.components(); ++c)
          ASSERT_EQ(a.fields()[g].tile(t).component(c)[shape.at(cell)],
                    b.fields()[g].tile(t).component(c)[shape.at(cell)]);
      });
    }
}

/// A disk in tiles of 8 × 8, most of them at rest.
ElasticSetup small_tiles(const Material& material) {
  ElasticSetup setup = disk(material, 24);
  setup.tile = {8, 8};
  return setup;
}

ElasticFunction kick(const Material& material) {
  return [material](const Point<2>& X, double) {
    const double r = (X - Point<2>(0.6, 0.7)).norm() / 0.2, v = r < 1 ? 0.01 * std::pow(1 - r * r, 3) : 0;
    return elastic_state(material, {v, -2 * v}, Gradient::Zero(), {0, 0});
  };
}

TEST(ElasticSolver, TilesAtRestAreLeftOutWithoutChangingABit) {
  for (const StressLaw law : {StressLaw::linear, StressLaw::neo_hookean}) {
    const Material material = unit_speed(law);
    ElasticSetup setup = small_tiles(material);
    ElasticRun skipping(setup, kick(material));
    setup.skip = false;
    ElasticRun all(setup, kick(material));
    const double dt = 0.9 / skipping.solver().rate();
    for (int n = 0; n < 20; ++n) {
      skipping.step(dt);
      all.step(dt);
      EXPECT_GT(skipping.solver().last_count().skipped, 0);
      EXPECT_EQ(all.solver().last_count().skipped, 0);
    }
    expect_same_cells(all.solver(), skipping.solver());
  }
}

TEST(ElasticSolver, GoesBackToTheBitFromWhateverWasCommitted) {
  const Material material = unit_speed(StressLaw::neo_hookean);
  ElasticRun straight(small_tiles(material), kick(material)), wavering(small_tiles(material), kick(material));
  const double dt = 0.9 / straight.solver().rate();
  for (int n = 1; n <= 6; ++n) {
    const auto rates = wavering.solver().rates();
    for (const int detour : {1, 4}) {
      wavering.solver().remember();
      for (int k = 0; k < detour; ++k) wavering.step(0.7 * dt);
      wavering.solver().go_back();
      EXPECT_EQ(wavering.solver().rates(), rates);
    }
    straight.step(dt);
    wavering.step(dt);
    EXPECT_GT(straight.solver().last_count().skipped, 0);
    expect_same_cells(straight.solver(), wavering.solver());
    EXPECT_EQ(straight.solver().least_j(), wavering.solver().least_j());
  }
}

template <class Failure, class Action>
void expect_message(Action action, const std::string& part) {
  try {
    action();
    FAIL() << "nothing thrown";
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find(part), std::string::npos) << failure.what();
  }
}

TEST(ElasticSolver, FailuresNameTheirPlace) {
  const Material material = unit_speed(StressLaw::neo_hookean);
  const auto rest = [&](const Point<2>&, double) { return elastic_state(material, {0, 0}, Gradient::Zero(), {0, 0}); };
  const auto inverted = [&](const Point<2>& X, double t) {
    ElasticState state = rest(X, t);
    if (X.x() > 0.5 && X.y() > 0.75) state[2] = -1;
    return state;
  };
  expect_message<NumericalError>([&] { ElasticRun(square(material, 8, 4, ElasticBoundary::slip), inverted); },
                                 "cell (4, 6) at (0.5625 0.8125): J -1");
  ElasticSetup folded;
  folded.name = "fin";
  folded.options.material = material;
  const std::shared_ptr<GrownGrid> grid = ring(0.5, 16, 4);
  grid->nodes[16 * 2 + 3] = {5, 5};
  folded.fitted = grid;
  expect_message<InputError>([&] { ElasticRun(folded, rest); }, "fin is folded at cell (");
  folded.fitted = placed_grid(9, 4, 0.1, false, [](double xi, double eta) { return Point<2>(xi, eta); });
  expect_message<InputError>([&] { ElasticRun(folded, rest); }, "9 cells");
  ElasticSetup half_periodic = square(material, 8, 4, ElasticBoundary::periodic);
  half_periodic.sides[0].kind = ElasticBoundary::slip;
  expect_message<InputError>([&] { ElasticRun(half_periodic, rest); }, "periodic");
}

}  // namespace
}  // namespace mortise
