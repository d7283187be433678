#include "mortise/cases/driver/interface_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mortise {
namespace {

/// The rectangle [0, 3] × [0, 1] with a structure inside: counter-clockwise; the fluid's faces run clockwise.
InterfaceState rectangle() {
  InterfaceState state;
  state.nodes = {{0, 0}, {3, 0}, {3, 1}, {0, 1}};
  state.node_velocities = {{1, 0}, {1, 0}, {1, 2}, {1, 2}};
  state.fluid_nodes = {{0, 0}, {0, 1}, {3, 1}, {3, 0}};
  state.pressure = {1, 2, 1, 4};  // left, top, right, bottom
  state.force = {0, 6};
  return state;
}

TEST(InterfaceMeasures, ClosedCurve) {
  const InterfaceMeasures m = measure(rectangle(), 0.5);
  EXPECT_EQ(m.box.low, Point<2>(0, 0));
  EXPECT_EQ(m.box.high, Point<2>(3, 1));
  EXPECT_DOUBLE_EQ(m.area, 3);
  EXPECT_DOUBLE_EQ(m.pressure, (1 + 3 * 2 + 1 + 3 * 4) / 8.0 - 0.5);
  EXPECT_DOUBLE_EQ(m.velocity.x(), 1);
  EXPECT_DOUBLE_EQ(m.velocity.y(), (0 * 3 + 1 * 1 + 2 * 3 + 1 * 1) / 8.0);
  EXPECT_EQ(m.force, Point<2>(0, 6));
}

TEST(InterfaceMeasures, AreaIsSignedByTheSideOfTheStructure) {
  InterfaceState state = rectangle();
  EXPECT_DOUBLE_EQ(area_below(state), 3);
  std::swap(state.nodes[1], state.nodes[3]);  // the fluid is inside
  EXPECT_DOUBLE_EQ(area_below(state), -3);
  EXPECT_DOUBLE_EQ(measure(state, 0).area, 3);
}

TEST(InterfaceMeasures, RepeatingCurveSweepsTheStripItMovesThrough) {
  const Point<2> period(-0.6, 0.8), out(period.y(), -period.x());  // a strip at an angle, its outward normal
  InterfaceState state;
  state.period = period;
  state.nodes = {{0.1, 0.2}, Point<2>(0.1, 0.2) + 0.4 * period + 0.05 * out};
  state.node_velocities = {{1, 0}, {3, 0}};
  state.fluid_nodes = {state.nodes[1], state.nodes[0]};
  state.pressure = {2, 2};
  const double before = area_below(state);
  EXPECT_EQ(measure(state, 0).area, 0);
  EXPECT_DOUBLE_EQ(measure(state, 0).velocity.x(), 2);
  EXPECT_DOUBLE_EQ(measure(state, 0).pressure, 2);
  for (Point<2>& node : state.nodes) node += 0.3 * out + 0.1 * period;
  EXPECT_NEAR(area_below(state) - before, 0.3 * period.norm(), 1e-15);
}

TEST(InterfaceMeasures, OpenCurve) {
  InterfaceState state;
  state.periodic = false;
  state.nodes = {{2, 1}, {1, 1.5}, {0, 1}};  // the structure lies below
  state.node_velocities = {{0, 0}, {0, 1}, {0, 0}};
  state.fluid_nodes = {{0, 1}, {1, 1.5}, {2, 1}};
  const InterfaceMeasures m = measure(state, 0);
  EXPECT_EQ(m.area, 0);
  EXPECT_TRUE(std::isnan(m.pressure));
  EXPECT_DOUBLE_EQ(m.velocity.y(), 0.5);
  EXPECT_DOUBLE_EQ(area_below(state), 2.5);
}

}  // namespace
}  // namespace mortise
