// Something that advances tiles of the background in place of the fluid's own step: a mixture of gas and solids.
#pragma once

#include "mortise/fluid/godunov_step.hpp"

namespace mortise {

template <int Dim>
class TileStepper {
 public:
  virtual ~TileStepper() = default;
  /// This local tile of the background is not the fluid's alone.
  virtual bool covers(int tile) const = 0;
  /// As godunov_step(), but that the rate is set later (EulerSolver::rates()).
  virtual StepResult step(const CartesianTile<Dim>& cells, int tile, double dt, const StepOptions& options) = 0;
  /// As wave_rate().
  virtual StepResult rate(const CartesianTile<Dim>& cells, int tile, const StepOptions& options) = 0;
};

}  // namespace mortise
