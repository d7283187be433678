#include "mortise/cases/exact/plane_waves.hpp"

#include <cmath>
#include <numbers>

#include "mortise/cases/exact/linear_elasticity.hpp"

namespace mortise {
namespace {

struct Profile {
  double value, slope;
};

/// φ and φ' at s.
Profile profile_of(const PlaneWave& wave, double s) {
  using std::numbers::pi;
  const double theta = (s - wave.center) / wave.length;
  switch (wave.profile) {
    case WaveProfile::sine:
      return {std::sin(2 * pi * theta), 2 * pi / wave.length * std::cos(2 * pi * theta)};
    case WaveProfile::pulse: {
      if (std::abs(theta) >= 0.5) return {0, 0};
      const double c = std::cos(pi * theta);
      return {c * c * c * c, -4 * pi / wave.length * c * c * c * std::sin(pi * theta)};
    }
    case WaveProfile::gaussian: {
      const double value = std::exp(-theta * theta);
      return {value, -2 * theta / wave.length * value};
    }
  }
  throw std::logic_error("unknown profile of a plane wave");
}

}  // namespace

PlaneWaves::PlaneWaves(const Material& material, std::vector<PlaneWave> waves)
    : material_(material), waves_(std::move(waves)) {}

Primitive<2> PlaneWaves::state(const Point<2>&, double) const {
  throw std::logic_error("plane waves in a solid do not describe a fluid");
}

ExactSolid PlaneWaves::solid(const Point<2>& X, double t) const {
  ExactSolid sum;
  for (const PlaneWave& wave : waves_) {
    const bool pressure = wave.kind == PlaneWaveKind::pressure;
    const double c = std::sqrt((pressure ? pressure_modulus(material_) : material_.mu) / material_.density);
    const Point<2> k = direction(wave.angle), d = pressure ? k : left_of(k);
    const Profile phi = profile_of(wave, k.dot(X) - c * t);
    sum += plane_motion(material_, k, d, -wave.amplitude * c * phi.slope, wave.amplitude * phi.value,
                        wave.amplitude * phi.slope);
  }
  return sum;
}

}  // namespace mortise
