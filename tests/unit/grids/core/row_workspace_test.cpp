#include "mortise/grids/core/row_workspace.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace mortise {
namespace {

TEST(RowWorkspace, RowsStartOnACacheLineAndHoldWholeVectors) {
  for (int nx = 2; nx < 70; nx += 2) {
    const RowWorkspace work(nx, 3);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(work.row(1) + row_start) % 64, 0u);
    EXPECT_EQ(work.stride() / 8 % 2, 1u);
    EXPECT_EQ(work.row(2) - work.row(1), static_cast<std::ptrdiff_t>(work.stride()));
    int last = row_start;
    while (last + simd_width < nx + 2) last += simd_width;
    // One double before the first vector to one after the last stays clear of the neighbouring rows' vectors.
    EXPECT_LT(work.row(0) + last + simd_width, work.row(1) + row_start - 1);
  }
}

TEST(RowWorkspace, StartsFilledWithOnes) {
  for (int repeat = 0; repeat < 2; ++repeat) {
    const RowWorkspace work(20, 2);
    for (int i = row_start - 1; i < 23; ++i) {
      EXPECT_EQ(work.row(1)[i], 1);
      work.row(1)[i] = -7;
    }
  }
}

}  // namespace
}  // namespace mortise
