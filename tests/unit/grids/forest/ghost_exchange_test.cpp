#include "mortise/grids/forest/ghost_exchange.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "forest_checks.hpp"

namespace mortise {
namespace {

using testing::everywhere;

TEST(GhostExchange, WrapsAPeriodicLineOfOneTile) {
  const Forest<1> forest(Communicator(), {1}, {true});
  const TileShape<1> shape({4});
  Field<1> field(shape, 1, 1);
  for (int i = 0; i < 4; ++i) field.tile(0).component(0)[shape.at(i)] = i + 1;
  GhostExchange<1>(forest, shape, 1).fill(field, std::vector<double>{0.0});
  const std::vector<double> expected = {3, 4, 1, 2, 3, 4, 1, 2};
  for (int i = -2; i < 6; ++i)
    EXPECT_EQ(field.tile(0).component(0)[shape.at(i)], expected[static_cast<std::size_t>(i + 2)]);
}

TEST(GhostExchange, FillsSidesCornersAndWrapsOnly) {
  const Communicator comm;
  EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {4, 3}, {false, false}), {6, 4}, 4, everywhere), 0);
  EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {1, 1}, {true, false}), {12, 8}, 3, everywhere), 0);
  EXPECT_EQ(testing::wrong_after_exchange<2>(Forest<2>(comm, {1, 1}, {true, true}), {2, 2}, 1, everywhere), 0);
  EXPECT_EQ(testing::wrong_after_exchange<1>(Forest<1>(comm, {3}, {false}), {10}, 3, everywhere), 0);
}

TEST(GhostExchange, GivesTheFillerBesideUnallocatedTiles) {
  const Forest<2> forest(Communicator(), {3, 3}, {false, true});
  const std::int64_t hole = forest.find({1, 1}).global;
  const auto allocated = [hole](std::int64_t tile) { return tile != hole; };
  EXPECT_EQ(testing::wrong_after_exchange<2>(forest, {4, 6}, 4, allocated), 0);
}

TEST(GhostExchange, FollowsTilesThatComeAndGo) {
  const Forest<1> forest(Communicator(), {2}, {false});
  const TileShape<1> shape({4});
  const GhostExchange<1> exchange(forest, shape, 1);
  const std::vector<double> filler = {-5};
  Field<1> field(shape, 1, 2);
  field.tile(1).component(0)[shape.at(0)] = 8;
  field.tile(1).component(0)[shape.at(1)] = 9;
  exchange.fill(field, filler);
  EXPECT_EQ(field.tile(0).component(0)[shape.at(4)], 8);
  EXPECT_EQ(field.tile(0).component(0)[shape.at(5)], 9);
  field.tile(1).release();
  exchange.fill(field, filler);
  EXPECT_EQ(field.tile(0).component(0)[shape.at(4)], -5);
  field.allocate(1);
  exchange.fill(field, filler);
  EXPECT_EQ(field.tile(0).component(0)[shape.at(4)], 0);
}

TEST(GhostExchange, FillsOnlyTheListedTiles) {
  const Forest<1> forest(Communicator(), {3}, {true});
  const TileShape<1> shape({4});
  Field<1> field = testing::numbered_field<1>(forest, shape, 1, everywhere);
  GhostExchange<1>(forest, shape, 1).fill(field, std::vector<double>{0.0}, std::vector<int>{1});
  EXPECT_EQ(field.tile(0).component(0)[shape.at(4)], testing::untouched);
  EXPECT_EQ(field.tile(1).component(0)[shape.at(-1)], 3);
  EXPECT_EQ(field.tile(1).component(0)[shape.at(4)], 8);
  EXPECT_EQ(field.tile(2).component(0)[shape.at(-1)], testing::untouched);
}

RC_GTEST_PROP(GhostExchange, HoldsForAnyForestTileAndAllocation, ()) {
  const Index<2> tiles{*rc::gen::inRange(1, 6), *rc::gen::inRange(1, 6)};
  const Index<2> cells{2 * *rc::gen::inRange(1, 8), 2 * *rc::gen::inRange(1, 8)};
  const Forest<2> forest(Communicator(), tiles, {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()});
  const auto holes = *rc::gen::container<std::vector<bool>>(static_cast<std::size_t>(forest.global_count()),
                                                            rc::gen::arbitrary<bool>());
  const auto allocated = [&](std::int64_t tile) { return !holes[static_cast<std::size_t>(tile)]; };
  RC_ASSERT(testing::wrong_after_exchange<2>(forest, cells, *rc::gen::inRange(1, 5), allocated) == 0);
}

}  // namespace
}  // namespace mortise
