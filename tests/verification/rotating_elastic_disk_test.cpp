// An elastic disk set spinning in a gas: light or not, its edge follows the radial reference with second order. The
// disturbance fronts are kinks of the solution, at which maximum norms over the whole domain fall more slowly.
#include <gtest/gtest.h>

#include "verification/case_runner.hpp"

namespace mortise {
namespace {

using namespace testing;

/// Largest deviation at the end of the run.
struct EdgeErrors {
  double position = 0, velocity = 0, pressure = 0;
};

EdgeErrors edge_errors(double factor, double scale) {
  CaseRun<2> run("rotating_elastic_disk", {set("grid.factor", factor), set("solid.scale", scale)});
  EXPECT_TRUE(run.run().finished()) << run.reason();
  const InterfaceDeviations all = interface_deviations(run.simulation, *run.scene.exact);
  const auto largest = [](const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  };
  return {largest(all.position), largest(all.velocity), largest(all.pressure)};
}

TEST(RotatingElasticDisk, EdgeIsOfSecondOrder) {
  for (const double scale : {1.0, 0.1}) {
    const EdgeErrors coarse = edge_errors(2, scale), fine = edge_errors(4, scale);
    EXPECT_GE(order(coarse.position, fine.position), 1.9) << scale << ": " << fine.position;
    EXPECT_GE(order(coarse.velocity, fine.velocity), 1.9) << scale << ": " << fine.velocity;
    EXPECT_GE(order(coarse.pressure, fine.pressure), 1.8) << scale << ": " << fine.pressure;
  }
}

}  // namespace
}  // namespace mortise
