// `mortise study stress`: random scenes that are hard on the program, for as long as one likes.
#pragma once

#include <cstdint>

#include "mortise/cases/study/member.hpp"

namespace mortise {

struct StressOptions : StudyOptions {
  double minutes = 5;
  std::uint64_t seed = 1;    // of the first scene, the next one has the next seed
  std::uint64_t scenes = 0;  // at most; 0: as many as there is time for
  double time_limit = 120;   // seconds after which a run counts as hanging
};

/// Runs scenes side by side until the time is over. Keeps a journal, so that a study that was interrupted goes on with
/// the seed after its last one; every scene that failed stays as a case file in failures/. 0 where all of them passed,
/// were refused or failed numerically (and said so); 3 otherwise. Throws InputError before anything runs.
int study_stress(StressOptions options);

}  // namespace mortise
