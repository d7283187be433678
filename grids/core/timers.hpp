// Wall-clock time by phase of the step, for summary.json. Every second belongs to one phase, the innermost under way.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace mortise {

class PhaseTimers {
 public:
  /// Adds the time from now to the end of the scope to a phase, but for that of scopes within.
  class Scope {
   public:
    Scope(PhaseTimers& timers, double& total) : timers_(timers), enclosing_(timers.turn_to(&total)) {}
    ~Scope() { timers_.turn_to(enclosing_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    PhaseTimers& timers_;
    double* enclosing_;
  };

  [[nodiscard]] Scope operator()(const std::string& phase) { return Scope(*this, seconds_[phase]); }
  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Ends the time of the phase under way, which is returned, and begins that of another (nullptr: none).
  double* turn_to(double* total) {
    const Clock::time_point now = Clock::now();
    if (running_) *running_ += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    return std::exchange(running_, total);
  }

  std::map<std::string, double> seconds_;  // phase → seconds
  double* running_ = nullptr;              // of the phase under way
  Clock::time_point since_{};
};

}  // namespace mortise
