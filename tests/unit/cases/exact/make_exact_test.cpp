#include <gmock/gmock.h>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/initial_state.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using ::testing::HasSubstr;

std::string message(const CaseDescription& description) {
  try {
    make_exact<2>(description);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MakeExact, NoKeyNoSolution) { EXPECT_EQ(make_exact<2>(CaseDescription{}), nullptr); }

TEST(MakeExact, UniformFlowStaysAsItIs) {
  CaseDescription description;
  description.exact = "uniform";
  description.initial.state = {1.4, 0.3, -0.2, 1};
  const auto solution = make_exact<2>(description);
  const Primitive<2> W = solution->state(Point<2>(3, 4), 5);
  EXPECT_EQ(W.density, 1.4);
  EXPECT_EQ(W.velocity, (std::array<double, 2>{0.3, -0.2}));
  EXPECT_EQ(W.pressure, 1);
  EXPECT_FALSE(solution->bodies(1).has_value());
}

TEST(MakeExact, UnknownKeyIsAnsweredWithTheNearestOne) {
  CaseDescription description;
  description.exact = "vortexx";
  EXPECT_THAT(message(description), HasSubstr("did you mean \"vortex\"?"));
  description.exact = "rigid_piston";
  EXPECT_THAT(message(description), HasSubstr("two dimensions \"rigid_piston\""));
}

TEST(InitialState, FirstRegionThatContainsThePointCounts) {
  CaseDescription description;
  description.initial.kind = "regions";
  description.initial.regions = {{"x < y", "1 + x", "2", "", "3*y"}, {"x < 1", "7", "0", "0", "7"}};
  const InitialState<2> initial(description);
  EXPECT_DOUBLE_EQ(initial(Point<2>(0.25, 0.5)).density, 1.25);
  EXPECT_DOUBLE_EQ(initial(Point<2>(0.25, 0.5)).velocity[0], 2);
  EXPECT_DOUBLE_EQ(initial(Point<2>(0.25, 0.5)).velocity[1], 0);
  EXPECT_DOUBLE_EQ(initial(Point<2>(0.25, 0.5)).pressure, 1.5);
  EXPECT_EQ(initial(Point<2>(0.75, 0.5)).density, 7);
  EXPECT_THROW(initial(Point<2>(2, 0)), InputError);
}

TEST(InitialState, VortexExistsInThePlaneOnly) {
  CaseDescription description;
  description.initial.kind = "vortex";
  description.initial.vortex_velocity = {0.5, 0.25};
  EXPECT_NEAR(InitialState<2>(description)(Point<2>(0, 0)).velocity[1], 0.25, 1e-15);
  EXPECT_THROW(InitialState<1>{description}, InputError);
}

}  // namespace
}  // namespace mortise
