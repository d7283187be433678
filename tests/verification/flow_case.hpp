// Cases with an incompressible fluid, run in this process without writing files.
#pragma once

#include <gtest/gtest.h>

#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/scene/flow_scene.hpp"
#include "mortise/coupler/reference_map/flow_grid.hpp"

namespace mortise::testing {

/// One rank.
class FlowCase {
 public:
  /// change: of the scene, before anything is built from it.
  explicit FlowCase(
      const std::string& name, const std::vector<std::string>& overrides = {},
      const std::function<void(FlowScene&)>& change = [](FlowScene&) {})
      : description(read_case(name, overrides, MORTISE_SOURCE_DIR "/cases")),
        scene(changed(build_flow_scene(description), change)),
        grid(make_flow_grid(scene.flow, Communicator())),
        solids(scene.solids, grid),
        flow(scene.flow, Communicator(), &solids) {
    solids.follow(flow.velocity());
    flow.initialize();
  }
  void run(double time) {
    while (flow.time() < time) flow.advance(time - flow.time());
  }
  Point<2> velocity(int t, std::size_t k) const {
    return {flow.velocity().tile(t).component(0)[k], flow.velocity().tile(t).component(1)[k]};
  }
  /// ∫ρ x × v over solids and fluid, about the origin.
  double angular_momentum() const {
    double sum = 0;
    for (int t = 0; t < grid.forest.local_count(); ++t)
      for_each_cell<2>(grid.shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid.first_cell(t);
        const Point<2> x = grid.center({first[0] + c[0], first[1] + c[1]}), v = velocity(t, grid.shape.at(c));
        sum += flow.density()->tile(t).component(0)[grid.shape.at(c)] * (x.x() * v.y() - x.y() * v.x()) *
               grid.spacing.prod();
      });
    return sum;
  }
  SolidTotals solid(std::size_t b = 0) const { return totals(mapped_solids(solids, flow)[b]); }

  static FlowScene changed(FlowScene scene, const std::function<void(FlowScene&)>& change) {
    change(scene);
    return scene;
  }

  CaseDescription description;
  FlowScene scene;
  ComponentGrid<2> grid;
  FlowSolids solids;
  IncompressibleSolver flow;
};

/// Largest angle to which the material point at (0.72, 0) of the rotor has turned about the origin.
inline double largest_angle(FlowCase& rotor, double end) {
  double largest = 0, turned = 0, last = 0;
  while (rotor.flow.time() < end) {
    rotor.flow.advance(end - rotor.flow.time());
    const Point<2> x = material_point(mapped_solids(rotor.solids, rotor.flow)[0], {0.72, 0})->x;
    const double angle = std::atan2(x.y(), x.x());
    turned += std::remainder(angle - last, 2 * M_PI);
    last = angle;
    largest = std::max(largest, turned);
  }
  return largest;
}

}  // namespace mortise::testing
