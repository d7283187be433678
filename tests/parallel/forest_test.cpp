// Forests and ghost exchanges on the ranks of this run: the same tiles, order and values as on one rank.
#include "mortise/grids/forest/forest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "forest_checks.hpp"

namespace mortise {
namespace {

using testing::everywhere;

/// All ranks' tiles of a two-dimensional forest as row-major indices, sorted.
std::vector<int> owned_tiles(const Forest<2>& forest) {
  std::vector<int> tiles;
  for (int t = 0; t < forest.local_count(); ++t) {
    const auto [i, j] = forest.coordinates(t);
    tiles.push_back(j * forest.tiles()[0] + i);
  }
  tiles = forest.communicator().gather_all(tiles);
  std::sort(tiles.begin(), tiles.end());
  return tiles;
}

/// 0, 1, … count − 1.
std::vector<int> each_once(int count) {
  std::vector<int> tiles(static_cast<std::size_t>(count));
  std::iota(tiles.begin(), tiles.end(), 0);
  return tiles;
}

TEST(ParallelForest, EveryTileHasOneOwner) {
  for (const Index<2>& tiles : {Index<2>{7, 5}, Index<2>{1, 1}, Index<2>{2, 1}, Index<2>{16, 1}, Index<2>{1, 9}}) {
    const Forest<2> forest(Communicator(), tiles, {false, true});
    EXPECT_EQ(owned_tiles(forest), each_once(tiles[0] * tiles[1]));
    testing::expect_consistent(forest);
  }
}

TEST(ParallelForest, OrderDoesNotDependOnTheNumberOfRanks) {
  const Forest<2> together(Communicator(), {6, 5}, {true, false});
  const Forest<2> alone(Communicator(MPI_COMM_SELF), {6, 5}, {true, false});
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 6; ++i) EXPECT_EQ(together.find({i, j}).global, alone.find({i, j}).global);
}

TEST(ParallelForest, PiecesOfTheCurveFollowEachOther) {
  const Forest<1> forest(Communicator(), {11}, {false});
  const auto counts = forest.communicator().gather_all(std::vector<int>{forest.local_count()});
  const auto before = std::accumulate(counts.begin(), counts.begin() + forest.communicator().rank(), 0);
  EXPECT_EQ(forest.first_global(), before);
  testing::expect_consistent(forest);
}

TEST(ParallelForest, EqualTilesAreSharedEqually) {
  const Forest<2> forest(Communicator(), {8, 4}, {false, false});
  EXPECT_NEAR(forest.local_count(), 32.0 / forest.communicator().size(), 0.7);
}

TEST(ParallelForest, WeightsAreShared) {
  const Communicator comm;
  const Index<2> tiles{16, 8};
  std::vector<int> weights;
  for (int n = 0; n < 128; ++n) weights.push_back(n % 16 < 4 ? 10 : 1);
  const Forest<2> forest(comm, tiles, {false, false}, weights);
  std::int64_t mine = 0;
  for (int t = 0; t < forest.local_count(); ++t) {
    const auto [i, j] = forest.coordinates(t);
    mine += weights[static_cast<std::size_t>(j * 16 + i)];
  }
  const std::int64_t total = std::accumulate(weights.begin(), weights.end(), 0);
  EXPECT_EQ(comm.sum(mine), total);
  EXPECT_NEAR(static_cast<double>(mine), static_cast<double>(total) / comm.size(), 10.0);
  EXPECT_EQ(owned_tiles(forest), each_once(128));
}

TEST(ParallelForest, ZeroWeightsAreEqualWeights) {
  const Forest<2> forest(Communicator(), {4, 2}, {false, false}, std::vector<int>(8, 0));
  EXPECT_NEAR(forest.local_count(), 8.0 / forest.communicator().size(), 0.7);
}

TEST(ParallelGhostExchange, PlaneGhostsAreExact) {
  const Communicator comm;
  for (const bool x : {false, true})
    for (const bool y : {false, true}) {
      EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {5, 4}, {x, y}), {6, 8}, 4, everywhere), 0);
      EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {2, 2}, {x, y}), {2, 4}, 2, everywhere), 0);
      EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {2, 1}, {x, y}), {4, 2}, 1, everywhere), 0);
      EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {1, 1}, {x, y}), {8, 8}, 3, everywhere), 0);
    }
}

TEST(ParallelGhostExchange, LineGhostsAreExact) {
  const Communicator comm;
  for (const int tiles : {1, 2, 3, 9})
    for (const bool periodic : {false, true})
      EXPECT_EQ(testing::wrong_after_exchange<1>(Forest<1>(comm, {tiles}, {periodic}), {6}, 3, everywhere), 0);
}

TEST(ParallelGhostExchange, HolesReachAcrossRanks) {
  const Forest<2> forest(Communicator(), {6, 5}, {true, false});
  const auto allocated = [](std::int64_t tile) { return tile * 7 % 3 != 0; };
  EXPECT_EQ(testing::wrong_after_exchange<2>(forest, {4, 4}, 4, allocated), 0);
}

TEST(ParallelGhostExchange, BuffersServeManyFieldsAndAllocations) {
  const Forest<2> forest(Communicator(), {5, 3}, {false, true});
  const TileShape<2> shape({4, 6});
  const GhostExchange<2> exchange(forest, shape, 2);
  const std::vector<double> filler = {-1, -2};
  for (int step = 0; step < 20; ++step) {
    const auto allocated = [step](std::int64_t tile) { return (tile + step) % 4 != 0; };
    Field<2> field = testing::numbered_field<2>(forest, shape, 2, allocated);
    exchange.fill(field, filler);
    EXPECT_EQ(testing::wrong_cells<2>(forest, field, allocated, filler), 0);
  }
}

TEST(ParallelGhostExchange, MessagesReachTilesThatAreNotListed) {
  const Forest<1> forest(Communicator(), {8}, {true});
  const TileShape<1> shape({4});
  Field<1> field = testing::numbered_field<1>(forest, shape, 1, everywhere);
  GhostExchange<1>(forest, shape, 1).fill(field, std::vector<double>{0.0}, std::span<const int>{});
  for (int t = 0; t < forest.local_count(); ++t)
    for (const int side : {-1, 1}) {
      const Neighbor& beyond = forest.neighbor(t, {side});
      const Index<1> ghost{side < 0 ? -1 : 4};
      const double expected =
          beyond.rank == forest.communicator().rank()
              ? testing::untouched
              : testing::expected_value<1>(forest, shape, forest.coordinates(t), ghost, 0, everywhere, 0);
      EXPECT_EQ(field.tile(t).component(0)[shape.at(ghost)], expected);
    }
}

}  // namespace
}  // namespace mortise
