// Spectrum of q − mean under a Hann window w_n = ½(1 − cos 2πn/N): a sine of amplitude A that is δ bins beside bin k,
// |δ| ≤ ½, has
//   |X_k| = ¼ A N W(δ),  W(δ) = sin(πδ)/(πδ (1 − δ²)),   and   |X_{k+1}|/|X_k| = (1 + δ)/(2 − δ),
// so that its frequency and amplitude follow from the largest line and its larger neighbour.
#include "mortise/cases/summary/oscillation.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr double still = 1e-12;       // of the largest value: less is round-off, not motion
constexpr std::size_t least_bin = 2;  // periods in the window
constexpr std::size_t most_samples = 1 << 18;

/// q(t) by the cubic through the four nearest points; `next` is the first point after t, kept from call to call.
double value_at(double t, std::span<const double> times, std::span<const double> values, std::size_t& next) {
  const std::size_t n = times.size();
  while (next + 1 < n && times[next] < t) ++next;
  const std::size_t points = std::min<std::size_t>(4, n);
  const std::size_t first = std::min(next < 2 ? 0 : next - 2, n - points);
  double sum = 0;
  for (std::size_t i = first; i < first + points; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (t - times[j]) / (times[i] - times[j]);
    sum += weight * values[i];
  }
  return sum;
}

/// |X_k| of real samples, k = 0 … N/2.
std::vector<double> spectrum(std::vector<double>& samples) {
  std::vector<std::complex<double>> lines(samples.size() / 2 + 1);
  const fftw_plan plan = fftw_plan_dft_r2c_1d(static_cast<int>(samples.size()), samples.data(),
                                              reinterpret_cast<fftw_complex*>(lines.data()), FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  std::vector<double> sizes;
  for (const auto& line : lines) sizes.push_back(std::abs(line));
  return sizes;
}

/// The root mean square of the deviations from the mean.
double deviation(const std::vector<double>& samples) {
  double sum = 0, squares = 0;
  for (const double sample : samples) sum += sample;
  const double mean = sum / static_cast<double>(samples.size());
  for (const double sample : samples) squares += (sample - mean) * (sample - mean);
  return std::sqrt(squares / static_cast<double>(samples.size()));
}

}  // namespace

Oscillation oscillation_of(std::span<const double> times, std::span<const double> values,
                           const std::array<double, 2>& window) {
  const auto [begin, end] = window;
  const double slack = 1e-9 * (end - begin);
  if (times.size() < 2 || times.front() > begin + slack || times.back() < end - slack)
    throw InputError("the history does not cover the window of the oscillation");
  Oscillation found;
  double low = std::numeric_limits<double>::infinity(), high = -low, largest = 0;
  std::size_t inside = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] < begin - slack || times[k] > end + slack) continue;
    low = std::min(low, values[k]), high = std::max(high, values[k]);
    largest = std::max(largest, std::abs(values[k]));
    ++inside;
  }
  if (inside == 0) throw InputError("the history has no points in the window of the oscillation");
  found.half_range = 0.5 * (high - low);

  std::size_t count = 64;
  while (count < 2 * inside && count < most_samples) count *= 2;
  std::vector<double> samples(count), hann(count);
  double sum = 0;
  std::size_t next = 0;
  const auto n = static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double place = static_cast<double>(k) / n;
    samples[k] = value_at(begin + (end - begin) * place, times, values, next);
    hann[k] = 0.5 * (1 - std::cos(2 * std::numbers::pi * place));
    sum += hann[k] * samples[k];
  }
  found.mean = sum / (0.5 * n);
  if (found.half_range <= still * largest) return found;
  found.rms_amplitude = std::numbers::sqrt2 * deviation(samples);
  for (std::size_t k = 0; k < count; ++k) samples[k] = hann[k] * (samples[k] - found.mean);
  const std::vector<double> lines = spectrum(samples);
  double power = 0, moment = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    power += lines[k] * lines[k];
    moment += static_cast<double>(k) * lines[k] * lines[k];
  }
  if (power > 0) found.mean_frequency = moment / power / (end - begin);
  const auto peak = std::max_element(lines.begin() + least_bin, lines.end() - 1);
  if (!(*peak > 0)) return found;
  const bool above = *(peak + 1) > *(peak - 1);
  const double ratio = (above ? *(peak + 1) : *(peak - 1)) / *peak;
  const double shift = std::clamp((2 * ratio - 1) / (ratio + 1), 0.0, 0.5), angle = std::numbers::pi * shift;
  const double height = shift > 0 ? std::sin(angle) / (angle * (1 - shift * shift)) : 1;
  found.amplitude = 4 * *peak / (n * height);
  found.frequency = (static_cast<double>(peak - lines.begin()) + (above ? shift : -shift)) / (end - begin);
  return found;
}

}  // namespace mortise
