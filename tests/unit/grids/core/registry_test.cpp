#include "mortise/grids/core/registry.hpp"

#include <gmock/gmock.h>

namespace mortise {
namespace {

const std::vector<std::string> limiters = {"none", "minmod", "mc", "van_albada"};

TEST(Nearest, FindsTheWordWithTheFewestEdits) {
  EXPECT_EQ(nearest("minmd", limiters), "minmod");
  EXPECT_EQ(nearest("van-albada", limiters), "van_albada");
  EXPECT_EQ(nearest("nome", limiters), "none");
  EXPECT_EQ(nearest("mc", limiters), "mc");
}

TEST(Nearest, StaysSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest("superbee-of-roe", limiters), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

TEST(Nearest, PrefersTheFirstOfEquals) { EXPECT_EQ(nearest("bat", {"cat", "hat"}), "cat"); }

TEST(Joined, SeparatesWithCommas) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"a"}), "a");
  EXPECT_EQ(joined({"a", "b", "c"}), "a, b, c");
}

TEST(Registry, FindsByKeyAndKeepsTheOrder) {
  const Registry<int> registry("number", {{"two", 2}, {"one", 1}});
  EXPECT_EQ(registry.at("one"), 1);
  EXPECT_EQ(registry.at("two"), 2);
  EXPECT_THAT(registry.keys(), ::testing::ElementsAre("two", "one"));
}

TEST(Registry, AnswersAnUnknownKeyInOneSentence) {
  const Registry<int> registry("limiter", {{"minmod", 1}, {"mc", 2}});
  try {
    registry.at("minmad");
    FAIL() << "an unknown key was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown limiter \"minmad\", did you mean \"minmod\"? (known: minmod, mc)");
  }
  try {
    registry.at("something else");
    FAIL() << "an unknown key was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "unknown limiter \"something else\" (known: minmod, mc)");
  }
}

}  // namespace
}  // namespace mortise
