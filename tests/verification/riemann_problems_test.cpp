// The five Riemann problems of Toro's book and others, against their exact solutions, for every limiter and Riemann
// solver.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

Overrides choice(const std::string& limiter, const std::string& solver) {
  return {"fluid.limiter=" + limiter, "fluid.riemann=" + solver};
}

const std::vector<std::string> limiters = {"mc", "minmod", "van_albada"}, solvers = {"hllc", "exact", "hlle"};

/// Mean error of the density with 200 cells: at most `ceiling`, and at most `sharp` with limiter mc and solver hllc.
/// Rates in the L1 norm are means over 100 … 800 cells. A contact alone converges with 2/3, a shock or fan with 1; the
/// almost standing shock of the collision leaves waves behind that hardly decay.
struct Expected {
  const char* name;
  double ceiling, sharp, density_rate, pressure_rate;
};

class RiemannProblem : public ::testing::TestWithParam<Expected> {};

TEST_P(RiemannProblem, ConvergesForAllLimitersAndSolvers) {
  const Expected expected = GetParam();
  for (const std::string& limiter : limiters)
    for (const std::string& solver : solvers) {
      const auto errors = [&](double factor) {
        CaseRun<1> run(expected.name, choice(limiter, solver) + Overrides{set("grid.factor", factor)});
        run.run();
        EXPECT_TRUE(run.finished()) << limiter << ' ' << solver << ": " << run.reason();
        return run.errors();
      };
      auto coarse = errors(10), middle = errors(20), fine = errors(80);
      const std::string what = limiter + " " + solver;
      EXPECT_LE(middle["fluid.density"].l1, limiter == "mc" && solver == "hllc" ? expected.sharp : expected.ceiling)
          << what;
      EXPECT_GE(order(coarse["fluid.density"].l1, fine["fluid.density"].l1) / 3, expected.density_rate) << what;
      EXPECT_GE(order(coarse["fluid.pressure"].l1, fine["fluid.pressure"].l1) / 3, expected.pressure_rate) << what;
    }
}

INSTANTIATE_TEST_SUITE_P(Toro, RiemannProblem,
                         ::testing::Values(Expected{"sod", 3.8e-3, 2.2e-3, 0.79, 0.94},
                                           Expected{"riemann_123", 5.8e-3, 3.7e-3, 0.80, 0.99},
                                           Expected{"riemann_left_blast", 9.5e-2, 6.8e-2, 0.77, 1.05},
                                           Expected{"riemann_right_blast", 8.8e-2, 6.1e-2, 0.71, 0.93},
                                           Expected{"riemann_collision", 0.30, 0.20, 0.67, 0.43}),
                         [](const auto& instance) { return std::string(instance.param.name); });

std::string state(double density, double velocity, double pressure) {
  char text[128];
  std::snprintf(text, sizeof text, "[%.17g,%.17g,%.17g]", density, velocity, pressure);
  return text;
}

/// The states exchanged and turned round: the same flow, seen from the other side.
TEST(RiemannProblems, MirroredProblemGivesTheMirroredAnswer) {
  for (const std::string& limiter : limiters)
    for (const std::string& solver : solvers)
      for (const std::string name : {"sod", "riemann_left_blast", "riemann_collision"}) {
        CaseRun<1> run(name, choice(limiter, solver));
        const InitialDescription& initial = run.description.initial;
        CaseRun<1> mirrored(
            name, choice(limiter, solver) +
                      Overrides{"initial.left=" + state(initial.right[0], -initial.right[1], initial.right[3]),
                                "initial.right=" + state(initial.left[0], -initial.left[1], initial.left[3]),
                                set("initial.position", 1 - initial.position)});
        run.run();
        mirrored.run();
        const auto here = run.cells(), there = mirrored.cells();
        ASSERT_EQ(run.simulation.steps(), mirrored.simulation.steps()) << name;
        ASSERT_EQ(here.size(), there.size());
        double worst = 0;
        for (std::size_t i = 0; i < here.size(); ++i) {
          const Primitive<1>&W = here[i].W, &V = there[here.size() - 1 - i].W;
          const double c = std::sqrt(1.4 * W.pressure / W.density);
          worst = std::max({worst, std::abs(W.density / V.density - 1), std::abs(W.pressure / V.pressure - 1),
                            std::abs(W.velocity[0] + V.velocity[0]) / c});
        }
        EXPECT_LE(worst, 1e-12) << name << ' ' << limiter << ' ' << solver;
      }
}

void expect_finishes(const std::string& name, const Overrides& overrides, double density_error) {
  CaseRun<1> run(name, overrides);
  run.run();
  EXPECT_TRUE(run.finished()) << name << ' ' << overrides[0] << ' ' << overrides[1] << ": " << run.reason();
  if (!run.scene.exact) return;
  EXPECT_LT(run.errors()["fluid.density"].l1, density_error) << name << ' ' << overrides[0] << ' ' << overrides[1];
}

TEST(RiemannProblems, DensityAndPressureStayPositive) {
  const Overrides mach_10 = {"initial.kind=shock",   "initial.ahead=[1,0,1]", "initial.mach=10",
                             "initial.position=0.1", "time.end=0.06",         "boundaries.left=inflow"};
  const Overrides near_vacuum = {"initial.left=[1,-3,0.4]", "initial.right=[1,3,0.4]", "time.end=0.1"};
  for (const std::string limiter : {"none", "mc", "minmod", "van_albada"})
    for (const std::string& solver : solvers) {
      expect_finishes("sod", choice(limiter, solver) + mach_10, 0.05);
      expect_finishes("riemann_123", choice(limiter, solver) + near_vacuum, 0.02);
    }
}

/// The fans do not meet: vacuum between them.
TEST(RiemannProblems, VacuumIsSurvivedWithTheDefaultSolver) {
  const Overrides vacuum = {"exact=none", "initial.left=[1,-4.5,0.4]", "initial.right=[1,4.5,0.4]", "time.end=0.08"};
  for (const std::string& limiter : limiters) expect_finishes("riemann_123", choice(limiter, "hllc") + vacuum, 0);
}

}  // namespace
}  // namespace mortise
