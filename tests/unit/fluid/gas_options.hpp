// The gas of most tests, and the options of the step that they go through.
#pragma once

#include <array>

#include "mortise/fluid/godunov_step.hpp"

namespace mortise::testing {

inline constexpr double gamma_air = 1.4;

inline constexpr std::array<Limiter, 4> gas_limiters = {Limiter::none, Limiter::minmod, Limiter::mc,
                                                        Limiter::van_albada};
inline constexpr std::array<RiemannSolver, 3> gas_solvers = {RiemannSolver::hllc, RiemannSolver::hlle,
                                                             RiemannSolver::exact};

inline StepOptions gas_options(Limiter limiter = Limiter::mc, RiemannSolver solver = RiemannSolver::hllc) {
  StepOptions o;
  o.limiter = limiter;
  o.riemann = solver;
  if (limiter == Limiter::van_albada) o.van_albada_floor.fill(1e-3);
  return o;
}

}  // namespace mortise::testing
