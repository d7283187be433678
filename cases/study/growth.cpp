#include "mortise/cases/study/growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "mortise/cases/driver/initial_check.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/cases/study/difference.hpp"
#include "mortise/cases/study/noise.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr std::size_t first_steps = 6;  // are short, and the schemes' histories fill in them
constexpr double outgrown = 1e3;        // energy over that of the noise
constexpr double round_off = 1e-14;     // relative amplitude at which a difference is one of round-off

/// The two runs.
template <int Dim>
class Twins {
 public:
  Twins(const CaseDescription& description, const DisturbanceOptions& options)
      : description_(description),
        options_(options),
        base_(start(description, 0)),
        twin_(start(description, options.amplitude)) {
    base_.initialize();
    check_initial_state(description, base_);
    twin_.initialize();
  }

  Growth measure() {
    record();
    while (growth_.status.empty()) step();
    growth_.time = base_.time();
    growth_.steps = base_.steps();
    fit_growth(growth_, times_);
    return growth_;
  }

 private:
  Simulation<Dim> start(const CaseDescription& description, double amplitude) const;

  void step() {
    try {
      base_.advance(description_.time_end);
      twin_.follow(base_);
    } catch (const NumericalError& error) {
      return end("unstable", error.what());
    }
    record();
    const double amplitude = growth_.amplitude.back();
    if (!(amplitude <= options_.linear))
      return end("grown", "the difference has left the linear regime: " + text(amplitude));
    if (amplitude <= round_off) return end("damped", "the difference has fallen to round-off: " + text(amplitude));
    if (base_.steps() >= options_.steps) return end("finished", "all steps are done");
    if (base_.time() >= description_.time_end) end("finished", "the end of the case is reached");
  }
  void end(const std::string& status, const std::string& reason) {
    growth_.status = status;
    growth_.reason = reason;
  }
  void record() {
    const Difference now = difference(base_, twin_);
    growth_.energy.push_back(now.energy);
    growth_.amplitude.push_back(now.amplitude);
    times_.push_back(base_.time());
  }
  static std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g", value);
    return digits;
  }

  CaseDescription description_;
  DisturbanceOptions options_;
  Simulation<Dim> base_, twin_;
  std::vector<double> times_;
  Growth growth_;
};

template <int Dim>
Simulation<Dim> Twins<Dim>::start(const CaseDescription& description, double amplitude) const {
  Scene<Dim> scene = build_scene<Dim>(description);
  const bool plane = description.dimension == 1 && !options_.along_wall;
  if (amplitude > 0) disturb<Dim>(scene.setup, description.spacing(), plane, amplitude, options_.seed);
  return Simulation<Dim>(Communicator(), std::move(scene.setup));
}

/// The first energy of the window: of the second half, beyond the first steps, and, where the difference has outgrown
/// the noise by far, beyond those that the noise still has a part in; but at least three are left, if there are as
/// many.
std::size_t window_start(const std::vector<double>& energy) {
  const std::size_t latest = energy.size() > 4 ? energy.size() - 4 : 0;
  std::size_t first = std::max(energy.size() / 2, std::min(first_steps, latest));
  if (first + 3 > energy.size()) first = energy.size() > 3 ? energy.size() - 3 : 0;
  if (energy.back() > outgrown * outgrown * energy.front())
    while (first < latest && energy[first] < outgrown * energy.front()) ++first;
  return first;
}

}  // namespace

void fit_growth(Growth& growth, const std::vector<double>& times) {
  const std::vector<double>& energy = growth.energy;
  const std::size_t first = window_start(energy), size = energy.size();
  growth.first = static_cast<std::int64_t>(first);
  growth.last = static_cast<std::int64_t>(size) - 1;
  growth.factor = growth.rate = growth.dt = std::numeric_limits<double>::quiet_NaN();
  if (size < first + 3 || !(energy.back() > 0)) return;
  const double steps = static_cast<double>(size - first), middle = 0.5 * (steps - 1);
  double product = 0, square = 0;
  for (std::size_t n = first; n < size; ++n) {
    const double step = static_cast<double>(n - first) - middle;
    product += step * std::log(energy[n]);
    square += step * step;
  }
  growth.factor = std::exp(0.5 * product / square);
  growth.dt = (times.back() - times[first]) / (steps - 1);
  growth.rate = std::log(growth.factor) / growth.dt;
}

Growth measure_growth(const CaseDescription& description, const DisturbanceOptions& options) {
  if (!(options.amplitude > 0) || !(options.amplitude < options.linear))
    throw InputError("the noise needs an amplitude between 0 and " + std::to_string(options.linear));
  if (options.steps < 1) throw InputError("growth needs steps to be measured in");
  if (scene_dimension(description) == 1) return Twins<1>(description, options).measure();
  return Twins<2>(description, options).measure();
}

}  // namespace mortise
