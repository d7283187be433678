#include "mortise/coupler/least_distance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>

namespace mortise {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

TEST(LeastDistance, NothingToDoAtTheOrigin) {
  const LeastDistance answer = least_distance(2, {{1, 0}, {0, 1}}, {-1, 0});
  EXPECT_EQ(answer.x, Vector({0, 0}));
  EXPECT_EQ(answer.multipliers, Vector({0, 0}));
  EXPECT_TRUE(answer.violated.empty());
  EXPECT_EQ(least_distance(2, {}, {}).x, Vector({0, 0}));
}

TEST(LeastDistance, OneHalfPlane) {
  const LeastDistance answer = least_distance(2, {{3, 4}}, {10});
  EXPECT_NEAR(answer.x[0], 1.2, 1e-15);
  EXPECT_NEAR(answer.x[1], 1.6, 1e-15);
  EXPECT_NEAR(answer.multipliers[0], 0.4, 1e-15);
}

TEST(LeastDistance, DropsAConstraintThatIsNotNeeded) {
  // x ≥ 1 is satisfied with room to spare at the nearest point of x + y/2 ≥ 3, which is (2.4, 1.2).
  const LeastDistance answer = least_distance(2, {{10, 0}, {1, 0.5}}, {10, 3});
  EXPECT_NEAR(answer.x[0], 2.4, 1e-14);
  EXPECT_NEAR(answer.x[1], 1.2, 1e-14);
  EXPECT_EQ(answer.multipliers[0], 0);
}

TEST(LeastDistance, TakesTheStricterOfParallelConstraints) {
  const LeastDistance answer = least_distance(2, {{1, 0}, {1, 0}, {2, 0}}, {1, 3, 4});
  EXPECT_NEAR(answer.x[0], 3, 1e-15);
  EXPECT_EQ(answer.x[1], 0);
  EXPECT_TRUE(answer.violated.empty());
}

TEST(LeastDistance, NamesContradictions) {
  const LeastDistance answer = least_distance(2, {{1, 0}, {-1, 0}, {0, 0}, {0, 1}}, {2, -1, 1, 5});
  EXPECT_EQ(answer.violated, std::vector<int>({1, 2}));
  EXPECT_NEAR(answer.x[0], 2, 1e-15);
  EXPECT_NEAR(answer.x[1], 5, 1e-14);
}

TEST(LeastDistance, IsExactForNearlyParallelConstraints) {
  const double small = 1e-6;
  const LeastDistance answer = least_distance(3, {{small, -1, 0}, {0, 1, small}}, {small, small});
  EXPECT_NEAR(answer.x[0], answer.x[2], 1e-9);
  EXPECT_NEAR(small * answer.x[0] - answer.x[1], small, 1e-21);
  EXPECT_NEAR(answer.x[1] + small * answer.x[2], small, 1e-21);
}

RC_GTEST_PROP(LeastDistanceProperty, MeetsTheKuhnTuckerConditions, ()) {
  const std::size_t rows = *rc::gen::inRange<std::size_t>(1, 8), count = *rc::gen::inRange<std::size_t>(1, 12);
  const auto number = [] { return 1e-3 * *rc::gen::inRange(-1000, 1001); };
  std::vector<Vector> columns(count, Vector(rows));
  Vector inside(rows), h(count);  // `inside` satisfies every constraint: none contradicts the others
  for (double& value : inside) value = number();
  for (std::size_t j = 0; j < count; ++j) {
    for (double& value : columns[j]) value = number();
    h[j] = dot(columns[j], inside) - std::abs(number());
  }
  const LeastDistance answer = least_distance(rows, columns, h);
  RC_ASSERT(answer.violated.empty());
  RC_ASSERT(dot(answer.x, answer.x) <= dot(inside, inside) * (1 + 1e-12));
  Vector rest = answer.x;
  for (std::size_t j = 0; j < count; ++j) {
    const double slack = dot(columns[j], answer.x) - h[j];
    RC_ASSERT(slack >= -1e-11);
    RC_ASSERT(answer.multipliers[j] >= 0);
    RC_ASSERT(answer.multipliers[j] == 0 || slack <= 1e-11);
    for (std::size_t i = 0; i < rows; ++i) rest[i] -= answer.multipliers[j] * columns[j][i];
  }
  double largest = 1;
  for (const double value : answer.multipliers) largest = std::max(largest, value);
  RC_ASSERT(dot(rest, rest) <= 1e-20 * largest * largest);
}

}  // namespace
}  // namespace mortise
