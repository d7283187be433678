// Conservation through an elastic interface, whatever the ratio of the impedances.
#include "verification/elastic_conservation.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(ElasticConservation, NoiseInATube) { expect_conservation(1000); }

/// A pressure that pushes a shell aside: the gas loses nothing, and all of its push arrives.
TEST(ElasticConservation, CurvedInterface) {
  CaseRun<2> run("soft_shell", {"grid.factor=1.6", "solids.0.traction.outer=0*t", "time.end=1",
                                "initial={kind=\"regions\", regions=[{density=\"1\", velocity=[\"0\", \"0\"], "
                                "pressure=\"0.7*(1 + 0.2*x + 0.1*x*y)\"}]}",
                                "coupling.reference_pressure=0.7"});
  const ElasticSolver& shell = *run.simulation.solids().at(0);
  const double mass = totals(run.simulation)[0];
  Point<2> impulse = Point<2>::Zero();
  double time = 0;
  while (run.simulation.time() < 1) {
    run.step(1);
    impulse += (run.simulation.time() - time) * run.simulation.interfaces().at(0).force;
    time = run.simulation.time();
  }
  const SolidTotals after = totals(shell);
  EXPECT_GT(after.momentum.norm(), 1e-3);
  EXPECT_LE((after.momentum - impulse).norm(), 1e-12);
  EXPECT_NEAR(totals(run.simulation)[0], mass, 1e-12 * mass);
}

}  // namespace
}  // namespace mortise
