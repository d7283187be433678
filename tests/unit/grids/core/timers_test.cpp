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

TEST(PhaseTimers, ChargeTheInnermostPhaseOnly) {
  PhaseTimers timers;
  {
    const auto outer = timers("coupling");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    {
      const auto inner = timers("solid");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GE(timers.seconds().at("solid"), 0.020);
  EXPECT_GE(timers.seconds().at("coupling"), 0.002);
  EXPECT_LT(timers.seconds().at("coupling"), timers.seconds().at("solid"));
}

}  // namespace
}  // namespace mortise
