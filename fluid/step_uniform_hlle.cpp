// Steps on lines and Cartesian tiles with the HLLE Riemann solver.
#include "mortise/fluid/cartesian_kernel.hpp"
#include "mortise/fluid/hlle.hpp"
#include "mortise/fluid/line_kernel.hpp"
#include "mortise/fluid/step_kernels.hpp"

namespace mortise {

template <class Solver>
StepResult line_step(const MovingLineTile& tile, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return LineKernel<Solver, limiter>(tile, dt, options).run(); });
}

template <class Solver>
StepResult cartesian_step(const CartesianTile<2>& tile, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return CartesianKernel<Solver, limiter>(tile, dt, options).run(); });
}

template StepResult line_step<Hlle>(const MovingLineTile&, double, const StepOptions&);
template StepResult cartesian_step<Hlle>(const CartesianTile<2>&, double, const StepOptions&);

}  // namespace mortise
