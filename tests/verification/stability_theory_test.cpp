// Theory of the couplings' stability against the solvers: the growth per step of a small disturbance of a scene at rest
// is the spectral radius of the linearised step of the same scene.
#include <gtest/gtest.h>

#include "mortise/cases/study/growth.hpp"
#include "mortise/cases/study/prediction.hpp"
#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

CaseDescription described(const std::string& name, const Overrides& overrides) {
  return read_case(name, overrides, MORTISE_SOURCE_DIR "/cases");
}

/// The tube with z_s/z_f = ratio and eight cells a side.
CaseDescription tube(const std::string& scheme, const std::string& wall_velocity, double ratio,
                     const Overrides& more = {}) {
  return described(
      "resting_tube",
      Overrides{"scheme=" + scheme, "coupling.wall_velocity=" + wall_velocity, set("solid.scale", ratio)} + more);
}

double predicted(const CaseDescription& description) {
  std::string reason;
  const auto prediction = predict_growth(description, &reason);
  EXPECT_TRUE(prediction) << reason;
  return prediction ? prediction->factor : 0;
}

Growth measured(const CaseDescription& description, int steps) {
  DisturbanceOptions options;
  options.steps = steps;
  const Growth growth = measure_growth(description, options);
  EXPECT_NE(growth.status, "unstable") << growth.reason;
  return growth;
}

void expect_agreement(const CaseDescription& description, const std::string& what) {
  const double theory = predicted(description);
  EXPECT_GT(theory, 1.01) << what;
  EXPECT_LT(theory, 3) << what;
  EXPECT_NEAR(measured(description, 600).factor, theory, 0.01 * theory) << what;
}

struct Case {
  const char *scheme, *wall_velocity;
  std::vector<double> ratios;  // z_s/z_f, unstable
};
const Case unstable[] = {{"traditional", "lagged", {0.4, 0.6, 0.8, 0.95}},
                         {"traditional", "extrapolated", {0.9, 1.5, 2.0, 2.8}},
                         {"anti-traditional", "lagged", {2.5, 1.7, 1.25, 1.05}},
                         {"anti-traditional", "extrapolated", {1.1, 0.7, 0.5, 0.36}}};

TEST(StabilityTheory, DisturbancesOfAnElasticSolidGrowAsPredicted) {
  for (const Case& one : unstable)
    for (const double ratio : one.ratios)
      for (const char* cfl : {"time.cfl=0.9", "time.cfl=0.3"})
        expect_agreement(tube(one.scheme, one.wall_velocity, ratio, {cfl}),
                         std::string(one.scheme) + " " + one.wall_velocity + " " + std::to_string(ratio) + " " + cfl);
}

TEST(StabilityTheory, ProjectionAndSubiterationsLetNothingGrow) {
  for (const char* scheme : {"projection", "traditional-subiterated"})
    for (const double ratio : {1e-4, 0.1, 1.0, 10.0, 1e4})
      for (const Overrides& ends : {Overrides{}, Overrides{"solids.0.sides.back=free"}}) {
        const CaseDescription description = tube(scheme, "extrapolated", ratio, ends);
        EXPECT_LE(predicted(description), 1 + 1e-12) << scheme << " " << ratio;
        EXPECT_LE(measured(description, 300).factor, 1 + 1e-5) << scheme << " " << ratio;
      }
}

/// Where the matrix says that growth begins or ends, between two ratios.
double threshold(const Case& one, const Overrides& more, double low, double high) {
  const auto grows = [&](double ratio) {
    return predicted(tube(one.scheme, one.wall_velocity, ratio, more)) > 1 + 1e-9;
  };
  const bool below = grows(low);
  while (high > 1.0001 * low) {
    const double middle = std::sqrt(low * high);
    (grows(middle) == below ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// The measured threshold lies within 2 % of the matrix's: on either side of it the run does what theory says.
TEST(StabilityTheory, ThresholdsAreThoseOfTheory) {
  const double expected[] = {1, 3, 1, 1.0 / 3};
  for (std::size_t k = 0; k < std::size(unstable); ++k)
    for (const char* cfl : {"time.cfl=0.25", "time.cfl=0.5", "time.cfl=0.9"}) {
      const Case& one = unstable[k];
      const double z = threshold(one, {cfl}, 0.5 * expected[k], 2 * expected[k]);
      EXPECT_NEAR(z, expected[k], 0.02 * expected[k]) << one.scheme << " " << one.wall_velocity << " " << cfl;
      const bool traditional = one.scheme == std::string("traditional");
      const auto factor = [&](double ratio) {
        return measured(tube(one.scheme, one.wall_velocity, ratio, {cfl}), 1500).factor;
      };
      EXPECT_GT(factor(traditional ? z / 1.02 : z * 1.02), 1.001)
          << one.scheme << " " << one.wall_velocity << " " << cfl;
      EXPECT_LT(factor(traditional ? z * 1.02 : z / 1.02), 1.0001)
          << one.scheme << " " << one.wall_velocity << " " << cfl;
    }
}

/// Sides of different wave speeds: the faster one takes several steps within one of the other.
TEST(StabilityTheory, StepsOfTheFasterSideAreInTheTheory) {
  for (const char* speed : {"solids.0.material.density=0.0625", "solids.0.material.density=16"})  // c_p = 4, 1/4
    for (const double ratio : {0.55, 0.8}) {
      const double scale = ratio * (speed[std::string(speed).size() - 1] == '5' ? 4 : 0.25);
      expect_agreement(tube("traditional", "lagged", scale, {speed}), std::string(speed) + " " + std::to_string(ratio));
      EXPECT_LE(predicted(tube("projection", "lagged", scale, {speed})), 1 + 1e-12);
    }
}

/// A free solid on gas swings; lagged velocities feed the swing at any ratio of impedances, slowly.
TEST(StabilityTheory, LaggedVelocitiesFeedTheSwingOfAFreeSolid) {
  for (const double ratio : {2.0, 5.0}) {
    const CaseDescription description = tube("traditional", "lagged", ratio, {"solids.0.sides.back=free"});
    const double theory = predicted(description) - 1;
    EXPECT_GT(theory, 1e-3) << ratio;
    EXPECT_NEAR(measured(description, 4000).factor - 1, theory, 0.05 * theory) << ratio;
  }
}

/// Waves along the wall, whose nodes follow in part, grow faster than plane ones, and for heavier solids.
TEST(StabilityTheory, WavesAlongTheWallGrowBeyondThePlaneOnes) {
  for (const double ratio : {0.8, 1.1, 1.2}) {
    const CaseDescription description = tube("traditional", "lagged", ratio);
    DisturbanceOptions options;
    options.along_wall = true;
    const double factor = measure_growth(description, options).factor;
    const auto prediction = predict_growth(description);
    EXPECT_GT(factor, prediction->factor + 0.05) << ratio;
    EXPECT_LT(factor, prediction->along_wall) << ratio;
    options.steps = 600;
    EXPECT_LE(measure_growth(tube("projection", "lagged", ratio), options).factor, 1 + 1e-5) << ratio;
  }
}

/// β = z Δt/m.
CaseDescription piston(const std::string& scheme, double beta) {
  const auto with_mass = [&](double mass) {
    return described("resting_piston", {"scheme=" + scheme, set("bodies.0.mass", mass), "grid.factor=2"});
  };
  const auto prediction = predict_growth(with_mass(1));
  return with_mass(1 / (beta * prediction->ratio));
}

TEST(StabilityTheory, RigidPistonGrowsAsPredicted) {
  for (const double beta : {2.1, 2.5, 3.9}) expect_agreement(piston("traditional", beta), std::to_string(beta));
  for (const double beta : {0.1, 1.0, 2.5, 10.0, 1000.0}) {
    EXPECT_LE(predicted(piston("rigid", beta)), 1 + 1e-12) << beta;
    EXPECT_LE(measured(piston("rigid", beta), 200).factor, 1 + 1e-5) << beta;
  }
}

TEST(StabilityTheory, RigidPistonThreshold) {
  EXPECT_GT(measured(piston("traditional", 2.04), 600).factor, 1.02);
  EXPECT_LT(measured(piston("traditional", 1.96), 600).factor, 1.0001);
}

}  // namespace
}  // namespace mortise
