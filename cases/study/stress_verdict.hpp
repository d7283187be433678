// What to make of a run of the program on a scene that was meant to be hard on it.
#pragma once

#include <string>
#include <vector>

namespace mortise {

enum class Verdict {
  passed,     // finished, and every number it reports is one
  refused,    // the input is wrong: nothing was run
  numerical,  // the computation failed, and says so
  crash,      // ended by a signal, or with a status that is not one of the program's
  hang,       // had to be stopped
  lied,       // said that it finished, but has a number that is none, or a summary that says otherwise
  orphans     // finished, with cells at the overlap that got no values
};

/// "passed", …
const char* name_of(Verdict verdict);
/// In the order above.
const std::vector<Verdict>& verdicts();
/// A user may expect it of the program: passed, refused, numerical.
bool acceptable(Verdict verdict);

/// How a process ended.
struct RunEnding {
  bool timed_out = false;
  int signal = 0;  // that ended it; 0: none
  int status = 0;  // its exit status otherwise
};

struct Judgement {
  Verdict verdict = Verdict::passed;
  std::string reason;  // one sentence; empty where it passed
};

/// `summary`: the text of its summary.json, empty if there is none.
Judgement judge_run(const RunEnding& ending, const std::string& summary);

/// The same of a run with its output in `directory`: besides summary.json the last rows of bodies.csv and interface.csv
/// must hold numbers.
Judgement judge_run_in(const RunEnding& ending, const std::string& directory);

}  // namespace mortise
