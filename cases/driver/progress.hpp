// The progress line: a bar on a terminal, a plain line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>

namespace mortise {

class Progress {
 public:
  /// silent: prints nothing (ranks other than 0, --quiet).
  Progress(double start, double end, bool silent);
  /// Called after every step; prints at most a few times a second on a terminal, and about twenty times in all elsewhere.
  void step(double time, std::int64_t step, double dt, std::int64_t cell_updates);
  /// Ends the line.
  void finish();
  double seconds() const;

 private:
  void print(double time, std::int64_t step, double dt, std::int64_t cell_updates);

  double start_, end_, next_plain_;
  bool silent_, terminal_, printed_ = false;
  std::chrono::steady_clock::time_point began_, last_;
};

}  // namespace mortise
