#include "mortise/grids/forest/field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>

namespace mortise {
namespace {

TEST(TileShape, OfAKnownTile) {
  const TileShape<2> shape({60, 30});
  EXPECT_EQ(shape.stride, 80);  // 60 + 16 of slack, rounded up to whole cache lines
  EXPECT_EQ(shape.rows, 34);
  EXPECT_EQ(shape.plane, 80u * 34u + 8u);  // 340 cache lines and one more
  EXPECT_EQ(shape.count(), 1800);
  EXPECT_EQ(shape.at(0, 0), 2u * 80u + 8u);
  EXPECT_EQ(shape.at(-2, -2), 6u);
  EXPECT_EQ(shape.at(Index<2>{3, 4}), shape.at(3, 4));
}

TEST(TileShape, OfALine) {
  const TileShape<1> shape({100});
  EXPECT_EQ(shape.stride, 120);
  EXPECT_EQ(shape.rows, 1);
  EXPECT_EQ(shape.plane, 120u);
  EXPECT_EQ(shape.count(), 100);
  EXPECT_EQ(shape.at(-2), 6u);
  EXPECT_EQ(shape.at(Index<1>{5}), shape.at(5));
}

RC_GTEST_PROP(TileShape, KeepsRowsAlignedWithSlackOnBothSides, ()) {
  const TileShape<2> shape({2 * *rc::gen::inRange(1, 150), 2 * *rc::gen::inRange(1, 150)});
  RC_ASSERT(shape.plane % 16 == 8u);
  RC_ASSERT(shape.plane >= static_cast<std::size_t>(shape.stride * shape.rows));
  for (int j = -2; j < shape.cells[1] + 2; ++j) {
    RC_ASSERT(shape.at(0, j) % 8 == 0u);
    RC_ASSERT(shape.at(0, j) >= static_cast<std::size_t>((j + 2) * shape.stride + 8));
    RC_ASSERT(shape.at(shape.cells[0], j) + 8 <= static_cast<std::size_t>((j + 3) * shape.stride));
  }
}

TEST(TileBlock, IsAlignedZeroAndSeparateByComponent) {
  const TileShape<2> shape({14, 6});
  TileBlock block(shape.plane, 4);
  for (const double value : block.all()) EXPECT_EQ(value, 0);
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.component(c)) % 64, 0u);
    EXPECT_EQ(block.component(c) - block.component(0), static_cast<std::ptrdiff_t>(shape.plane) * c);
  }
  EXPECT_EQ(block.bytes(), 4 * shape.plane * sizeof(double));
}

TEST(TileBlock, HoldsNothingOnceReleased) {
  TileBlock block(40, 2);
  EXPECT_TRUE(block.allocated());
  block.release();
  EXPECT_FALSE(block.allocated());
  EXPECT_EQ(block.bytes(), 0u);
  EXPECT_TRUE(block.all().empty());
}

TEST(Field, AllocatesATileAfresh) {
  const TileShape<1> shape({4});
  Field<1> field(shape, 3, 2);
  EXPECT_EQ(field.tiles(), 2);
  EXPECT_EQ(field.components(), 3);
  field.tile(1).component(2)[shape.at(0)] = 5;
  EXPECT_EQ(field.tile(0).component(2)[shape.at(0)], 0);
  field.tile(1).release();
  field.allocate(1);
  EXPECT_EQ(field.tile(1).component(2)[shape.at(0)], 0);
}

}  // namespace
}  // namespace mortise
