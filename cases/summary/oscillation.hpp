// The dominant oscillation in a history of one quantity, such as the height of the tail of a flag.
#pragma once

#include <array>
#include <span>

namespace mortise {

/// Non-dimensional, in the units of the history.
struct Oscillation {
  double mean = 0;        // weighted with the window of the transform
  double amplitude = 0;   // of the dominant harmonic, peak; 0 where nothing moves
  double frequency = 0;   // of the same, cycles per time
  double half_range = 0;  // (max − min)/2 of the history itself
  // Of all there is, for what moves irregularly; of a single sine the same as amplitude and frequency.
  double rms_amplitude = 0;   // √2 times the root mean square of the deviation from its mean
  double mean_frequency = 0;  // of the harmonics, weighted with the squares of their amplitudes
};

/// Of `values` at `times` (equally many, increasing, steps may differ) within window[0] ≤ t ≤ window[1], which the
/// history has to cover. Amplitude and frequency of a single sine are good to 1e-3 from about four periods in the
/// window on; a motion of fewer than two is seen as a trend, not as an oscillation. Throws InputError when the history
/// does not cover the window.
Oscillation oscillation_of(std::span<const double> times, std::span<const double> values,
                           const std::array<double, 2>& window);

}  // namespace mortise
