// The gas next to a rigid piston whose motion X(t), v(t) is known (piston_motion.hpp), as long as it is a simple wave
// on either side (simple_wave.hpp).
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/exact/piston_motion.hpp"
#include "mortise/cases/exact/simple_wave.hpp"

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
  PistonProblem problem_;
  double width_;
  std::shared_ptr<const PistonMotion> motion_;
  std::optional<SimpleWave> left_, right_;
  double valid_until_;
};

}  // namespace mortise
