// Gas and elastic solids as one continuum, beside the same case files under interface projection.
#include <gtest/gtest.h>

#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/driver/totals.hpp"
#include "mortise/solid/elastic_measures.hpp"
#include "verification/case_runner.hpp"

namespace mortise::testing {
namespace {

const Overrides mapped = {"scheme=reference-map"};

/// Largest speed of any cell.
double fastest(const Simulation<2>& simulation) {
  double fastest = 0;
  const ComponentGrid<2>& grid = simulation.fluid().grids().front();
  for (int t = 0; t < grid.forest.local_count(); ++t)
    for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
      const Primitive<2> W = to_primitive(get<2>(simulation.fluid().fields().front().tile(t), grid.shape.at(c)), 1.4);
      fastest = std::max(fastest, std::hypot(W.velocity[0], W.velocity[1]));
    });
  return fastest;
}

TEST(ReferenceMap, UndeformedSolidsInGasAtRestStayAtRest) {
  CaseRun<2> run("prestrained_disk", {"grid.factor=2", "solids.0.initial.kind=rest", "time.end=0.3"});
  run.run();
  ASSERT_TRUE(run.finished()) << run.reason();
  EXPECT_LT(fastest(run.simulation), 5e-13);  // round-off
}

TEST(ReferenceMap, MassAndMomentumAreKept) {
  CaseRun<2> run("prestrained_disk", {"grid.factor=2", "time.end=0.5", "boundaries.left=periodic",
                                      "boundaries.right=periodic", "boundaries.bottom=periodic",
                                      "boundaries.top=periodic", "initial.state=[1.0, 0.3, -0.2, 0.7142857142857143]"});
  const SceneTotals<2> before = scene_totals(run.simulation);
  run.run();
  ASSERT_TRUE(run.finished()) << run.reason();
  const SceneTotals<2> after = scene_totals(run.simulation);
  EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
  EXPECT_NEAR(after.momentum.x(), before.momentum.x(), 1e-12 * before.mass);
  EXPECT_NEAR(after.momentum.y(), before.momentum.y(), 1e-12 * before.mass);
  EXPECT_NEAR(after.energy - run.simulation.reference_map()->restored_energy(), before.energy, 1e-12 * before.energy);
  EXPECT_EQ(run.simulation.reference_map()->orphans(), 0);
}

/// Times at which the material point at (0.45, 0) is farthest in.
std::vector<double> turns(const std::string& scheme) {
  CaseRun<2> run("prestrained_disk", {"grid.factor=3.2", "time.end=1.6", "scheme=" + scheme});
  const std::vector<Point<2>> X = {{0.45, 0}};
  std::vector<double> times, t, x;
  while (run.simulation.time() < 1.6) {
    run.simulation.advance(1.6);
    t.push_back(run.simulation.time());
    if (scheme == "reference-map") {
      x.push_back(material_point(mapped_solids(run.simulation)[0], X[0])->x.x());
    } else {
      const Material& material = run.simulation.solids()[0]->setup().options.material;
      x.push_back(0.45 + displacement_of(material, run.simulation.solids()[0]->sample(X)[0]).x());
    }
    const std::size_t n = x.size();
    if (n > 2 && x[n - 2] < x[n - 3] && x[n - 2] <= x[n - 1] && (times.empty() || t[n - 2] > times.back() + 0.5))
      times.push_back(t[n - 2]);
  }
  return times;
}

TEST(ReferenceMap, DiskRingsWithThePeriodOfThePartitionedSolver) {
  const std::vector<double> one = turns("reference-map"), two = turns("projection");
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_NEAR(one[1] - one[0], two[1] - two[0], 0.05 * (two[1] - two[0]));
}

TEST(ReferenceMap, ShockMovesTwoDisksAsUnderProjection) {
  const Overrides short_run = {"grid.factor=3", "time.end=1"};
  CaseRun<2> one("shock_two_disks", short_run + mapped), two("shock_two_disks", short_run);
  one.run();
  two.run();
  ASSERT_TRUE(one.finished()) << one.reason();
  const double radius[] = {1, 0.8};
  for (std::size_t b = 0; b < 2; ++b) {
    const Point<2> a = totals(mapped_solids(one.simulation)[b]).center, c = totals(*two.simulation.solids()[b]).center;
    EXPECT_LT((a - c).norm(), 0.05 * radius[b]) << a.transpose() << " and " << c.transpose();
  }
}

TEST(ReferenceMap, ScenesOfThePartitionedSchemesRun) {
  for (const char* name : {"shock_deformable_sticks", "shock_light_ellipse"})
    for (const char* law : {"neo_hookean", "saint_venant_kirchhoff"}) {
      CaseRun<2> run(name, mapped + Overrides{std::string("grid.factor=") + (name[6] == 'd' ? "5" : "1.5"),
                                              "time.end=0.7", std::string("solids.0.material.law=") + law});
      run.run();
      EXPECT_TRUE(run.finished()) << name << ", " << law << ": " << run.reason();
      EXPECT_GT(least_j(mapped_solids(run.simulation)[0]), 0.5) << name;
    }
}

}  // namespace
}  // namespace mortise::testing
