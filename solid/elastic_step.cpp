// Choice of the kernel by stress law; the rate of a state.
#include "mortise/solid/elastic_step.hpp"

#include "mortise/grids/core/error.hpp"
#include "mortise/solid/geometry.hpp"
#include "mortise/solid/state_rows.hpp"
#include "mortise/solid/step_result.hpp"
#include "mortise/solid/with_options.hpp"

namespace mortise {
namespace elastic {
namespace {

template <class System, class Geometry>
ElasticStepResult rate_of(const ElasticTile& tile, const ElasticOptions& options) {
  const int nx = tile.shape->cells[0];
  const std::size_t plane = tile.shape->plane;
  const RowWorkspace work(nx, 1 + Geometry::rows);
  double* const weights = work.row(0);
  const Geometry geometry(tile, 0, work, 1);
  const System system(options);
  const auto make_metrics = [&](int r) {
    for (int i = row_start; i < nx + 2; i += simd_width) geometry.half_step_metrics(i, r, lanes_below(nx + 1 - i));
  };
  Findings<System> findings;
  make_metrics(0);
  for (int r = 0; r < tile.shape->cells[1]; ++r) {
    make_metrics(r + 1);
    fill_weights(weights, nx, tile.active ? tile.active + tile.shape->at(0, r) : nullptr);
    const double* const now = tile.now + tile.shape->at(0, r);
    for (int i = row_start; i < nx + 2; i += simd_width)
      findings.add(system, rows::read<typename System::template StateOf<Pack>>(now + i, plane),
                   rows::read<Vector<Pack>>(now + i + System::numbers * plane, plane), geometry.rate_metrics(i, r),
                   load(weights + i) > 0);
  }
  return findings.result();
}

}  // namespace
}  // namespace elastic

int elastic_components(StressLaw law) { return displacement_component(law) + 2; }
int displacement_component(StressLaw law) {
  return elastic::with_system(law, []<class System>() { return System::numbers; });
}

ElasticStepResult elastic_step(const ElasticTile& tile, double dt, const ElasticOptions& options) {
  MORTISE_ASSERT(tile.shape->cells[0] % 2 == 0, "tiles have an even number of cells");
  return elastic::with_system(options.material.law,
                              [&]<class System>() { return elastic::system_step<System>(tile, dt, options); });
}

ElasticStepResult elastic_rate(const ElasticTile& tile, const ElasticOptions& options) {
  return elastic::with_system(options.material.law, [&]<class System>() {
    return tile.x ? elastic::rate_of<System, elastic::CurvilinearGeometry>(tile, options)
                  : elastic::rate_of<System, elastic::CartesianGeometry>(tile, options);
  });
}

}  // namespace mortise
