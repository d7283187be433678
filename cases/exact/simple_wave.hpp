// The gas beside a wall that moves along its normal n (from the wall into the gas), as long as it is a simple wave. The
// characteristics that leave the wall are straight and carry the state at the time τ they left it; with n = 1
//   x = X(τ) + (v(τ) + c(τ)) (t − τ),  u = v(τ),  c = c0 + (γ−1)/2 (v(τ) − u0),  ρ = ρ0 (c/c0)^(2/(γ−1)),
//   p̃ = p̃0 (c/c0)^(2γ/(γ−1));  undisturbed for x ≥ X(0) + (u0 + c0) t;  n = −1 is the mirror image.
// A wall set into motion away from the gas at once sends a centred fan from X(0) first. The solution ends where two
// characteristics cross, t = min over τ of τ + 2c/((γ+1)|v'|) on the compressed side (a shock forms), or where the
// wall leaves the gas behind (c = 0). Source: Whitham, Linear and Nonlinear Waves, section 6.8.
#pragma once

#include <functional>

#include "mortise/fluid/state.hpp"

namespace mortise {

/// Functions of t, 0 ≤ t ≤ time_end. Non-dimensional.
struct WallMotion {
  std::function<double(double)> position, velocity;
  std::function<double(double)> acceleration;  // steers iterations and finds where shocks form; a few digits will do
  double time_end = 1;
};

class SimpleWave {
 public:
  /// gas: (ρ0, u0, p̃0) at t = 0; n = 1 or −1.
  SimpleWave(const Primitive<1>& gas, double gamma, double n, WallMotion wall);

  /// (ρ, u, p̃) at a distance from the wall's place at t = 0, measured along n.
  Primitive<1> state(double distance, double t) const;

  /// p̃ on the wall.
  double wall_pressure(double t) const;

  /// The first time a shock forms or the gas no longer follows the wall, at most wall.time_end; 0 if the wall runs into
  /// the gas with a jump of velocity. Later the answers are not those of the Euler equations.
  double valid_until() const { return valid_until_; }

 private:
  double wall_sound_speed(double tau) const;
  double emission_time(double distance, double t) const;
  double end() const;
  Primitive<1> isentropic(double u) const;

  Primitive<1> gas_;
  double gamma_, n_;
  WallMotion wall_;
  double c0_;
  double valid_until_;
};

}  // namespace mortise
