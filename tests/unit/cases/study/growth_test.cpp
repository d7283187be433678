// The fit of a growth factor, the noise, and the cases that theory covers.
#include "mortise/cases/study/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/noise.hpp"
#include "mortise/cases/study/prediction.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription described(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_case(name, overrides, MORTISE_SOURCE_DIR "/cases");
}

/// Growth of one mode beside noise that stays, in steps of 0.1.
Growth fitted(double factor, double mode, int steps) {
  Growth growth;
  std::vector<double> times;
  for (int n = 0; n <= steps; ++n) {
    growth.energy.push_back(1 + mode * std::pow(factor, 2 * n));
    times.push_back(0.1 * n);
  }
  fit_growth(growth, times);
  return growth;
}

TEST(FitGrowth, FindsTheModeThatHasOutgrownTheNoise) {
  const Growth fast = fitted(2.9, 1e-9, 24);
  EXPECT_NEAR(fast.factor, 2.9, 0.01);
  EXPECT_NEAR(fast.dt, 0.1, 1e-14);
  EXPECT_NEAR(fast.rate, std::log(fast.factor) / 0.1, 1e-12);
  EXPECT_EQ(fast.last, 24);
  EXPECT_GT(fast.first, 12);
  EXPECT_NEAR(fitted(1.05, 1e-4, 600).factor, 1.05, 1e-5);
  EXPECT_NEAR(fitted(0.5, 1, 100).factor, 1, 1e-12);
  EXPECT_EQ(fitted(0.5, 1, 100).first, 50);
}

TEST(FitGrowth, NeedsThreeEnergies) {
  EXPECT_TRUE(std::isnan(fitted(100, 1, 1).factor));
  EXPECT_NEAR(fitted(100, 1, 3).factor, 100, 1);
}

TEST(NoiseOfDisturbances, IsAFunctionOfPlaceAndSeed) {
  const Noise<2> noise(3, 0.1, false), same(3, 0.1, false), other(4, 0.1, false), along(3, 0.1, true);
  const Point<2> x(0.3, -0.7), above(0.3, 0.9);
  EXPECT_EQ(noise.scalar(x), same.scalar(x));
  EXPECT_EQ(noise.vector(x), same.vector(x));
  EXPECT_NE(noise.scalar(x), other.scalar(x));
  EXPECT_NE(noise.scalar(x), noise.scalar(above));
  EXPECT_EQ(along.scalar(x), along.scalar(above));
  EXPECT_EQ(along.vector(x)[1], 0);
  double square = 0;
  for (int i = 0; i < 1000; ++i) square += std::pow(noise.scalar(Point<2>(0.1 * i, 0.07 * i)), 2) / 1000;
  EXPECT_NEAR(square, 1, 0.5);
}

TEST(PredictGrowth, TakesItsLineFromTheCase) {
  const auto prediction = predict_growth(described("resting_tube", {"solid.scale=0.25", "scheme=traditional"}));
  ASSERT_TRUE(prediction);
  const ElasticLine& line = std::get<ElasticLine>(prediction->line);
  EXPECT_NEAR(prediction->ratio, 0.25, 1e-14);
  EXPECT_NEAR(line.gas.impedance, 1, 1e-14);
  EXPECT_EQ(line.gas.cells, 8);
  EXPECT_NEAR(line.solid.spacing, 0.125, 1e-14);
  EXPECT_EQ(line.solid.end, FarEnd::fixed);
  EXPECT_EQ(line.gas.end, FarEnd::wall);
  EXPECT_NEAR(prediction->dt, 0.9 * 0.125 / 1.1, 1e-14);  // cells ten times as long along the wall
  EXPECT_NEAR(prediction->factor, 4 + std::sqrt(20), 1e-3);
  EXPECT_NEAR(prediction->rate, std::log(prediction->factor) / prediction->dt, 1e-12);
}

TEST(PredictGrowth, SaysWhyASceneIsNotCovered) {
  std::string reason;
  EXPECT_FALSE(predict_growth(described("sod"), &reason));
  EXPECT_EQ(reason, "not one body on a line, nor one strip");
  EXPECT_FALSE(predict_growth(described("shock_deformable_sticks"), &reason));
  EXPECT_EQ(reason, "more than one body or solid");
  EXPECT_FALSE(predict_growth(described("elastic_piston_shock"), &reason));
  EXPECT_FALSE(reason.empty());
  EXPECT_FALSE(predict_growth(described("resting_piston", {"bodies.0.fixed=[\"x\"]"}), &reason));
  EXPECT_EQ(reason, "the body is not free");
  EXPECT_TRUE(predict_growth(described("resting_piston"), &reason));
  EXPECT_EQ(reason, "");
}

TEST(MeasureGrowth, RefusesNoiseThatIsNone) {
  DisturbanceOptions options;
  options.amplitude = 0;
  EXPECT_THROW(measure_growth(described("resting_tube"), options), InputError);
  options.amplitude = 1;
  EXPECT_THROW(measure_growth(described("resting_tube"), options), InputError);
  options.amplitude = 1e-10;
  options.steps = 0;
  EXPECT_THROW(measure_growth(described("resting_tube"), options), InputError);
}

/// A run that fails is a result, too.
TEST(MeasureGrowth, SaysHowARunEnds) {
  DisturbanceOptions options;
  options.steps = 30;
  const Growth stable = measure_growth(described("resting_tube"), options);
  EXPECT_EQ(stable.status, "finished");
  EXPECT_EQ(stable.steps, 30);
  EXPECT_EQ(stable.energy.size(), 31u);
  EXPECT_EQ(stable.energy.size(), stable.amplitude.size());
  const Growth grown = measure_growth(described("resting_tube", {"scheme=traditional"}), options);
  EXPECT_EQ(grown.status, "grown");
  EXPECT_GT(grown.amplitude.back(), options.linear);
  const Growth ended = measure_growth(described("resting_tube", {"time.end=0.5"}), options);
  EXPECT_EQ(ended.reason, "the end of the case is reached");
  EXPECT_NEAR(ended.time, 0.5, 1e-14);
}

}  // namespace
}  // namespace mortise
