// Plane waves in an unbounded linear solid: u = Σ a d φ(k·X − c t), with c = c_p, d = k (pressure waves) or c = c_s,
// d ⟂ k (shear waves, d = k turned by 90°).
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/solid/material.hpp"

namespace mortise {

enum class PlaneWaveKind { pressure, shear };

/// φ(s): sine sin(2π(s − center)/length); pulse: sin⁴(π(s − center)/length + π/2), zero half a length from the centre;
/// gaussian: exp(−((s − center)/length)²).
enum class WaveProfile { sine, pulse, gaussian };

/// Non-dimensional.
struct PlaneWave {
  PlaneWaveKind kind = PlaneWaveKind::pressure;
  WaveProfile profile = WaveProfile::sine;
  double angle = 0;  // of k from +x, radians
  double amplitude = 0;
  double center = 0, length = 1;
};

class PlaneWaves : public ExactSolution<2> {
 public:
  PlaneWaves(const Material& material, std::vector<PlaneWave> waves);

  /// Throws std::logic_error: there is no fluid.
  Primitive<2> state(const Point<2>& x, double t) const override;
  bool describes_fluid() const override { return false; }
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;

 private:
  Material material_;
  std::vector<PlaneWave> waves_;
};

}  // namespace mortise
