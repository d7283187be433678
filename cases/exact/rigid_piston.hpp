// The gas next to a rigid piston whose motion X(t), v(t) is known (piston_motion.hpp), as long as it is a simple wave.
// Right of the piston the right-going characteristics are straight and carry the state of the wall they left at time τ:
//   x = X(τ) + (v(τ) + c(τ)) (t − τ),  u = v(τ),  c = c0 + (γ−1)/2 (v(τ) − u0),  ρ = ρ0 (c/c0)^(2/(γ−1)),
//   p̃ = p̃0 (c/c0)^(2γ/(γ−1));  undisturbed for x ≥ X(0) + (u0 + c0) t;  left of it mirrored.
// A piston set into motion away from the gas at once sends a centred fan from x = X(0) first. The solution ends where
// two characteristics cross, t = min over τ of τ + 2c/((γ+1)|v'|) on the compressed side (a shock forms), or where the
// piston leaves the gas behind (c = 0). Source: Whitham, Linear and Nonlinear Waves, section 6.8.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/piston_motion.hpp"

namespace mortise {

class RigidPiston : public ExactSolution<1> {
 public:
  /// Reads one body of shape "slab" (gas on both sides) or "half_space" (gas on the side without solid; position is
  /// that of its face), its mass (or density × width), velocity, force_x and motion_x, gravity, the initial states at
  /// its faces, the gas and time.end. The gas may differ on both sides but is uniform on each. Throws InputError for
  /// another scene.
  explicit RigidPiston(const CaseDescription& description);
  RigidPiston(const PistonProblem& problem, double width);

  Primitive<1> state(const Point<1>& x, double t) const override;
  std::optional<std::vector<ExactMotion<1>>> bodies(double t) const override;

  /// The first time a shock forms or the gas no longer follows the piston, at most the time covered; 0 if the piston
  /// runs into the gas with a jump of velocity. Later the answers are not those of the Euler equations.
  double valid_until() const override { return valid_until_; }

 private:
  Primitive<1> simple_wave(const Primitive<1>& gas, double n, double distance, double t) const;
  double wall_sound_speed(const Primitive<1>& gas, double n, double tau) const;
  double emission_time(const Primitive<1>& gas, double n, double distance, double t) const;
  double end_of_simple_wave(const Primitive<1>& gas, double n) const;

  PistonProblem problem_;
  double width_;
  PistonMotion motion_;
  double valid_until_;
};

}  // namespace mortise
