#include "mortise/cases/driver/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace mortise {

Progress::Progress(double start, double end, bool silent)
    : start_(start), end_(end), next_plain_(start), silent_(silent), terminal_(isatty(STDOUT_FILENO) != 0) {
  began_ = last_ = std::chrono::steady_clock::now();
}

double Progress::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count(); }

void Progress::step(double time, std::int64_t step, double dt, std::int64_t cell_updates) {
  if (silent_) return;
  const auto now = std::chrono::steady_clock::now();
  const bool due = terminal_ ? std::chrono::duration<double>(now - last_).count() > 0.2 : time >= next_plain_;
  if (!due) return;
  last_ = now;
  if (!terminal_) next_plain_ = time + (end_ - start_) / 20;
  print(time, step, dt, cell_updates);
}

void Progress::print(double time, std::int64_t step, double dt, std::int64_t cell_updates) {
  constexpr int width = 24;
  const double done = end_ > start_ ? std::clamp((time - start_) / (end_ - start_), 0.0, 1.0) : 1.0;
  const double elapsed = seconds();
  const double remaining = done > 0 ? elapsed * (1 - done) / done : 0;
  std::string bar(static_cast<std::size_t>(width * done), '#');
  bar.resize(width, '.');
  std::printf("%s[%s] t %.4g/%.4g  step %lld  dt %.3g  %.1f Mcell/s  eta %.0f s%s", terminal_ ? "\r" : "", bar.c_str(), time, end_,
              static_cast<long long>(step), dt, 1e-6 * static_cast<double>(cell_updates) / std::max(elapsed, 1e-9), remaining,
              terminal_ ? "   " : "\n");
  std::fflush(stdout);
  printed_ = true;
}

void Progress::finish() {
  if (!silent_ && terminal_ && printed_) std::printf("\n");
}

}  // namespace mortise
