// Numbers that look random.
#pragma once

#include <cstdint>

namespace mortise::testing {

/// Numbers in [0, 1) without any pattern from cell to cell, the same with every compiler.
inline double noise(int i, int j, int k = 0) {
  auto n = static_cast<std::uint32_t>(i + 100) * 73856093u ^ static_cast<std::uint32_t>(j + 100) * 19349663u ^
           static_cast<std::uint32_t>(k + 100) * 83492791u;
  for (int round = 0; round < 3; ++round) n = (n ^ (n >> 15)) * 0x2c1b3c6du;
  return (n >> 8) * 0x1p-24;
}

}  // namespace mortise::testing
