// Steps on curvilinear tiles with the exact Riemann solver.
#include "mortise/fluid/curvilinear_kernel.hpp"
#include "mortise/fluid/exact_flux.hpp"
#include "mortise/fluid/step_kernels.hpp"

namespace mortise {

template <class Solver>
StepResult curvilinear_step(const CurvilinearTile& tile, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return CurvilinearKernel<Solver, limiter>(tile, dt, options).run(); });
}

template StepResult curvilinear_step<ExactRiemann>(const CurvilinearTile&, double, const StepOptions&);

}  // namespace mortise
