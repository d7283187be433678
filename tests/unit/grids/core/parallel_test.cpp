#include "mortise/grids/core/parallel.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(Communicator, OfOneRankReturnsWhatItGets) {
  const Communicator alone(MPI_COMM_SELF);
  EXPECT_EQ(alone.rank(), 0);
  EXPECT_EQ(alone.size(), 1);
  EXPECT_EQ(alone.min(-3.5), -3.5);
  EXPECT_EQ(alone.max(-3.5), -3.5);
  EXPECT_EQ(alone.sum(std::int64_t{1} << 40), std::int64_t{1} << 40);
  EXPECT_TRUE(alone.any(true));
  EXPECT_FALSE(alone.any(false));
  EXPECT_EQ(alone.gather_all(std::vector<double>{1, 2}), (std::vector<double>{1, 2}));
  EXPECT_EQ(alone.exchange(std::vector<std::vector<int>>{{4, 5}}), (std::vector<std::vector<int>>{{4, 5}}));
}

}  // namespace
}  // namespace mortise
