#include "mortise/cases/driver/flow_snapshot.hpp"

#include "mortise/cases/driver/local_cells.hpp"

namespace mortise {
namespace {

constexpr double drawn_as_solid = 0.5;  // cells with a larger share of solid
constexpr std::array<const char*, 4> field_names = {"velocity_x", "velocity_y", "vorticity", "pressure"};

struct Record {
  std::int64_t index;
  std::array<double, field_names.size()> values;
  bool hole;
};

/// Of the cells on this rank.
std::vector<Record> records_of(const IncompressibleSolver& flow, const std::vector<MappedSolid>& solids) {
  const ComponentGrid<2>& grid = flow.grid();
  const auto s = static_cast<std::size_t>(grid.shape.stride);
  std::vector<Record> mine;
  for_each_local_cell<2>(grid, [&](int t, const Index<2>&, std::size_t index, std::size_t k) {
    const double *u = flow.velocity().tile(t).component(0) + k, *v = flow.velocity().tile(t).component(1) + k,
                 *p = flow.pressure().tile(t).component(0) + k;
    const double curl = 0.5 * ((v[1] - *(v - 1)) / grid.spacing.x() - (u[s] - *(u - s)) / grid.spacing.y());
    double share = 0;
    for (const MappedSolid& solid : solids)
      if (solid.map->field().tile(t).allocated())
        share += solid_share(solid.map->field().tile(t).component(2)[k], 1 / solid.blur);
    mine.push_back({static_cast<std::int64_t>(index),
                    {*u, *v, curl, 0.25 * (p[0] + p[1] + p[s] + p[s + 1])},
                    share > drawn_as_solid});
  });
  return mine;
}

}  // namespace

Snapshot gather_flow_snapshot(const IncompressibleSolver& flow, const std::vector<MappedSolid>& solids, bool contours,
                              std::int64_t step) {
  const ComponentGrid<2>& grid = flow.grid();
  GridSnapshot out;
  out.name = grid.name;
  out.cells = grid.cells;
  for (int j = 0; j <= out.cells[1]; ++j)
    for (int i = 0; i <= out.cells[0]; ++i) {
      out.x.push_back(grid.origin.x() + i * grid.spacing.x());
      out.y.push_back(grid.origin.y() + j * grid.spacing.y());
    }
  out.mask.assign(out.cell_count(), mask_active);
  for (const char* name : field_names) out.fields.emplace_back(name, std::vector<double>(out.cell_count(), 0.0));
  for (const Record& record : grid.forest.communicator().gather_all(records_of(flow, solids))) {
    const auto k = static_cast<std::size_t>(record.index);
    if (record.hole) out.mask[k] = mask_hole;
    for (std::size_t f = 0; f < record.values.size(); ++f) out.fields[f].second[k] = record.values[f];
  }
  Snapshot snapshot;
  snapshot.time = flow.time();
  snapshot.step = static_cast<int>(step);
  snapshot.grids.push_back(std::move(out));
  for (const MappedSolid& solid : solids) add_mapped_solid(solid, contours, snapshot);
  return snapshot;
}

}  // namespace mortise
