#include "mortise/grids/forest/forest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "forest_checks.hpp"

namespace mortise {
namespace {

TEST(Forest, NumbersFourTilesAlongTheMortonCurve) {
  const Forest<2> forest(Communicator(), {2, 2}, {false, false});
  EXPECT_EQ(forest.global_count(), 4);
  EXPECT_EQ(forest.local_count(), 4);
  EXPECT_EQ(forest.first_global(), 0);
  EXPECT_EQ(forest.coordinates(0), (Index<2>{0, 0}));
  EXPECT_EQ(forest.coordinates(1), (Index<2>{1, 0}));
  EXPECT_EQ(forest.coordinates(2), (Index<2>{0, 1}));
  EXPECT_EQ(forest.coordinates(3), (Index<2>{1, 1}));
}

TEST(Forest, KnowsNeighborsAndBoundaries) {
  const Forest<2> forest(Communicator(), {3, 2}, {false, false});
  const Neighbor corner = forest.find({0, 0});
  EXPECT_EQ(forest.neighbor(corner.local, {1, 1}).global, forest.find({1, 1}).global);
  EXPECT_EQ(forest.neighbor(corner.local, {1, 0}).global, forest.find({1, 0}).global);
  EXPECT_EQ(forest.neighbor(corner.local, {-1, 0}).kind, Neighbor::Kind::boundary);
  EXPECT_EQ(forest.neighbor(corner.local, {1, -1}).kind, Neighbor::Kind::boundary);
  testing::expect_consistent(forest);
}

TEST(Forest, OneDimensionalTilesAreInOrder) {
  const Forest<1> forest(Communicator(), {5}, {true});
  for (int t = 0; t < 5; ++t) EXPECT_EQ(forest.coordinates(t), (Index<1>{t}));
  EXPECT_EQ(forest.neighbor(0, {-1}).local, 4);
  EXPECT_EQ(forest.neighbor(4, {1}).local, 0);
  testing::expect_consistent(forest);
}

TEST(Forest, ASinglePeriodicTileIsItsOwnNeighbor) {
  const Forest<2> forest(Communicator(), {1, 1}, {true, false});
  EXPECT_EQ(forest.neighbor(0, {-1, 0}).local, 0);
  EXPECT_EQ(forest.neighbor(0, {1, 0}).local, 0);
  EXPECT_EQ(forest.neighbor(0, {0, 1}).kind, Neighbor::Kind::boundary);
  EXPECT_EQ(forest.neighbor(0, {1, 1}).kind, Neighbor::Kind::boundary);
}

TEST(Forest, TwoPeriodicTilesAreNeighborsOnBothSides) {
  const Forest<2> forest(Communicator(), {2, 1}, {true, true});
  EXPECT_EQ(forest.neighbor(0, {-1, 0}).local, 1);
  EXPECT_EQ(forest.neighbor(0, {1, 0}).local, 1);
  EXPECT_EQ(forest.neighbor(0, {0, 1}).local, 0);
  EXPECT_EQ(forest.neighbor(0, {1, -1}).local, 1);
}

TEST(Forest, CanBeMoved) {
  Forest<2> first(Communicator(), {3, 1}, {false, false});
  const Forest<2> second = std::move(first);
  EXPECT_EQ(second.global_count(), 3);
}

RC_GTEST_PROP(Forest, AnyShapeIsCompleteAndConsistent, ()) {
  const Index<2> tiles{*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9)};
  const Forest<2> forest(Communicator(), tiles, {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()});
  std::set<Index<2>> seen;
  for (int t = 0; t < forest.local_count(); ++t) seen.insert(forest.coordinates(t));
  RC_ASSERT(static_cast<int>(seen.size()) == tiles[0] * tiles[1]);
  testing::expect_consistent(forest);
}

}  // namespace
}  // namespace mortise
