// The fused kernels by Riemann solver; each is compiled in a file of its own (step_*.cpp) for all limiters.
#pragma once

#include "mortise/fluid/godunov_step.hpp"

namespace mortise {

struct Hllc;
struct Hlle;
struct ExactRiemann;

/// Instantiated for Hllc, Hlle and ExactRiemann.
template <class Solver>
StepResult line_step(const MovingLineTile& tile, double dt, const StepOptions& options);
template <class Solver>
StepResult cartesian_step(const CartesianTile<2>& tile, double dt, const StepOptions& options);
template <class Solver>
StepResult curvilinear_step(const CurvilinearTile& tile, double dt, const StepOptions& options);

/// Calls action.template operator()<limiter>() for a limiter known at run time.
template <class Action>
auto with_limiter(Limiter limiter, Action action) {
  switch (limiter) {
    case Limiter::none:
      return action.template operator()<Limiter::none>();
    case Limiter::minmod:
      return action.template operator()<Limiter::minmod>();
    case Limiter::mc:
      return action.template operator()<Limiter::mc>();
    case Limiter::flat:
      return action.template operator()<Limiter::flat>();
    case Limiter::van_albada:
      break;
  }
  return action.template operator()<Limiter::van_albada>();
}

}  // namespace mortise
