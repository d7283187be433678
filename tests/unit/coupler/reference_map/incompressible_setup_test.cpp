// Setups of an incompressible flow that cannot be run are refused.
#include "mortise/coupler/reference_map/incompressible_setup.hpp"

#include <gtest/gtest.h>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

IncompressibleSetup channel() {
  IncompressibleSetup setup;
  setup.sides[west] = {SideKind::inflow, 0, [](const Point<2>& x) { return Point<2>(x[1] * (1 - x[1]), 0); }};
  setup.sides[east].kind = SideKind::outflow;
  return setup;
}

TEST(IncompressibleSetup, OneSidedPeriodicityIsRefused) {
  EXPECT_NO_THROW(check(channel()));
  IncompressibleSetup setup;
  setup.sides[west].kind = SideKind::wall;
  EXPECT_THROW(check(setup), InputError);
}

TEST(IncompressibleSetup, InflowNeedsAWayOut) {
  IncompressibleSetup setup = channel();
  setup.sides[east].kind = SideKind::wall;
  EXPECT_THROW(check(setup), InputError);
  setup.sides[east] = setup.sides[west];
  EXPECT_NO_THROW(check(setup));
  setup.sides[east].velocity = nullptr;
  EXPECT_THROW(check(setup), InputError);
}

TEST(IncompressibleSetup, TilesFillTheGrid) {
  IncompressibleSetup setup;
  setup.cells = {66, 64};
  EXPECT_THROW(check(setup), InputError);
}

TEST(IncompressibleSetup, NumbersHaveToMakeSense) {
  for (const auto& spoil :
       {+[](IncompressibleSetup& s) { s.density = 0; }, +[](IncompressibleSetup& s) { s.viscosity = -1; },
        +[](IncompressibleSetup& s) { s.cfl = 1.5; }, +[](IncompressibleSetup& s) { s.tolerance = 0; }}) {
    IncompressibleSetup setup;
    spoil(setup);
    EXPECT_THROW(check(setup), InputError);
  }
}

}  // namespace
}  // namespace mortise
