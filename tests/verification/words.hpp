// Lists of words: overrides of a case, arguments of the program.
#pragma once

#include <string>
#include <vector>

namespace mortise::testing {

using Words = std::vector<std::string>;

/// Both lists, one after the other.
inline Words operator+(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace mortise::testing
