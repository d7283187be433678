// A body that changes shape: every cell's state and every interpolated value is the same on any number of ranks.
#include <algorithm>

#include "unit/grids/overlap/deforming_scene.hpp"

namespace mortise {
namespace {

struct CellValue {
  double x, y, value;
  int grid, state;
  auto operator<=>(const CellValue&) const = default;
};

/// All cells of all ranks after some steps of a breathing body, sorted.
std::vector<CellValue> after_steps(const Communicator& comm, bool inward) {
  constexpr double h = 0.05;
  const auto shape = [&](int step) {
    return testing::atlas_of(testing::ellipse(0.6 + 0.01 * step, 0.6 - 0.01 * step, 0.1 * step, 76, inward), h, 8, inward);
  };
  testing::DeformingScene scene(h, 1.5, {shape(0)}, {}, comm);
  for (int step = 1; step <= 6; ++step) {
    scene.reshape(0, shape(step));
    EXPECT_LT(scene.step(true, 0, [](const Point<2>& x) { return std::exp(x[0] + 0.7 * x[1]); }), 0.02);
  }
  std::vector<CellValue> mine;
  scene.for_all([&](std::size_t g, const TileMask& mask, std::size_t k, const Point<2>& x, double& value) {
    mine.push_back({x[0], x[1], value, static_cast<int>(g), static_cast<int>(scene.state(mask, k))});
  });
  std::vector<CellValue> all = comm.gather_all(mine);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(DeformingOverlap, IsTheSameOnAnyNumberOfRanks) {
  for (const bool inward : {false, true}) {
    const std::vector<CellValue> shared = after_steps(Communicator(MPI_COMM_WORLD), inward);
    const std::vector<CellValue> alone = after_steps(Communicator(MPI_COMM_SELF), inward);
    EXPECT_EQ(shared.size(), 60U * 60U + 76U * 8U);
    EXPECT_TRUE(shared == alone) << "inward: " << inward;
  }
}

}  // namespace
}  // namespace mortise
