#include "mortise/grids/core/error.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(AssertionDeathTest, NamesRankExpressionPlaceAndState) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(assertion_failed("a == b", "file.cpp", 12, "a = 3"),
               "internal error on rank 0: a == b does not hold \\(file.cpp:12\\) a = 3");
}

TEST(Failures, AreOfThreeKinds) {
  EXPECT_THROW(throw InputError("density -1 is negative"), InputError);
  EXPECT_FALSE((std::is_base_of_v<InputError, NumericalError>));
  EXPECT_FALSE((std::is_base_of_v<NumericalError, EnvironmentError>));
  EXPECT_STREQ(NumericalError("cell (3, 4)").what(), "cell (3, 4)");
}

}  // namespace
}  // namespace mortise
