// Options by key. Adding an entry adds the option; an unknown key is answered with the nearest valid one.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mortise/grids/core/error.hpp"

namespace mortise {

/// The candidate nearest to `word` in edit distance; empty when none is near (distance > 1/2 of the length).
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

/// A list of (key, value) in the order given. `what` names the option in errors: "limiter", "Riemann solver".
template <class Value>
class Registry {
 public:
  Registry(std::string what, std::vector<std::pair<std::string, Value>> entries)
      : what_(std::move(what)), entries_(std::move(entries)) {}

  /// Throws InputError naming the nearest key and all keys.
  const Value& at(std::string_view key) const {
    for (const auto& [name, value] : entries_)
      if (name == key) return value;
    const std::string guess = nearest(key, keys());
    throw InputError("unknown " + what_ + " \"" + std::string(key) + "\"" +
                     (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") + " (known: " + joined(keys()) + ")");
  }
  std::vector<std::string> keys() const {
    std::vector<std::string> names;
    for (const auto& entry : entries_) names.push_back(entry.first);
    return names;
  }

 private:
  std::string what_;
  std::vector<std::pair<std::string, Value>> entries_;
};

}  // namespace mortise
