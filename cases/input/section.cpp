#include "mortise/cases/input/section.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/input/expression.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

[[noreturn]] void wrong_type(const Node& node, const std::string& path, const std::string& allowed) {
  throw InputError(node.place + ": " + path + " must be " + allowed + ", not " + node.shown());
}

std::string checked_choice(const Node& node, const std::string& path, const std::vector<std::string>& allowed) {
  if (node.kind != Node::Kind::text) wrong_type(node, path, "one of " + joined(allowed));
  if (std::find(allowed.begin(), allowed.end(), node.text) != allowed.end()) return node.text;
  const std::string guess = nearest(node.text, allowed);
  throw InputError(node.place + ": " + path + " = " + node.shown() + " is not known" +
                   (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") + " (allowed: " + joined(allowed) + ")");
}

std::string each(Range range) { return range.text().empty() ? "" : "; each" + range.text(); }

std::string text_of(const std::array<double, 2>& pair) {
  return "[" + shortest(pair[0]) + ", " + shortest(pair[1]) + "]";
}

}  // namespace

std::string Range::text() const {
  if (std::isinf(low) && std::isinf(high)) return "";
  if (std::isinf(high)) return (low_open ? " > " : " ≥ ") + shortest(low);
  if (std::isinf(low)) return (high_open ? " < " : " ≤ ") + shortest(high);
  return std::string(" in ") + (low_open ? "(" : "[") + shortest(low) + ", " + shortest(high) + (high_open ? ")" : "]");
}

const Node* Section::given(const char* key, const std::string& allowed, const std::string& initial,
                           const char* meaning) {
  if (!list_) return table_->member(key);
  const bool required = std::find(required_.begin(), required_.end(), key) != required_.end();
  list_->push_back({path_to(key), allowed + (required ? "; required" : ""), required ? "" : initial, meaning});
  return nullptr;
}

double Section::checked_number(const Node& node, const std::string& path, Range range) const {
  if (!node.is_number()) wrong_type(node, path, "a number" + range.text());
  if (!std::isfinite(node.number))
    throw InputError(node.place + ": " + path + " = " + node.shown() + " is not a finite number");
  if (!range.contains(node.number))
    throw InputError(node.place + ": " + path + " = " + node.shown() + " is not allowed: it must be" + range.text());
  return node.number;
}

std::string Section::checked_formula(const Node& node, const std::string& path,
                                     const std::vector<std::string>& variables) const {
  if (node.kind != Node::Kind::text && !node.is_number())
    wrong_type(node, path, "a formula of " + joined(variables) + " or a number");
  const std::string formula = node.is_number() ? shortest(checked_number(node, path, any_number)) : node.text;
  try {
    return Expression(formula, variables).formula();
  } catch (const InputError& error) {
    throw InputError(node.place + ": " + path + ": " + error.what());
  }
}

/// An array of exactly `count` entries; one entry may stand without brackets.
void Section::components(const Node& node, const std::string& path, std::size_t count, const char* example,
                         const std::function<void(std::size_t, const Node&, const std::string&)>& read) const {
  if (count == 1 && node.kind != Node::Kind::array) return read(0, node, path);
  if (node.kind != Node::Kind::array || node.items.size() != count) {
    const std::string dimension = " in " + std::to_string(dimension_) + "D";
    wrong_type(node, path, (count == 1 ? std::string("a single value") : std::string(example)) + dimension);
  }
  for (std::size_t k = 0; k < count; ++k) read(k, node.items[k], path + "." + std::to_string(k));
}

void Section::text(const char* key, std::string& target, const char* meaning) {
  const Node* node = given(key, "a string", target, meaning);
  if (!node) return;
  if (node->kind != Node::Kind::text) wrong_type(*node, path_to(key), "a string");
  target = node->text;
}

void Section::choice(const char* key, std::string& target, const std::vector<std::string>& allowed,
                     const char* meaning) {
  if (const Node* node = given(key, "one of " + joined(allowed), target, meaning))
    target = checked_choice(*node, path_to(key), allowed);
}

void Section::choices(const char* key, std::vector<std::string>& target, const std::vector<std::string>& allowed,
                      const char* meaning) {
  const Node* node = given(key, "a list of any of " + joined(allowed), joined(target), meaning);
  if (!node) return;
  if (node->kind != Node::Kind::array) wrong_type(*node, path_to(key), "a list of any of " + joined(allowed));
  target.clear();
  for (std::size_t k = 0; k < node->items.size(); ++k)
    target.push_back(checked_choice(node->items[k], path_to(key) + "." + std::to_string(k), allowed));
}

void Section::boolean(const char* key, bool& target, const char* meaning) {
  const Node* node = given(key, "true or false", target ? "true" : "false", meaning);
  if (!node) return;
  if (node->kind != Node::Kind::boolean) wrong_type(*node, path_to(key), "true or false");
  target = node->boolean;
}

void Section::integer(const char* key, int& target, Range range, const char* meaning) {
  const Node* node = given(key, "an integer" + range.text(), std::to_string(target), meaning);
  if (!node) return;
  if (node->kind != Node::Kind::integer) wrong_type(*node, path_to(key), "an integer" + range.text());
  range.high = std::min<double>(range.high, std::numeric_limits<int>::max());
  target = static_cast<int>(checked_number(*node, path_to(key), range));
}

void Section::number(const char* key, double& target, Range range, const char* meaning) {
  const std::string initial = range.contains(target) ? shortest(target) : "";
  if (const Node* node = given(key, "a number" + range.text(), initial, meaning))
    target = checked_number(*node, path_to(key), range);
}

void Section::number(const char* key, std::optional<double>& target, Range range, const char* meaning) {
  if (const Node* node = given(key, "a number" + range.text(), "", meaning))
    target = checked_number(*node, path_to(key), range);
}

void Section::formula(const char* key, std::string& target, const std::vector<std::string>& variables,
                      const char* meaning) {
  if (const Node* node = given(key, "a formula of " + joined(variables) + ", or a number", target, meaning))
    target = checked_formula(*node, path_to(key), variables);
}

void Section::vector(const char* key, std::array<double, 2>& target, Range range, const char* meaning) {
  const std::string initial = range.contains(target[0]) ? text_of(target) : "";
  const Node* node = given(key, "[x, y], in 1D a number" + each(range), initial, meaning);
  if (!node) return;
  components(
      *node, path_to(key), static_cast<std::size_t>(dimension_), "an array of 2 numbers",
      [&](std::size_t k, const Node& item, const std::string& path) { target[k] = checked_number(item, path, range); });
}

void Section::interval(const char* key, std::optional<std::array<double, 2>>& target, Range range,
                       const char* meaning) {
  const Node* node = given(key, "[from, to]" + each(range), "", meaning);
  if (!node) return;
  target.emplace();
  components(*node, path_to(key), 2, "an array of 2 numbers",
             [&](std::size_t k, const Node& item, const std::string& path) {
               (*target)[k] = checked_number(item, path, range);
             });
}

void Section::integers(const char* key, std::array<int, 2>& target, Range range, const char* meaning) {
  const Node* node = given(key, "[nx, ny], in 1D an integer" + each(range), "chosen by the program", meaning);
  if (!node) return;
  components(*node, path_to(key), static_cast<std::size_t>(dimension_), "an array of 2 integers",
             [&](std::size_t k, const Node& item, const std::string& path) {
               if (item.kind != Node::Kind::integer) wrong_type(item, path, "an integer" + range.text());
               target[k] = static_cast<int>(checked_number(item, path, range));
             });
}

void Section::formulas(const char* key, std::string& x, std::string& y, const std::vector<std::string>& variables,
                       const char* meaning) {
  const Node* node = given(key, "[x, y] of formulas of " + joined(variables) + ", or numbers; in 1D one", x, meaning);
  if (!node) return;
  components(*node, path_to(key), static_cast<std::size_t>(dimension_), "an array of 2 formulas or numbers",
             [&](std::size_t k, const Node& item, const std::string& path) {
               (k == 0 ? x : y) = checked_formula(item, path, variables);
             });
}

void Section::state(const char* key, std::array<double, 4>& target, double p_inf, const char* meaning) {
  const Node* node = given(key, "[ρ, u, v, p], in 1D [ρ, u, p]; ρ > 0, p > −p_inf", "", meaning);
  if (!node) return;
  const bool plane = dimension_ == 2;
  const std::size_t last = plane ? 3 : 2;
  const char* example = plane ? "an array [ρ, u, v, p] of 4 numbers" : "an array [ρ, u, p] of 3 numbers";
  target = {};
  components(*node, path_to(key), last + 1, example, [&](std::size_t k, const Node& item, const std::string& path) {
    if (k == 0)
      target[0] = checked_number(item, path + " (density)", positive);
    else if (k == last)
      target[3] = checked_number(item, path + " (pressure)", {.low = 0 - p_inf, .low_open = true});
    else
      target[k] = checked_number(item, path + " (velocity)", any_number);
  });
}

void Section::points(const char* key, std::vector<std::array<double, 2>>& target, const char* meaning) {
  const Node* node = given(key, "[[x, y], …], at least 3", "", meaning);
  if (!node) return;
  if (node->kind != Node::Kind::array || node->items.size() < 3)
    wrong_type(*node, path_to(key), "an array of at least 3 points [x, y]");
  target.clear();
  for (std::size_t p = 0; p < node->items.size(); ++p) {
    target.emplace_back();
    components(node->items[p], path_to(key) + "." + std::to_string(p), 2, "a point [x, y]",
               [&](std::size_t k, const Node& item, const std::string& path) {
                 target.back()[k] = checked_number(item, path, any_number);
               });
  }
}

void Section::table(const char* key, const Visitor& visit) {
  if (list_) {
    Section inner(*list_, path_to(key));
    return visit(inner);
  }
  const Node* node = table_->member(key);
  if (node && node->kind != Node::Kind::table) wrong_type(*node, path_to(key), "a table");
  Node absent;
  absent.place = table_->place;
  Section inner(node ? *node : absent, path_to(key), dimension_);
  visit(inner);
}

void Section::tables(const char* key, const std::function<void(Section&, std::size_t)>& visit) {
  if (list_) {
    Section inner(*list_, path_to(key) + ".N");
    return visit(inner, 0);
  }
  const Node* node = table_->member(key);
  if (!node) return;
  const std::string path = path_to(key);
  if (node->kind != Node::Kind::array) wrong_type(*node, path, "an array of tables, [[" + path + "]]");
  for (std::size_t k = 0; k < node->items.size(); ++k) {
    const std::string entry = path + "." + std::to_string(k);
    if (node->items[k].kind != Node::Kind::table) wrong_type(node->items[k], entry, "a table");
    Section inner(node->items[k], entry, dimension_);
    visit(inner, k);
  }
}

void Section::require(const char* key, const char* allowed) {
  if (list_) required_.emplace_back(key);
  if (list_ || table_->member(key)) return;
  throw InputError(table_->place + ": the key \"" + path_to(key) + "\" is missing: " + allowed);
}

}  // namespace mortise
