// The progress of a study: members done, running, and the time left.
#pragma once

#include <chrono>
#include <string>

namespace mortise {

class PoolProgress {
 public:
  /// `done` of `count` members need not be run; `work`: the weights of the others. budget: seconds in all, 0: none.
  PoolProgress(std::size_t count, std::size_t done, double work, bool quiet, double budget);
  /// A line on a terminal, refreshed a few times a second.
  void show(std::size_t running);
  /// A member has ended: a plain line where there is no terminal.
  void ended(const std::string& name, double weight, double seconds, std::size_t running);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(std::size_t running) const;

  std::size_t count_, done_;
  double work_, work_done_ = 0, budget_;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point began_ = Clock::now(), last_ = began_;
};

}  // namespace mortise
