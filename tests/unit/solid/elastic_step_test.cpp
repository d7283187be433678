#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "unit/solid/elastic_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;

template <class Check>
void for_all_options(Check check) {
  for (const StressLaw law : all_laws)
    for (const ElasticLimiter limiter : all_limiters) {
      SCOPED_TRACE(::testing::Message() << "law " << int(law) << " limiter " << int(limiter));
      check(elastic_options(law, limiter));
    }
}
SolidTile noisy_tile(StressLaw law, Index<2> cells, bool curvilinear, double size = 0.1) {
  SolidTile tile(law, cells, [=](int i, int j) { return noisy_state(law, size, i, j); });
  if (curvilinear) tile.place([=](int i, int j) { return wavy_node(i, j, 12, 12, 0.2); });
  return tile;
}

TEST(ElasticStep, ComponentsByLaw) {
  EXPECT_EQ(elastic_components(StressLaw::linear), 7);
  EXPECT_EQ(elastic_components(StressLaw::neo_hookean), 8);
  EXPECT_EQ(displacement_component(StressLaw::linear), 5);
  EXPECT_EQ(displacement_component(StressLaw::saint_venant_kirchhoff), 6);
}

TEST(ElasticStep, UniformStatesStayUniform) {
  for_all_options([](const ElasticOptions& o) {
    const StressLaw law = o.material.law;
    const Numbers W = law == StressLaw::linear ? Numbers{0.7, -0.4, 0.31, -0.22, 0.13, 0, 0}
                                               : Numbers{0.7, -0.4, 1.17, 0.23, -0.31, 0.91, 0, 0};
    for (const bool curvilinear : {false, true}) {
      SolidTile tile(law, {12, 6}, [&](int, int) { return W; });
      if (curvilinear) tile.place([](int i, int j) { return wavy_node(i, j, 12, 6, 0.3); });
      const double dt = 0.3;
      EXPECT_TRUE(elastic_step(tile.tile(), dt, o).admissible);
      Numbers expected = W;
      const auto u = static_cast<std::size_t>(displacement_component(law));
      expected[u] += dt * W[0], expected[u + 1] += dt * W[1];
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 12; ++i) EXPECT_LE(distance(tile.after(i, j), expected), curvilinear ? 4e-15 : 0);
    }
  });
}

TEST(ElasticStep, MirroredProblemHasTheMirroredAnswerToTheBit) {
  const int nx = 20, ny = 6;
  for_all_options([](const ElasticOptions& o) {
    const StressLaw law = o.material.law;
    const auto mirrored = [law](Numbers W) {
      W[0] = -W[0], W[3] = -W[3];
      if (law != StressLaw::linear) W[4] = -W[4];
      const auto u = static_cast<std::size_t>(displacement_component(law));
      W[u] = -W[u];
      return W;
    };
    SolidTile tile = noisy_tile(law, {nx, ny}, false);
    SolidTile image(law, {nx, ny}, [&](int i, int j) { return mirrored(noisy_state(law, 0.1, nx - 1 - i, j)); });
    EXPECT_EQ(elastic_step(tile.tile(), 0.3, o).rate, elastic_step(image.tile(), 0.3, o).rate);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) EXPECT_EQ(tile.after(i, j), mirrored(image.after(nx - 1 - i, j))) << i << " " << j;
  });
}

TEST(ElasticStep, ExchangingTheAxesExchangesTheAnswer) {
  for_all_options([](const ElasticOptions& o) {
    const StressLaw law = o.material.law;
    const auto exchanged = [law](Numbers W) {
      std::swap(W[0], W[1]);
      if (law == StressLaw::linear) std::swap(W[2], W[4]), std::swap(W[5], W[6]);
      if (law != StressLaw::linear) std::swap(W[2], W[5]), std::swap(W[3], W[4]), std::swap(W[6], W[7]);
      return W;
    };
    SolidTile tile = noisy_tile(law, {8, 10}, false);
    SolidTile turned(law, {10, 8}, [&](int i, int j) { return exchanged(noisy_state(law, 0.1, j, i)); });
    elastic_step(tile.tile(1, 2), 0.3, o);
    elastic_step(turned.tile(2, 1), 0.3, o);
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 8; ++i) EXPECT_LT(distance(tile.after(i, j), exchanged(turned.after(j, i))), 1e-14);
  });
}

TEST(ElasticStep, TileSizeAndPlaceDoNotChangeABit) {
  for_all_options([](const ElasticOptions& o) {
    for (const bool curvilinear : {false, true}) {
      const StressLaw law = o.material.law;
      SolidTile whole = noisy_tile(law, {24, 12}, curvilinear);
      const ElasticStepResult all = elastic_step(whole.tile(), 0.1, o);
      ElasticStepResult most{0, true, 1e9};
      for (const int first : {0, 10, 12, 20})
        for (const int row : {0, 5}) {
          const int nx = first == 0 ? 10 : first == 10 ? 2 : first == 12 ? 8 : 4, ny = row == 0 ? 5 : 7;
          SolidTile part(law, {nx, ny}, [&](int i, int j) { return noisy_state(law, 0.1, i + first, j + row); });
          if (curvilinear) part.place([&](int i, int j) { return wavy_node(i + first, j + row, 12, 12, 0.2); });
          const ElasticStepResult result = elastic_step(part.tile(), 0.1, o);
          most.rate = std::max(most.rate, result.rate), most.least_j = std::min(most.least_j, result.least_j);
          for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) EXPECT_EQ(part.after(i, j), whole.after(i + first, j + row));
        }
      EXPECT_EQ(most.rate, all.rate);
      EXPECT_EQ(most.least_j, all.least_j);
    }
  });
}

TEST(ElasticStep, DependsOnCellsWithinTwoStepsAndNoOthers) {
  const int n = 12, ic = 6, jc = 5;
  for (const StressLaw law : all_laws)
    for (const bool curvilinear : {false, true}) {
      SolidTile tile = noisy_tile(law, {n, n}, curvilinear), changed = noisy_tile(law, {n, n}, curvilinear);
      for (int c = 0; c < tile.components; ++c) changed.now.component(c)[changed.shape.at(ic, jc)] += 0.01 + 0.002 * c;
      elastic_step(tile.tile(), 0.1, elastic_options(law));
      elastic_step(changed.tile(), 0.1, elastic_options(law));
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          EXPECT_EQ(std::abs(i - ic) + std::abs(j - jc) <= 2, tile.after(i, j) != changed.after(i, j)) << i << " " << j;
    }
}

TEST(ElasticStep, InactiveCellsKeepTheirValueAndDoNotCount) {
  const auto hole = [](int i, int j) { return i >= 6 && i < 13 && j >= 2 && j < 5; };
  for (const StressLaw law : all_laws)
    for (const bool curvilinear : {false, true}) {
      SolidTile tile = noisy_tile(law, {20, 8}, curvilinear), full = noisy_tile(law, {20, 8}, curvilinear);
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 20; ++i) tile.active[tile.shape.at(i, j)] = !hole(i, j);
      for (int c = 0; c < tile.components; ++c)  // far from the cells that count
        tile.now.component(c)[tile.shape.at(9, 3)] = std::numeric_limits<double>::quiet_NaN();
      tile.active[tile.shape.at(9, 1)] = tile.active[tile.shape.at(9, 5)] = 0;
      const ElasticStepResult result = elastic_step(tile.masked(), 0.1, elastic_options(law));
      EXPECT_TRUE(result.admissible);
      elastic_step(full.tile(), 0.1, elastic_options(law));
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 20; ++i) {
          if (i == 9 && j == 3) continue;
          const bool kept = hole(i, j) || (i == 9 && (j == 1 || j == 5));
          EXPECT_EQ(tile.after(i, j), kept ? tile.before(i, j) : full.after(i, j)) << i << " " << j;
        }
    }
}

TEST(ElasticStep, ReportsInadmissibleStatesOfActiveCellsOnly) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const StressLaw law : all_laws) {
    const ElasticOptions o = elastic_options(law);
    for (int c = 0; c < elastic_components(law); ++c)
      for (const int i : {0, 5, 9}) {
        SolidTile tile = noisy_tile(law, {10, 6}, false);
        tile.now.component(c)[tile.shape.at(i, 3)] = nan;
        EXPECT_FALSE(elastic_step(tile.tile(), 0.1, o).admissible);
        EXPECT_FALSE(elastic_rate(tile.tile(), o).admissible);
        tile.active[tile.shape.at(i, 3)] = 0;
        EXPECT_TRUE(elastic_rate(tile.masked(), o).admissible);
      }
    if (law == StressLaw::linear) continue;
    SolidTile tile = noisy_tile(law, {10, 6}, false);
    tile.now.component(2)[tile.shape.at(4, 3)] = -1;  // inside out
    EXPECT_FALSE(elastic_rate(tile.tile(), o).admissible);
    EXPECT_LT(elastic_rate(tile.tile(), o).least_j, -0.5);
    EXPECT_FALSE(elastic_step(tile.tile(), 0.001, o).admissible);
  }
}

TEST(ElasticStep, RateAndLeastJAreThoseOfTheNewState) {
  for_all_options([](const ElasticOptions& o) {
    for (const bool curvilinear : {false, true}) {
      SolidTile tile = noisy_tile(o.material.law, {20, 8}, curvilinear);
      const ElasticStepResult step = elastic_step(tile.tile(0.1, 0.2), 0.01, o);
      tile.accept();
      const ElasticStepResult state = elastic_rate(tile.tile(0.1, 0.2), o);
      EXPECT_EQ(step.rate, state.rate);
      EXPECT_EQ(step.least_j, state.least_j);
    }
  });
}

TEST(ElasticStep, RateIsTheSumOfWaveSpeedsOverSpacings) {
  for (const StressLaw law : all_laws) {
    const ElasticOptions o = elastic_options(law);
    SolidTile tile(law, {4, 2}, [&](int, int) { return at_rest(law); });
    const double speed = o.material.pressure_wave_speed();
    EXPECT_NEAR(elastic_rate(tile.tile(0.1, 0.2), o).rate, speed * (10 + 5), 1e-13);
    tile.place([](int i, int j) { return Point<2>(0.1 * i + 0.04 * j, 0.2 * j); });
    // |S| of the slanted faces is √(0.2² + 0.04²), the area of a cell 0.02
    EXPECT_NEAR(elastic_rate(tile.tile(), o).rate, speed * (std::hypot(0.2, 0.04) + 0.1) / 0.02, 1e-12);
  }
  const ElasticOptions o = elastic_options(StressLaw::neo_hookean);
  SolidTile tile(StressLaw::neo_hookean, {4, 2}, [&](int, int) { return Numbers{0, 0, 1.2, 0.1, -0.2, 0.9, 0, 0}; });
  double rate = 0;
  const Gradient F = (Gradient() << 1.2, 0.1, -0.2, 0.9).finished();
  for (const auto& [N, h] : {std::pair{Point<2>(1, 0), 0.1}, {Point<2>(0, 1), 0.2}}) {
    const Eigen::Matrix2d A = acoustic_tensor(o.material, F, N);
    const double m = 0.5 * A.trace(), largest = m + std::sqrt(m * m - A.determinant());
    rate += std::sqrt(largest / o.material.density) / h;
  }
  EXPECT_NEAR(elastic_rate(tile.tile(0.1, 0.2), o).rate, rate, 1e-12);
}

}  // namespace
}  // namespace mortise
