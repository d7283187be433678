// From options known at run time to the types the kernels are templates over.
#pragma once

#include "mortise/grids/core/limiters.hpp"
#include "mortise/solid/systems.hpp"

namespace mortise::elastic {

/// Calls action.template operator()<limiter>().
template <class Action>
auto with_limiter(ElasticLimiter limiter, Action action) {
  switch (limiter) {
    case ElasticLimiter::minmod:
      return action.template operator()<Limiter::minmod>();
    case ElasticLimiter::mc:
      return action.template operator()<Limiter::mc>();
    case ElasticLimiter::none:
      break;
  }
  return action.template operator()<Limiter::none>();
}

/// Calls action.template operator()<System>().
template <class Action>
auto with_system(StressLaw law, Action action) {
  switch (law) {
    case StressLaw::saint_venant_kirchhoff:
      return action.template operator()<Hyperelastic<SaintVenantKirchhoff>>();
    case StressLaw::neo_hookean:
      return action.template operator()<Hyperelastic<NeoHookean>>();
    case StressLaw::linear:
      break;
  }
  return action.template operator()<Linear>();
}

/// The step of one system; each is compiled in a file of its own (step_*.cpp).
template <class System>
ElasticStepResult system_step(const ElasticTile& tile, double dt, const ElasticOptions& options);

}  // namespace mortise::elastic
