// An incompressible flow on the ranks of this run: bit by bit that of one rank with the transform solver.
#include <gtest/gtest.h>

#include <cmath>

#include "mortise/coupler/reference_map/incompressible_solver.hpp"

namespace mortise {
namespace {

/// A heavy disk that stays where it is.
class Disk : public Solids {
 public:
  const ComponentGrid<2>* grid = nullptr;
  void begin(SolidFields& fields) override {
    for (int t = 0; t < fields.density.tiles(); ++t)
      for_each_cell<2>(grid->shape, 0, [&](const Index<2>& c) {
        const Index<2> first = grid->first_cell(t);
        const Point<2> x = grid->center({first[0] + c[0], first[1] + c[1]});
        fields.density.tile(t).component(0)[grid->shape.at(c)] = (x - Point<2>(0.4, 0.5)).norm() < 0.2 ? 3 : 1;
      });
  }
  void half_step(const EdgeVelocities&, double, double, SolidFields&) override {}
  double rate() const override { return 0; }
};

IncompressibleSetup cavity(const std::string& solver) {
  IncompressibleSetup setup;
  setup.cells = {32, 32}, setup.tile = {8, 8};
  setup.viscosity = 0.01;
  setup.pressure_solver = solver;
  for (FlowSide& side : setup.sides) side.kind = SideKind::wall;
  setup.sides[north].speed = 1;
  return setup;
}

/// Largest difference between the states after ten steps on all ranks and on one.
double difference(const std::string& solver, bool heavy) {
  Disk disk_together, disk_alone;
  IncompressibleSolver together(cavity(solver), Communicator(), heavy ? &disk_together : nullptr);
  IncompressibleSolver alone(cavity(solver), Communicator(MPI_COMM_SELF), heavy ? &disk_alone : nullptr);
  disk_together.grid = &together.grid(), disk_alone.grid = &alone.grid();
  together.initialize();
  alone.initialize();
  double largest = 0;
  for (int k = 0; k < 10; ++k) largest = std::max(largest, std::abs(together.advance(1) - alone.advance(1)));
  for (int t = 0; t < together.grid().forest.local_count(); ++t) {
    const int there = alone.grid().forest.find(together.grid().forest.coordinates(t)).local;
    const std::vector<double> mine = together.state(t), other = alone.state(there);
    for (std::size_t k = 0; k < mine.size(); ++k) largest = std::max(largest, std::abs(mine[k] - other[k]));
  }
  return together.grid().forest.communicator().max(largest);
}

TEST(ParallelIncompressibleFlow, TransformsAreTheSameToTheBit) { EXPECT_EQ(difference("transform", false), 0); }
TEST(ParallelIncompressibleFlow, ConjugateGradientsAreTheSameToTheBit) { EXPECT_EQ(difference("transform", true), 0); }
TEST(ParallelIncompressibleFlow, MultigridAgreesToItsTolerance) {
  EXPECT_LT(difference("hypre", false), 1e-7);
  EXPECT_LT(difference("hypre", true), 1e-7);
}

}  // namespace
}  // namespace mortise
