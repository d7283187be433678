// Numbers that studies derive: orders, Pareto fronts, seconds for equal error; and what they are asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/cost.hpp"
#include "mortise/cases/study/scheme_variant.hpp"
#include "mortise/cases/study/stability.hpp"
#include "mortise/cases/study/stability_map.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

CaseDescription shipped(const std::string& name) { return read_case(name, {}, MORTISE_SOURCE_DIR "/cases"); }

CostPoint point(double seconds, double error, const std::string& status = "finished") {
  CostPoint p;
  p.seconds = seconds, p.error = error, p.status = status;
  return p;
}

TEST(FittedOrder, IsThePowerOfTheSpacing) {
  const std::vector<double> h = {0.1, 0.05, 0.025};
  EXPECT_NEAR(*fitted_order(h, {3e-2, 3e-2 / 4, 3e-2 / 16}), 2, 1e-12);
  EXPECT_NEAR(*fitted_order(h, {1, NAN, 1.0 / 16}), 2, 1e-12);  // a run that failed is left out
  EXPECT_FALSE(fitted_order(h, {1, NAN, NAN}));
  EXPECT_FALSE(fitted_order(h, {0, 0, 0}));
}

TEST(Variation, DoublesTheCasesOwnValueOrTakesAList) {
  const CaseDescription piston = shipped("elastic_piston");
  EXPECT_EQ(variation("grid.factor", 3, piston).values, (std::vector<double>{4, 8, 16}));
  const Variation listed = variation("solid.scale=0.1,1,1e1", 3, piston);
  EXPECT_EQ(listed.key, "solid.scale");
  EXPECT_EQ(listed.values, (std::vector<double>{0.1, 1, 10}));
  EXPECT_THROW(variation("gas.gamma", 3, piston), InputError);
  EXPECT_THROW(variation("grid.factor=4,eight", 3, piston), InputError);
}

TEST(ParetoFront, HoldsWhatNothingBeatsInBoth) {
  std::vector<CostPoint> points = {point(1, 1), point(2, 0.5), point(3, 0.6), point(0.5, 0.1, "unstable"),
                                   point(4, NAN)};
  mark_pareto_front(points);
  std::vector<bool> front;
  for (const CostPoint& p : points) front.push_back(p.on_front);
  EXPECT_EQ(front, (std::vector<bool>{true, true, false, false, false}));
}

TEST(SecondsForEqualError, AreInterpolatedInLogarithms) {
  const std::vector<CostPoint> curve = {point(1, 1), point(4, 0.25), point(16, 0.0625), point(0.1, 0.01, "unstable")};
  EXPECT_NEAR(seconds_for(curve, 0.5), 2, 1e-12);
  EXPECT_NEAR(seconds_for(curve, 0.125), 8, 1e-12);
  EXPECT_TRUE(std::isnan(seconds_for(curve, 0.01)));
  EXPECT_TRUE(std::isnan(seconds_for(curve, 2)));
}

TEST(Bisection, FindsWhereGrowthBeginsOrEnds) {
  EXPECT_NEAR(bisected(0.1, 10, 1e-3, [](double x) { return x < 3; }), 3, 3e-3);
  EXPECT_NEAR(bisected(0.1, 10, 1e-3, [](double x) { return x > 0.5; }), 0.5, 1e-3);
  EXPECT_TRUE(std::isnan(bisected(0.1, 10, 1e-3, [](double) { return false; })));
}

/// The part of a map that is stable, by theory of a shipped case.
double stable_part(const std::string& name, const std::string& scheme) {
  const CaseDescription description = read_case(name, {"scheme=" + scheme}, MORTISE_SOURCE_DIR "/cases");
  const StabilityMap map = stability_map(scheme, *predict_growth(description), description.cfl);
  double stable = 0;
  for (const double factor : map.factor) stable += factor <= growing;
  return stable / static_cast<double>(map.factor.size());
}

TEST(StabilityMap, ProjectionIsStableEverywhere) {
  const CaseDescription tube = shipped("resting_tube");
  const StabilityMap map = stability_map("projection", *predict_growth(tube), tube.cfl);
  EXPECT_LE(largest_factor(map), 1 + 1e-12);
  EXPECT_EQ(map.factor.size(), map.ratio.size() * map.cfl.size());
  EXPECT_DOUBLE_EQ(map.ratio.front(), 1e-6);
  EXPECT_DOUBLE_EQ(map.ratio.back(), 1e6);
  EXPECT_DOUBLE_EQ(map.cfl.back(), 1);
}

TEST(StabilityMap, TraditionalEndsAtItsThreshold) {
  // z_s = 3 z_f and m = z Δt/2, over twelve and six decades.
  EXPECT_NEAR(stable_part("resting_tube", "traditional"), 0.5 - std::log10(3.0) / 12, 0.02);
  EXPECT_NEAR(stable_part("resting_piston", "traditional"), 0.5 + std::log10(2.0) / 6, 0.02);
  EXPECT_EQ(stable_part("resting_piston", "rigid"), 1);
}

TEST(SchemeVariants, SaySubstepsAndLagging) {
  const CaseDescription piston = shipped("elastic_piston");
  EXPECT_EQ(
      scheme_variant("traditional+lagged", piston).overrides,
      (std::vector<std::string>{"scheme=traditional", "coupling.substeps=false", "coupling.wall_velocity=lagged"}));
  EXPECT_EQ(scheme_variant("projection+substeps+linear", piston).overrides.size(), 4u);
  EXPECT_EQ(scheme_variant("rigid", shipped("rigid_piston")).overrides, (std::vector<std::string>{"scheme=rigid"}));
}

TEST(SchemeVariants, RefuseWhatTheSceneCannotRun) {
  EXPECT_THROW(scheme_variant("rigid", shipped("elastic_piston")), InputError);
  EXPECT_THROW(scheme_variant("projection", shipped("rigid_piston")), InputError);
  EXPECT_THROW(scheme_variant("projection+subteps", shipped("elastic_piston")), InputError);
  EXPECT_THROW(scheme_variant("rigid+lagged", shipped("rigid_piston")), InputError);
  EXPECT_THROW(scheme_variants("projection,,traditional", shipped("elastic_piston")), InputError);
  EXPECT_THROW(default_schemes(shipped("sod")), InputError);
}

}  // namespace
}  // namespace mortise
