#include "mortise/cases/summary/provenance.hpp"

#include <gtest/gtest.h>

namespace mortise {
namespace {

TEST(Provenance, EveryTextSaysSomething) {
  const Provenance made_by = provenance();
  for (const std::string& text : {made_by.version, made_by.git, made_by.compiler, made_by.flags})
    EXPECT_FALSE(text.empty());
}

}  // namespace
}  // namespace mortise
