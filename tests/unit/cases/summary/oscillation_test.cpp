#include "mortise/cases/summary/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

struct History {
  std::vector<double> times, values;
};

/// f from 0 to `end`, in steps between 0.006 and 0.014.
History history(const std::function<double(double)>& f, double end) {
  History out;
  int k = 0;
  for (double t = 0; t < end + 0.02; t += 0.01 + 0.004 * std::sin(1.7 * k++)) {
    out.times.push_back(t);
    out.values.push_back(f(t));
  }
  return out;
}

double sine(double amplitude, double frequency, double t, double phase = 0) {
  return amplitude * std::sin(2 * std::numbers::pi * frequency * t + phase);
}

Oscillation of(const History& h, const std::array<double, 2>& window) {
  return oscillation_of(h.times, h.values, window);
}

TEST(Oscillation, FindsASineWhereverItLiesBetweenTheLines) {
  for (const double periods : {10.0, 10.25, 10.5, 10.75, 33.3})
    for (const double phase : {0.0, 1.0, 2.5}) {
      const double frequency = periods / 20;  // per time; the window is 20 long
      const Oscillation found =
          of(history([&](double t) { return 0.3 + sine(0.12, frequency, t, phase); }, 30), {10, 30});
      EXPECT_NEAR(found.frequency, frequency, 1e-4 * frequency) << periods;
      EXPECT_NEAR(found.amplitude, 0.12, 1e-4) << periods;
      EXPECT_NEAR(found.mean, 0.3, 1e-4) << periods;
      EXPECT_NEAR(found.half_range, 0.12, 1e-4) << periods;
      EXPECT_NEAR(found.rms_amplitude, 0.12, 0.003) << periods;
      EXPECT_NEAR(found.mean_frequency, frequency, 1e-3 * frequency) << periods;
    }
}

TEST(Oscillation, TakesTheLargestOfSeveralAndLeavesOutWhatIsOutsideOfTheWindow) {
  const auto f = [](double t) {
    return t < 9.9 ? 5.0 : sine(0.02, 0.43, t) + sine(0.1, 0.871, t) + sine(0.04, 1.742, t, 0.3);
  };
  const Oscillation found = of(history(f, 50), {10, 50});
  EXPECT_NEAR(found.frequency, 0.871, 1e-3);
  EXPECT_NEAR(found.amplitude, 0.1, 1e-3);
  EXPECT_GT(found.half_range, 0.11);
  EXPECT_LT(found.half_range, 0.16);
  EXPECT_NEAR(found.rms_amplitude, std::sqrt(0.02 * 0.02 + 0.1 * 0.1 + 0.04 * 0.04), 1e-3);
  EXPECT_NEAR(found.mean_frequency, (0.43 * 0.0004 + 0.871 * 0.01 + 1.742 * 0.0016) / 0.012, 1e-3);
}

TEST(Oscillation, FewPeriodsAreGoodToAThousandth) {
  const Oscillation found = of(history([](double t) { return sine(1, 0.43, t, 0.4); }, 10), {0, 10});
  EXPECT_NEAR(found.frequency, 0.43, 0.0043);
  EXPECT_NEAR(found.amplitude, 1, 0.01);
}

TEST(Oscillation, OfWhatDoesNotMoveIsNone) {
  for (const double value : {0.0, 0.3, -1e6}) {
    const Oscillation found = of(history([&](double) { return value; }, 10), {2, 8});
    EXPECT_NEAR(found.mean, value, 1e-12 * std::abs(value));
    EXPECT_EQ(found.amplitude, 0);
    EXPECT_EQ(found.frequency, 0);
    EXPECT_EQ(found.half_range, 0);
    EXPECT_EQ(found.rms_amplitude, 0);
    EXPECT_EQ(found.mean_frequency, 0);
  }
}

TEST(Oscillation, HistoryHasToCoverTheWindow) {
  const History h = history([](double t) { return t; }, 10);
  EXPECT_THROW(of(h, {5, 11}), InputError);
  EXPECT_THROW(of(h, {-1, 5}), InputError);
  EXPECT_NO_THROW(of(h, {0, 10}));
  EXPECT_THROW(oscillation_of({}, {}, {0, 1}), InputError);
}

}  // namespace
}  // namespace mortise
