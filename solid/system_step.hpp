// The step of one system for all geometries and limiters; to be included by one file for each system.
#pragma once

#include "mortise/solid/step_kernel.hpp"
#include "mortise/solid/with_options.hpp"

namespace mortise::elastic {

template <class System>
ElasticStepResult system_step(const ElasticTile& tile, double dt, const ElasticOptions& options) {
  return with_limiter(options.limiter, [&]<Limiter limiter>() {
    return tile.x ? StepKernel<System, CurvilinearGeometry, limiter>(tile, dt, options).run()
                  : StepKernel<System, CartesianGeometry, limiter>(tile, dt, options).run();
  });
}

}  // namespace mortise::elastic
