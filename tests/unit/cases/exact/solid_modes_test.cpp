#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/annulus_mode.hpp"
#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/plane_waves.hpp"
#include "mortise/cases/exact/rayleigh_wave.hpp"
#include "unit/cases/exact/solid_checks.hpp"

namespace mortise {
namespace {

using testing::elastic_defect;

const Material soft{StressLaw::linear, 0.7, 1.3, 0.6};

TEST(PlaneWaves, EveryKindAndProfileIsElastic) {
  for (const PlaneWaveKind kind : {PlaneWaveKind::pressure, PlaneWaveKind::shear})
    for (const WaveProfile profile : {WaveProfile::sine, WaveProfile::pulse, WaveProfile::gaussian}) {
      const PlaneWaves solution(soft, {{kind, profile, 0.8, 0.02, 0.1, 0.9}, {kind, profile, -2.1, 0.01, 0, 1.4}});
      EXPECT_FALSE(solution.describes_fluid());
      EXPECT_GT(solution.solid({0.25, -0.15}, 0.1).velocity.norm(), 1e-3);
      for (const Point<2>& X : {Point<2>(0.25, -0.15), Point<2>(-0.4, 0.3), Point<2>(0.05, 0.07)})
        EXPECT_LT(elastic_defect(solution, soft, X, 0.1), 1e-8);
    }
}

TEST(PlaneWaves, TravelWithTheirSpeeds) {
  const double c_p = std::sqrt(2.5 / 0.7), c_s = std::sqrt(0.6 / 0.7);
  for (const auto& [kind, c] : {std::pair{PlaneWaveKind::pressure, c_p}, std::pair{PlaneWaveKind::shear, c_s}}) {
    const PlaneWaves solution(soft, {{kind, WaveProfile::pulse, 0, 0.02, 0, 0.5}});
    EXPECT_NEAR((solution.solid({0.1, 0}, 0).stress - solution.solid({0.1 + 2 * c, 5}, 2).stress).norm(), 0, 1e-15);
    EXPECT_EQ(solution.solid({0.26, 0}, 0).stress.norm(), 0);
    const Point<2> u = solution.solid({0, 0}, 0).displacement;
    EXPECT_NEAR(kind == PlaneWaveKind::pressure ? u[0] : u[1], 0.02, 1e-15);
  }
}

TEST(AnnulusMode, HasTheKnownFrequencyAndFixedFaces) {
  const AnnulusMode solution(AnnulusModeProblem{});
  EXPECT_NEAR(solution.wave_number(), 6.39315676, 5e-9);
  for (const double t : {0.0, 0.3}) {
    EXPECT_NEAR(solution.solid({0.3, 0.4}, t).displacement.norm(), 0, 1e-16);
    EXPECT_NEAR(solution.solid({-0.6, 0.8}, t).displacement.norm(), 0, 1e-15);
  }
  double largest = 0;
  for (double r = 0.5; r < 1; r += 1e-3) largest = std::max(largest, solution.solid({r, 0}, 0).displacement[0]);
  EXPECT_NEAR(largest, 0.01, 1e-7);
}

TEST(AnnulusMode, IsElasticInEveryMode) {
  for (const int mode : {1, 2, 5}) {
    const AnnulusMode solution(AnnulusModeProblem{soft, 0.5, 1, mode, 0.01});
    for (const Point<2>& X : {Point<2>(0.6, 0.2), Point<2>(-0.1, 0.8), Point<2>(0.4, -0.5)})
      EXPECT_LT(elastic_defect(solution, soft, X, 0.2), 1e-6) << mode;
  }
  EXPECT_NEAR(AnnulusMode(AnnulusModeProblem{soft, 0.5, 1, 5, 0.01}).wave_number(), 5 * 2 * std::numbers::pi, 0.1);
}

TEST(RayleighWave, HasTheKnownSpeed) {
  EXPECT_NEAR(rayleigh_speed_ratio(1, 1), 0.9194016867, 1e-10);
  EXPECT_NEAR(RayleighWave(RayleighWaveProblem{{StressLaw::linear, 4, 2, 2}}).speed(), 0.9194016867 / std::sqrt(2),
              1e-10);
}

TEST(RayleighWave, IsElasticAndLeavesItsSurfaceFree) {
  const double angle = 0.5;
  const RayleighWave solution(RayleighWaveProblem{soft, 0.8, 0.02, angle, {0.1, 0.2}});
  const Point<2> along_surface = direction(angle), outward = left_of(along_surface);
  for (const double s : {-0.3, 0.1, 0.6}) {
    const Point<2> surface = Point<2>(0.1, 0.2) + s * along_surface;
    EXPECT_NEAR((solution.solid(surface, 0.4).stress * outward).norm(), 0, 1e-15);
    EXPECT_LT(elastic_defect(solution, soft, surface - 0.1 * outward, 0.4), 1e-8);
    EXPECT_LT(solution.solid(surface - 5 * outward, 0.4).displacement.norm(), 1e-6);
  }
  EXPECT_GT(solution.solid({0.1, 0.2}, 0.4).stress.norm(), 0.01);
}

}  // namespace
}  // namespace mortise
