#include "mortise/cases/input/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

std::string error_of_formula(const std::string& formula) {
  try {
    Expression(formula, {"t"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Expression, Values) {
  EXPECT_DOUBLE_EQ(Expression("0.5*sin(pi*t)^4", {"t"})(0.25), 0.5 * std::pow(std::sin(std::numbers::pi / 4), 4));
  EXPECT_DOUBLE_EQ(Expression("-t^4/4", {"t"})(2.0), -4.0);
  EXPECT_DOUBLE_EQ(Expression("x + 10*y", {"x", "y"})(1.0, 2.0), 21.0);
  EXPECT_DOUBLE_EQ(Expression("x + 10*y + 100*t", {"x", "y", "t"})(1.0, 2.0, 3.0), 321.0);
  EXPECT_DOUBLE_EQ(Expression("ln(e)", {})(std::span<const double>{}), 1.0);
  EXPECT_DOUBLE_EQ(Expression("16", {"t"})(3.0), 16.0);
}

TEST(Expression, Conditions) {
  const Expression pulse("t < 1 ? 2 : 0", {"t"});
  EXPECT_EQ(pulse(0.5), 2.0);
  EXPECT_EQ(pulse(1.0), 0.0);
  EXPECT_EQ(Expression("x >= 0 && y != 1", {"x", "y"})(0.0, 1.0), 0.0);
  EXPECT_EQ(Expression("x == 1 || y <= 0", {"x", "y"})(1.0, 1.0), 1.0);
}

TEST(Expression, OutsideItsDomainIsNotFinite) {
  EXPECT_FALSE(std::isfinite(Expression("1/t", {"t"})(0.0)));
  EXPECT_FALSE(std::isfinite(Expression("sqrt(t)", {"t"})(-1.0)));
  EXPECT_DOUBLE_EQ(Expression("ln(t)", {"t"})(1.0), 0.0);
}

TEST(Expression, CopiesHaveVariablesOfTheirOwn) {
  auto original = std::make_unique<Expression>("2*t", std::vector<std::string>{"t"});
  Expression copy = *original;
  EXPECT_EQ((*original)(1.0), 2.0);
  EXPECT_EQ(copy(5.0), 10.0);
  EXPECT_EQ((*original)(3.0), 6.0);
  original.reset();
  EXPECT_EQ(copy(7.0), 14.0);
  Expression assigned("t", {"t"});
  assigned = copy;
  const Expression moved = std::move(copy);
  EXPECT_EQ(assigned(1.5), 3.0);
  EXPECT_EQ(moved(2.5), 5.0);
  EXPECT_EQ(moved.formula(), "2*t");
}

TEST(Expression, UnknownNameIsPlacedAndSuggested) {
  const std::string error = error_of_formula("1 + sine(t)");
  EXPECT_NE(error.find("\"1 + sine(t)\""), std::string::npos) << error;
  EXPECT_NE(error.find("\"sine\" at character 5"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean \"sin\"?"), std::string::npos) << error;
}

TEST(Expression, SyntaxErrors) {
  EXPECT_NE(error_of_formula("sin(t"), "");
  EXPECT_NE(error_of_formula("2*").find("character"), std::string::npos) << error_of_formula("2*");
  EXPECT_NE(error_of_formula("").find("nothing to evaluate"), std::string::npos);
  EXPECT_NE(error_of_formula("1, 2").find("comma"), std::string::npos) << error_of_formula("1, 2");
  EXPECT_NE(error_of_formula("t = 3").find("\"=\" at character 3"), std::string::npos) << error_of_formula("t = 3");
  EXPECT_NE(error_of_formula("x").find("\"x\" at character 1"), std::string::npos) << error_of_formula("x");
  EXPECT_EQ(error_of_formula("t == 3"), "");
}

}  // namespace
}  // namespace mortise
