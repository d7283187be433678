// When a run writes. The times are those of the whole case, whatever --until says, so that a run in pieces takes the
// same steps as a run in one go; they follow from the time alone, so that a run may go on with other frames.
#pragma once

#include <cmath>
#include <limits>

#include "mortise/cases/input/case_description.hpp"

namespace mortise {

/// The first multiple of the interval after `time`; infinite without an interval.
inline double next_multiple(double time, double interval) {
  if (!(interval > 0)) return std::numeric_limits<double>::infinity();
  return interval * (std::floor(time / interval * (1 + 1e-12)) + 1);
}

/// Of frame `number` ≥ 0; the end of a case without frames.
inline double frame_time(const CaseDescription& description, int number) {
  return description.frames > 0 ? description.time_end * number / description.frames : description.time_end;
}

/// Number of the first frame after `time`.
inline int next_frame(const CaseDescription& description, double time) {
  return static_cast<int>(std::floor(time / description.time_end * description.frames * (1 + 1e-12))) + 1;
}

}  // namespace mortise
