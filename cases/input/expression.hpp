// Formulas in case files: forces, prescribed motions and initial states, such as "0.5*sin(pi*t)^4".
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mortise {

/// A real function of named variables, parsed once. The language is muparser's: + − * / ^, comparisons, && || (values 1
/// and 0), c ? a : b, sin … tanh, exp, ln, log10, sqrt, abs, min, max …, and the constants pi and e. Assignment is not
/// allowed.
class Expression {
 public:
  /// Throws InputError with the formula, the position of the fault in it (characters from 1) and the names that are
  /// known.
  Expression(std::string formula, std::vector<std::string> variables);
  Expression(const Expression& other);  // a copy has variables of its own
  Expression& operator=(const Expression& other);
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  const std::string& formula() const { return formula_; }

  /// The value for the variables in the order of the constructor. Not finite where the formula is not (1/0).
  double operator()(std::span<const double> values) const;
  double operator()(double t) const { return (*this)(std::span<const double>(&t, 1)); }
  double operator()(double x, double y) const {
    const double values[] = {x, y};
    return (*this)(values);
  }
  double operator()(double x, double y, double t) const {
    const double values[] = {x, y, t};
    return (*this)(values);
  }

 private:
  struct Parser;
  std::string formula_;
  std::vector<std::string> variables_;
  std::unique_ptr<Parser> parser_;
};

/// `scale` times a formula of t; no function if there is no formula.
std::function<double(double)> function_of_time(const std::string& formula, double scale = 1);

}  // namespace mortise
