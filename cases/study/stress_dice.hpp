// Random choices that are the same on every machine: std::mt19937_64 is, the distributions of the standard library are
// not.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace mortise {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ull + 0xD1B54A32D192ED03ull) {}

  /// In [low, high), to four significant digits, as a person would write it.
  double between(double low, double high) { return rounded(low + (high - low) * unit()); }
  /// 10^u with u in [low, high), likewise.
  double decades(double low, double high) { return rounded(std::pow(10.0, low + (high - low) * unit())); }
  int whole(int low, int high) { return low + static_cast<int>((high - low + 1) * unit()); }  // high included
  bool chance(double probability) { return unit() < probability; }

  template <class Value>
  const Value& pick(const std::vector<Value>& from) {
    return from[static_cast<std::size_t>(static_cast<double>(from.size()) * unit())];
  }
  std::string word(const std::vector<std::string>& from) { return pick(from); }

  static double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return std::strtod(text, nullptr);
  }

 private:
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // in [0, 1)

  std::mt19937_64 engine_;
};

}  // namespace mortise
