#include "mortise/cases/study/pool_progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace mortise {

PoolProgress::PoolProgress(std::size_t count, std::size_t done, double work, bool quiet, double budget)
    : count_(count), done_(done), work_(work), budget_(budget), quiet_(quiet), terminal_(isatty(STDOUT_FILENO) != 0) {
  if (!quiet_ && done_ > 0) std::printf("%zu of %zu members have been run before\n", done_, count_);
}

std::string PoolProgress::line(std::size_t running) const {
  constexpr int width = 24;
  const double elapsed = std::chrono::duration<double>(Clock::now() - began_).count();
  double part = work_ > 0 ? work_done_ / work_ : 1;
  if (budget_ > 0) part = std::max(part, std::min(1.0, elapsed / budget_));
  std::string bar(static_cast<std::size_t>(width * part), '#');
  bar.resize(width, '.');
  char left[32] = "?";
  if (part > 0) std::snprintf(left, sizeof left, "%.0f s", elapsed * (1 - part) / part);
  char text[160];
  std::snprintf(text, sizeof text, "[%s] %zu/%zu members, %zu running  eta %s", bar.c_str(), done_, count_, running,
                left);
  return text;
}

void PoolProgress::show(std::size_t running) {
  if (quiet_ || !terminal_ || std::chrono::duration<double>(Clock::now() - last_).count() < 0.2) return;
  last_ = Clock::now();
  std::printf("\r%s   ", line(running).c_str());
  std::fflush(stdout);
  shown_ = true;
}

void PoolProgress::ended(const std::string& name, double weight, double seconds, std::size_t running) {
  ++done_;
  work_done_ += weight;
  if (quiet_ || terminal_) return;
  std::printf("%s  %s took %.2g s\n", line(running).c_str(), name.c_str(), seconds);
  std::fflush(stdout);
}

void PoolProgress::finish() {
  if (shown_) std::printf("\r%s   \n", line(0).c_str());
}

}  // namespace mortise
