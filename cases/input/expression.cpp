#include "mortise/cases/input/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

/// 1-based position of an assignment, 0 if there is none ("==", "<=", ">=", "!=" are comparisons).
std::size_t assignment_in(const std::string& formula) {
  for (std::size_t k = 0; k < formula.size(); ++k) {
    if (formula[k] != '=') continue;
    if (k + 1 < formula.size() && formula[k + 1] == '=') {
      ++k;
    } else if (k == 0 || std::string_view("<>!").find(formula[k - 1]) == std::string_view::npos) {
      return k + 1;
    }
  }
  return 0;
}

[[noreturn]] void reject(const std::string& formula, const std::string& fault) {
  throw InputError("in the formula \"" + formula + "\" " + fault);
}

}  // namespace

struct Expression::Parser {
  Parser(const std::string& formula, const std::vector<std::string>& variables) : values(variables.size(), 0.0) {
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    for (std::size_t k = 0; k < variables.size(); ++k) parser.DefineVar(variables[k], &values[k]);
    parser.SetExpr(formula);
  }
  /// The names the formula could have meant.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& variable : parser.GetVar()) all.push_back(variable.first);
    all.insert(all.end(), {"pi", "e"});
    for (const auto& function : parser.GetFunDef()) all.push_back(function.first);
    return all;
  }

  std::vector<double> values;  // bound to the parser by address: never resized
  mu::Parser parser;
};

Expression::Expression(std::string formula, std::vector<std::string> variables)
    : formula_(std::move(formula)),
      variables_(std::move(variables)),
      parser_(std::make_unique<Parser>(formula_, variables_)) {
  if (formula_.find_first_not_of(" \t") == std::string::npos) reject(formula_, "there is nothing to evaluate");
  if (const std::size_t at = assignment_in(formula_))
    reject(formula_, "\"=\" at character " + std::to_string(at) + " assigns, which is not allowed (compare with ==)");
  try {
    parser_->parser.Eval();
  } catch (const mu::ParserError& error) {
    const std::string at = " at character " + std::to_string(error.GetPos() + 1);
    if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN) reject(formula_, error.GetMsg() + " (" + at.substr(1) + ")");
    const std::vector<std::string> names = parser_->names();
    const std::string guess = nearest(error.GetToken(), names);
    reject(formula_, "the name \"" + error.GetToken() + "\"" + at + " is unknown" +
                         (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") + " (known: " + joined(names) +
                         ")");
  }
  if (parser_->parser.GetNumResults() != 1) reject(formula_, "a comma separates several values where one is expected");
}

Expression::Expression(const Expression& other)
    : formula_(other.formula_), variables_(other.variables_), parser_(std::make_unique<Parser>(formula_, variables_)) {}
Expression& Expression::operator=(const Expression& other) {
  if (this != &other) *this = Expression(other);
  return *this;
}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(std::span<const double> values) const {
  MORTISE_ASSERT(values.size() == parser_->values.size(), formula_);
  std::copy(values.begin(), values.end(), parser_->values.begin());
  return parser_->parser.Eval();
}

std::function<double(double)> function_of_time(const std::string& formula, double scale) {
  if (formula.empty()) return {};
  const auto expression = std::make_shared<Expression>(formula, std::vector<std::string>{"t"});
  return [expression, scale](double t) { return scale * (*expression)(t); };
}

}  // namespace mortise
