// A weak plane shock hits a free rigid cylinder: the acoustic answer (acoustic_cylinder.hpp), first order in the
// strength P = p_behind − p_ahead of the shock. Only the motion of the cylinder is known. With the gas ahead at rest in
// the cylinder's frame, t1 the time of first touch and n the direction of the shock,
//   v(t) = v(0) + n P/(ρc) V(c(t − t1)/a),   x(t) = x(0) + v(0) t + n a P/(ρc²) ∫V.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"

namespace mortise {

class WeakShockOnCylinder : public ExactSolution<2> {
 public:
  /// Reads initial.{kind = "shock", left (behind), right (ahead), position, angle}, one body of shape "circle" that
  /// moves with the gas ahead, its density or mass, and the gas. Throws InputError for another scene.
  explicit WeakShockOnCylinder(const CaseDescription& description);

  bool describes_fluid() const override { return false; }
  Primitive<2> state(const Point<2>& x, double t) const override;  // throws std::logic_error
  std::optional<std::vector<ExactMotion<2>>> bodies(double t) const override;

  double first_touch() const { return first_touch_; }

 private:
  Pose<2> start_;
  Point<2> start_velocity_, normal_;
  double radius_, density_ratio_;
  double sound_speed_;    // ahead
  double velocity_unit_;  // P/(ρc)
  double first_touch_;
};

}  // namespace mortise
