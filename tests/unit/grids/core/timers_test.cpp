#include "mortise/grids/core/timers.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace mortise {
namespace {

TEST(PhaseTimers, AddUpScopesByPhase) {
  PhaseTimers timers;
  for (int k = 0; k < 2; ++k) {
    const auto scope = timers("fluid");
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  { const auto scope = timers("overlap"); }
  ASSERT_EQ(timers.seconds().size(), 2u);
  EXPECT_GE(timers.seconds().at("fluid"), 0.004);
  EXPECT_LT(timers.seconds().at("overlap"), timers.seconds().at("fluid"));
}

}  // namespace
}  // namespace mortise
