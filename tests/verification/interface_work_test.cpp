// Momentum passes an elastic interface in the plane exactly, energy does not: the work that the gas receives and the work
// that the solid receives differ by O(h²) of what is exchanged.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

/// |ΣW_f + ΣW_s| / Σ|W_f| over a run of the shell that squeezes its gas.
double mismatch(const Overrides& overrides, double factor) {
  CaseRun<2> run("radial_shell", Overrides{"exact=none", set("grid.factor", factor)} + overrides);
  double on_fluid = 0, on_structure = 0, exchanged = 0;
  while (run.simulation.time() < run.description.time_end) {
    run.step(run.description.time_end);
    const InterfaceState interface = run.simulation.interfaces().at(0);
    on_fluid += interface.work_on_fluid;
    on_structure += interface.work_on_structure;
    exchanged += std::abs(interface.work_on_fluid);
  }
  EXPECT_GT(exchanged, 1e-4);
  return std::abs(on_fluid + on_structure) / exchanged;
}

/// From factor 4 on, `levels` grids; `finest` bounds the last mismatch.
void expect_second_order(const Overrides& overrides, int levels, double finest) {
  const Overrides all = Overrides{"coupling.load=current"} + overrides;
  double factor = 4, coarse = mismatch(all, factor);
  for (int level = 1; level < levels; ++level) {
    factor *= 2;
    const double fine = mismatch(all, factor);
    EXPECT_GE(order(coarse, fine), 1.8) << coarse << " " << fine;
    coarse = fine;
  }
  EXPECT_LE(coarse, finest);
}

TEST(InterfaceWork, MismatchIsOfSecondOrder) { expect_second_order({}, 3, 1.1e-4); }

TEST(InterfaceWork, NeoHookean) { expect_second_order({"solids.0.material.law=neo_hookean"}, 2, 4.2e-4); }

TEST(InterfaceWork, SolidTakesSubsteps) { expect_second_order({"solids.0.material.density=0.1"}, 2, 5.2e-4); }

/// A slower solid steps once in several steps of the gas. The mismatch is small and changes its sign on coarser grids.
TEST(InterfaceWork, SolidWaits) {
  const Overrides slow{"coupling.load=current", "solids.0.material.density=20", "time.end=2.5"};
  const double coarse = mismatch(slow, 8), fine = mismatch(slow, 12);
  EXPECT_LE(fine, std::pow(8.0 / 12, 1.8) * coarse) << coarse;
  EXPECT_LE(fine, 2e-5);
}

/// The structure carries p − p_e per undeformed area, the gas per present area: the works differ by the strain, on any grid.
TEST(InterfaceWork, LoadPerReferenceArea) {
  const double coarse = mismatch({"coupling.load=reference"}, 4), fine = mismatch({"coupling.load=reference"}, 8);
  EXPECT_NEAR(coarse, 0.0115, 2e-3);
  EXPECT_NEAR(fine, 0.0115, 5e-4);
}

}  // namespace
}  // namespace mortise
