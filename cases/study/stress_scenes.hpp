// Random scenes for `mortise study stress`: complete case files that are valid, small, and as hard on the program as
// input can be. A scene is a function of its seed alone, on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mortise {

struct StressScene {
  std::string kind;  // one of stress_kinds()
  std::string text;  // the case file
  bool robust =
      false;  // admissible for a scheme that is stable by design: a numerical failure is a defect of the program
};

/// What kinds of scenes there are.
const std::vector<std::string>& stress_kinds();

StressScene draw_stress_scene(std::uint64_t seed);

/// The text of its case file.
std::string stress_scene(std::uint64_t seed);

}  // namespace mortise
