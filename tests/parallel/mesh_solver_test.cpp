// The Euler solver on a mesh without background: the ranks of this run find what each finds alone.
#include <gtest/gtest.h>

#include "unit/fluid/mesh_run.hpp"

namespace mortise {
namespace {

using namespace testing;

std::vector<double> densities_after_some_steps(const Communicator& comm) {
  MeshRun run(wobbling_ring(48, 16, 0), true, around_and_wall, [](const Point<2>& x, double) { return wavy_state(x[0], x[1]); }, {12, 8}, {}, comm);
  for (int k = 0; k < 10; ++k) run.step();
  std::vector<double> found = run.densities();
  for (const auto& values : run.solver().sample(std::vector<Point<2>>{{0.7, 0.1}, {-0.2, -0.8}, {0.1, 0.6}})) found.push_back(values[0]);
  return found;
}

TEST(ParallelMeshSolver, FindsTheSameBitsOnAnyNumberOfRanks) {
  EXPECT_EQ(densities_after_some_steps(Communicator()), densities_after_some_steps(Communicator(MPI_COMM_SELF)));
}

}  // namespace
}  // namespace mortise
