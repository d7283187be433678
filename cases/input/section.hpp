// The schema layer: a case file's keys are described once, by calls on a Section, and the description serves three
// ends: reading a file, finding unknown keys, and `mortise list keys`.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mortise/cases/input/node.hpp"

namespace mortise {

/// An interval of allowed numbers, whose ends are allowed unless they are open.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool contains(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
  std::string text() const;  // "", " > 0", " in (0, 1]"
};
inline constexpr Range any_number{};
inline constexpr Range positive{.low = 0, .low_open = true};
inline constexpr Range non_negative{.low = 0};

/// One key, for people.
struct KeyEntry {
  std::string path;     // dotted; N stands for an index
  std::string allowed;  // type and range: "a number in (0, 1]"
  std::string initial;  // default as text; empty: none
  std::string meaning;
};

/// One table of a case file. With a node it reads the keys that are there into their targets and leaves the others as
/// they are; with a list it records what the keys are, their targets holding the defaults. All readers throw
/// InputError.
class Section {
 public:
  Section(const Node& table, std::string path, int dimension)
      : table_(&table), path_(std::move(path)), dimension_(dimension) {}
  Section(std::vector<KeyEntry>& list, std::string path) : list_(&list), path_(std::move(path)) {}

  int dimension() const { return dimension_; }
  void set_dimension(int dimension) { dimension_ = dimension; }

  void text(const char* key, std::string& target, const char* meaning);
  void choice(const char* key, std::string& target, const std::vector<std::string>& allowed, const char* meaning);
  void choices(const char* key, std::vector<std::string>& target, const std::vector<std::string>& allowed,
               const char* meaning);
  void boolean(const char* key, bool& target, const char* meaning);
  void integer(const char* key, int& target, Range range, const char* meaning);
  void number(const char* key, double& target, Range range, const char* meaning);
  void number(const char* key, std::optional<double>& target, Range range, const char* meaning);
  void formula(const char* key, std::string& target, const std::vector<std::string>& variables, const char* meaning);

  /// [x, y]; in 1D a number.
  void vector(const char* key, std::array<double, 2>& target, Range range, const char* meaning);
  /// [t0, t1], whatever the dimension.
  void interval(const char* key, std::optional<std::array<double, 2>>& target, Range range, const char* meaning);
  void integers(const char* key, std::array<int, 2>& target, Range range, const char* meaning);
  void formulas(const char* key, std::string& x, std::string& y, const std::vector<std::string>& variables,
                const char* meaning);
  /// [ρ, u, v, p]; in 1D [ρ, u, p]. ρ > 0, p > −p_inf.
  void state(const char* key, std::array<double, 4>& target, double p_inf, const char* meaning);
  /// [[x, y], …]
  void points(const char* key, std::vector<std::array<double, 2>>& target, const char* meaning);

  using Visitor = std::function<void(Section&)>;
  /// A sub-table, visited even when it is not there, so that its required keys are missed.
  void table(const char* key, const Visitor& visit);
  /// An array of tables: `visit(section, k)` for each.
  void tables(const char* key, const std::function<void(Section&, std::size_t)>& visit);

  /// Throws the error for an absent key, of which `allowed` says what it could be. Called before the key is described.
  void require(const char* key, const char* allowed);

 private:
  const Node* given(const char* key, const std::string& allowed, const std::string& initial, const char* meaning);
  std::string path_to(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }
  double checked_number(const Node& node, const std::string& path, Range range) const;
  std::string checked_formula(const Node& node, const std::string& path,
                              const std::vector<std::string>& variables) const;
  void components(const Node& node, const std::string& path, std::size_t count, const char* example,
                  const std::function<void(std::size_t, const Node&, const std::string&)>& read) const;

  const Node* table_ = nullptr;
  std::vector<KeyEntry>* list_ = nullptr;
  std::vector<std::string> required_;  // keys to be listed as such
  std::string path_;
  int dimension_ = 2;
};

}  // namespace mortise
