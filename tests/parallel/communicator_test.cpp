#include <gtest/gtest.h>

#include "mortise/grids/core/parallel.hpp"

namespace mortise {
namespace {

TEST(ParallelCommunicator, ReducesOverAllRanks) {
  const Communicator comm;
  EXPECT_EQ(comm.min(10.0 - comm.rank()), 11.0 - comm.size());
  EXPECT_EQ(comm.max(0.1 * comm.rank()), 0.1 * (comm.size() - 1));
  EXPECT_EQ(comm.sum((std::int64_t{1} << 40) + comm.rank()),
            comm.size() * (std::int64_t{1} << 40) + comm.size() * (comm.size() - 1) / 2);
  EXPECT_TRUE(comm.any(comm.rank() == comm.size() - 1));
  EXPECT_FALSE(comm.any(false));
}

TEST(ParallelCommunicator, GathersInRankOrder) {
  const Communicator comm;
  const std::vector<double> all =
      comm.gather_all(std::vector<double>(static_cast<std::size_t>(comm.rank()), 0.5 * comm.rank()));
  std::vector<double> expected;
  for (int r = 0; r < comm.size(); ++r) expected.insert(expected.end(), static_cast<std::size_t>(r), 0.5 * r);
  EXPECT_EQ(all, expected);
}

TEST(ParallelCommunicator, ExchangesWithEveryRank) {
  const Communicator comm;
  std::vector<std::vector<int>> outgoing;
  for (int r = 0; r < comm.size(); ++r)  // rank r gets r copies of a number that names both ranks
    outgoing.emplace_back(static_cast<std::size_t>(r), 100 * comm.rank() + r);
  const std::vector<std::vector<int>> incoming = comm.exchange(outgoing);
  ASSERT_EQ(incoming.size(), outgoing.size());
  for (int r = 0; r < comm.size(); ++r)
    EXPECT_EQ(incoming[static_cast<std::size_t>(r)],
              std::vector<int>(static_cast<std::size_t>(comm.rank()), 100 * r + comm.rank()));
}

}  // namespace
}  // namespace mortise
