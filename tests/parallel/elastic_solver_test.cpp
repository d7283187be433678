// An elastic solid on many ranks is the same, bit for bit, as on one.
#include "verification/elastic_run.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(ElasticSolverOnRanks, SameBitsAsOnOneRank) {
  const PlaneWave wave{unit_speed(StressLaw::neo_hookean), Point<2>(4, 2.5), true, 0.03};
  ElasticSetup setup = disk(wave.material, 24);
  setup.tile = {8, 8};
  ElasticRun alone(setup, wave, Communicator(MPI_COMM_SELF)), together(setup, wave);
  for (int n = 0; n < 10; ++n) {
    const double dt = 0.9 / alone.solver().rate();
    EXPECT_EQ(alone.solver().rate(), together.solver().rate());
    alone.step(dt);
    together.step(dt);
    EXPECT_EQ(alone.solver().least_j(), together.solver().least_j());
  }
  std::vector<Point<2>> points;
  for (int i = 0; i < 400; ++i) points.push_back(std::sqrt(i / 410.0) * Point<2>(std::cos(2.4 * i), std::sin(2.4 * i)));
  const std::vector<ElasticState> expected = alone.solver().sample(points), found = together.solver().sample(points);
  for (std::size_t p = 0; p < points.size(); ++p) EXPECT_EQ(expected[p], found[p]) << points[p].transpose();
}

TEST(ElasticSolverOnRanks, SameInterfaceTraces) {
  const PlaneWave wave{unit_speed(StressLaw::linear), Point<2>(4, 2.5)};
  ElasticSetup setup;
  setup.name = "ring";
  setup.options.material = wave.material;
  setup.fitted = ring(0.5, 320, 20);
  setup.fitted_sides[static_cast<std::size_t>(Side::south)] = {ElasticBoundary::interface, {}};
  ElasticRun alone(setup, wave, Communicator(MPI_COMM_SELF)), together(setup, wave);
  const std::vector<ElasticTrace> expected = alone.solver().interface_traces(0.01);
  const std::vector<ElasticTrace> found = together.solver().interface_traces(0.01);
  ASSERT_EQ(expected.size(), 320U);
  ASSERT_EQ(found.size(), 320U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(expected[k].velocity, found[k].velocity);
    EXPECT_EQ(expected[k].traction, found[k].traction);
    EXPECT_EQ(expected[k].admittance, found[k].admittance);
  }
}

}  // namespace
}  // namespace mortise
