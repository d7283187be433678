// `mortise study growth`: one member of the stability study, measured and predicted growth as a JSON file.
#pragma once

#include <optional>
#include <string>

#include "mortise/cases/study/member.hpp"

namespace mortise {

struct GrowthMemberOptions : StudyOptions {  // output: the file
  int steps = 400;
  bool along_wall = false;  // noise that varies along the wall (growth.hpp)
};

/// Measures the growth of small disturbances of the case and writes what came of it. 0, or 3 when a run failed.
int write_growth(GrowthMemberOptions options);

/// What the file says. NaN: not known.
struct GrowthRecord {
  std::string status, reason;
  double time = 0, steps = 0;
  double factor = 0, rate = 0, dt = 0;  // measured: growth per step and per time, mean step
  double predicted = 0, predicted_rate = 0, ratio = 0;
  std::string not_predicted;  // why, if it is not
};
GrowthRecord read_growth(const std::string& path);

}  // namespace mortise
