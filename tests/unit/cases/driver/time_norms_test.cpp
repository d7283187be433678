#include "mortise/cases/driver/time_norms.hpp"

#include <gtest/gtest.h>

#include <array>

namespace mortise {
namespace {

TEST(TimeNorms, MeansOverPlacesAndTime) {
  TimeNorms norms;
  EXPECT_TRUE(norms.empty());
  norms.add(std::array{5.0}, 0);  // the initial state counts for the maximum only
  EXPECT_TRUE(norms.empty());
  norms.add(std::array{1.0, -3.0}, 0.5);
  norms.add(std::array{2.0, 2.0}, 1.5);
  norms.add({}, 10);
  EXPECT_DOUBLE_EQ(norms.norms().l1, 2);
  EXPECT_DOUBLE_EQ(norms.norms().l2, std::sqrt((0.5 * 5 + 1.5 * 4) / 2));
  EXPECT_DOUBLE_EQ(norms.norms().max, 5);
}

TEST(TimeNorms, GoOnWhereTheyWere) {
  TimeNorms first, second;
  first.add(std::array{1.0, 2.0}, 0.1);
  ASSERT_EQ(first.state().size(), TimeNorms::size);
  second.resume(first.state().data());
  for (TimeNorms* norms : {&first, &second}) norms->add(std::array{0.3}, 0.2);
  EXPECT_EQ(first.state(), second.state());
}

}  // namespace
}  // namespace mortise
