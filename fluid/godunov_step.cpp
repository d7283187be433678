// Choice of the kernel by geometry and Riemann solver.
#include "mortise/fluid/godunov_step.hpp"

#include "mortise/fluid/step_kernels.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

StepResult godunov_step(const MovingLineTile& tile, double dt, const StepOptions& options) {
  MORTISE_ASSERT(tile.line.shape->cells[0] % 2 == 0, "tiles have an even number of cells");
  switch (options.riemann) {
    case RiemannSolver::exact:
      return line_step<ExactRiemann>(tile, dt, options);
    case RiemannSolver::hlle:
      return line_step<Hlle>(tile, dt, options);
    case RiemannSolver::hllc:
      break;
  }
  return line_step<Hllc>(tile, dt, options);
}

template <>
StepResult godunov_step<1>(const CartesianTile<1>& tile, double dt, const StepOptions& options) {
  return godunov_step(MovingLineTile{tile, 0, {}, {}}, dt, options);
}

template <>
StepResult godunov_step<2>(const CartesianTile<2>& tile, double dt, const StepOptions& options) {
  MORTISE_ASSERT(tile.shape->cells[0] % 2 == 0, "tiles have an even number of cells");
  switch (options.riemann) {
    case RiemannSolver::exact:
      return cartesian_step<ExactRiemann>(tile, dt, options);
    case RiemannSolver::hlle:
      return cartesian_step<Hlle>(tile, dt, options);
    case RiemannSolver::hllc:
      break;
  }
  return cartesian_step<Hllc>(tile, dt, options);
}

StepResult godunov_step(const CurvilinearTile& tile, double dt, const StepOptions& options) {
  MORTISE_ASSERT(tile.shape->cells[0] % 2 == 0 && tile.shape->cells[1] > 1, "tiles have an even number of cells");
  switch (options.riemann) {
    case RiemannSolver::exact:
      return curvilinear_step<ExactRiemann>(tile, dt, options);
    case RiemannSolver::hlle:
      return curvilinear_step<Hlle>(tile, dt, options);
    case RiemannSolver::hllc:
      break;
  }
  return curvilinear_step<Hllc>(tile, dt, options);
}

}  // namespace mortise
