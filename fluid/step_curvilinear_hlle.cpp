// Steps on curvilinear tiles with the HLLE Riemann solver.
#include "mortise/fluid/curvilinear_kernel.hpp"
#include "mortise/fluid/hlle.hpp"
#include "mortise/fluid/step_kernels.hpp"

namespace mortise {

template <class Solver>
StepResult curvilinear_step(const CurvilinearTile& tile, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return CurvilinearKernel<Solver, limiter>(tile, dt, options).run(); });
}

template StepResult curvilinear_step<Hlle>(const CurvilinearTile&, double, const StepOptions&);

}  // namespace mortise
