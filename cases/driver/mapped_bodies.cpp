#include "mortise/cases/driver/mapped_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/cases/driver/local_cells.hpp"
#include "mortise/cases/driver/map_contours.hpp"
#include "mortise/cases/driver/solid_snapshot.hpp"

namespace mortise {
namespace {

/// A cell that holds the map.
struct MappedCell {
  Point<2> xi, velocity;
  Gradient map_gradient;  // ∂ξ/∂x
  double phi, layer;
};

MappedCell cell_of(const MappedSolid& solid, int t, std::size_t k) {
  const TileBlock& map = solid.map->field().tile(t);
  const double *x = map.component(0) + k, *y = map.component(1) + k;
  const auto s = static_cast<std::ptrdiff_t>(solid.grid->shape.stride);
  const double h = 0.5 / solid.grid->spacing.x(), v = 0.5 / solid.grid->spacing.y();
  MappedCell cell;
  cell.xi = {*x, *y};
  cell.map_gradient << h * (x[1] - x[-1]), v * (x[s] - x[-s]), h * (y[1] - y[-1]), v * (y[s] - y[-s]);
  cell.velocity = solid.velocity(t, k);
  cell.phi = map.component(2)[k];
  cell.layer = map.component(3)[k];
  return cell;
}

ElasticState state_of(const MappedCell& cell, const Point<2>& x) {
  const Gradient F = cell.map_gradient.inverse();
  return {cell.velocity.x(),   cell.velocity.y(),  F(0, 0), F(0, 1), F(1, 0), F(1, 1),
          x.x() - cell.xi.x(), x.y() - cell.xi.y()};
}

Point<2> center_of(const MappedSolid& solid, int t, const Index<2>& c) {
  const Index<2> first = solid.grid->first_cell(t);
  return solid.grid->center({first[0] + c[0], first[1] + c[1]});
}

constexpr double everywhere = 1e20;  // less than φ of cells without a map

/// visit(local index, offset, cell) for the cells of a tile that hold the map and have φ below `level`, but those of
/// its outermost layer.
template <class Visit>
void for_each_mapped_cell_of(const MappedSolid& solid, int t, double level, Visit&& visit) {
  const TileShape<2>& shape = solid.grid->shape;
  const TileBlock& map = solid.map->field().tile(t);
  if (!map.allocated()) return;
  const TileWindow window = solid.map->window(t, false) & tile_cells(shape);
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; ++i) {
      const std::size_t k = shape.at(i, j);
      if (map.component(3)[k] < solid.map->layers() && map.component(2)[k] < level)
        visit(Index<2>{i, j}, k, cell_of(solid, t, k));
    }
}

/// visit(tile, local index, offset, cell), for all tiles on this rank.
template <class Visit>
void for_each_mapped_cell(const MappedSolid& solid, double level, Visit&& visit) {
  for (int t = 0; t < solid.grid->forest.local_count(); ++t)
    for_each_mapped_cell_of(solid, t, level,
                            [&](const Index<2>& c, std::size_t k, const MappedCell& cell) { visit(t, c, k, cell); });
}

constexpr double lines_across = 8;    // of the contours, over the mean width of a body
constexpr double least_distance = 4;  // of them, in cells

/// Lines of the reference map about the middle of the undeformed body.
void add_contours(const MappedSolid& solid, const MapSamples& samples, Snapshot& snapshot) {
  const double h = solid.grid->spacing.minCoeff();
  const Box<2> box = reference_box(solid.map->level_set(), 0.5 * h);
  const Point<2> size = box.high - box.low;
  const double spacing = std::max(std::sqrt(size.prod()) / lines_across, least_distance * h);
  for (auto& line : lines_of(samples, *solid.grid, 0.5 * (box.low + box.high), spacing))
    snapshot.contours.push_back(std::move(line));
}

}  // namespace

std::vector<MappedSolid> mapped_solids(const Simulation<2>& simulation) {
  std::vector<MappedSolid> all;
  const ReferenceMapScene* scene = simulation.reference_map();
  if (!scene) return all;
  for (std::size_t b = 0; b < scene->maps().size(); ++b)
    all.push_back({scene->setup().bodies[b].name, &simulation.fluid().grids().front(), scene->maps()[b].get(),
                   scene->setup().bodies[b].material, scene->setup().blur,
                   [&simulation](int t, std::size_t k) -> CellVelocities {
                     const TileBlock& U = simulation.fluid().fields().front().tile(t);
                     const Pack density = load(U.component(0) + k);
                     return {load(U.component(1) + k) / density, load(U.component(2) + k) / density};
                   }});
  return all;
}

std::vector<MappedSolid> mapped_solids(const FlowSolids& solids, const IncompressibleSolver& flow) {
  std::vector<MappedSolid> all;
  for (std::size_t b = 0; b < solids.maps().size(); ++b) {
    const FlowBody& body = solids.setup().bodies[b];
    all.push_back({body.name, &flow.grid(), solids.maps()[b].get(),
                   Material{StressLaw::neo_hookean, body.density, 0, body.shear_modulus},
                   solids.setup().blur * flow.grid().spacing.minCoeff(),
                   [&flow](int t, std::size_t k) -> CellVelocities {
                     const TileBlock& v = flow.velocity().tile(t);
                     return {load(v.component(0) + k), load(v.component(1) + k)};
                   }});
  }
  return all;
}

void add_mapped_solid(const MappedSolid& solid, bool contours, Snapshot& snapshot) {
  struct Record {
    Index<2> cell;
    double phi;
    std::array<double, 2> xi;
    std::array<double, solid_field_names.size()> values;
  };
  const ComponentGrid<2>& grid = *solid.grid;
  std::vector<Record> mine;
  for_each_mapped_cell(solid, everywhere, [&](int t, const Index<2>& c, std::size_t, const MappedCell& cell) {
    const Index<2> first = grid.first_cell(t), index = {first[0] + c[0], first[1] + c[1]};
    mine.push_back({index, cell.phi, {cell.xi.x(), cell.xi.y()}, {}});
    if (cell.phi < 0)
      mine.back().values = solid_field_values(solid.material, cell.xi, state_of(cell, grid.center(index)));
  });
  const std::vector<Record> all = grid.forest.communicator().gather_all(mine);
  if (all.empty()) return;
  Index<2> low = all.front().cell, high = low;
  for (const Record& record : all)
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], record.cell[d]);
      high[d] = std::max(high[d], record.cell[d]);
    }
  GridSnapshot out;
  out.name = solid.name;
  out.solid = true;
  out.cells = {high[0] - low[0] + 1, high[1] - low[1] + 1};
  for (int j = 0; j <= out.cells[1]; ++j)
    for (int i = 0; i <= out.cells[0]; ++i) {
      out.x.push_back(grid.origin.x() + (low[0] + i) * grid.spacing.x());
      out.y.push_back(grid.origin.y() + (low[1] + j) * grid.spacing.y());
    }
  out.mask.assign(out.cell_count(), mask_hole);
  for (const char* name : solid_field_names) out.fields.emplace_back(name, std::vector<double>(out.cell_count(), 0.0));
  MapSamples samples{low, out.cells, std::vector<double>(out.cell_count(), unknown_phi),
                     std::vector<Point<2>>(out.cell_count(), Point<2>::Zero())};
  for (const Record& record : all) {
    const std::size_t k = out.cell(record.cell[0] - low[0], record.cell[1] - low[1]);
    samples.phi[k] = record.phi;
    samples.xi[k] = {record.xi[0], record.xi[1]};
    if (!(record.phi < 0)) continue;
    out.mask[k] = mask_active;
    for (std::size_t f = 0; f < record.values.size(); ++f) out.fields[f].second[k] = record.values[f];
  }
  snapshot.grids.push_back(std::move(out));
  for (auto& polygon : surfaces_of(samples, grid)) snapshot.surfaces.push_back(std::move(polygon));
  if (contours) add_contours(solid, samples, snapshot);
}

namespace {

/// m, m x, m v, m x × v and kinetic energy of the cells of a tile.
std::array<double, 7> moments(const MappedSolid& solid, int t) {
  const ComponentGrid<2>& grid = *solid.grid;
  const TileBlock& map = solid.map->field().tile(t);
  const TileWindow window = solid.map->window(t, false) & tile_cells(grid.shape);
  const double density = solid.material.density * grid.spacing.prod();
  Pack step{};
  for (int l = 0; l < simd_width; ++l) step[l] = l * grid.spacing.x();
  std::array<Pack, 7> sums{};
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const std::size_t k = grid.shape.at(i, j);
      const Pack phi = load(map.component(2) + k), det = solid.map->determinant(map, k);
      const PackMask own = (load(map.component(3) + k) < solid.map->layers()) & (phi < solid.blur) & (det > 0) &
                           lanes_below(window.high[0] - i);
      if (!any(own)) continue;
      const Pack m = select(own, Pack(density * (solid_share(phi, 1 / solid.blur) * det)), Pack{});
      const Point<2> corner = center_of(solid, t, {i, j});
      const Pack x = corner.x() + step, y = broadcast(corner.y());
      const auto [u, v] = solid.velocities(t, k);
      const std::array<Pack, 7> values{Pack{} + 1.0, x, y, u, v, x * v - y * u, 0.5 * (u * u + v * v)};
      for (std::size_t n = 0; n < values.size(); ++n) sums[n] += select(own, Pack(m * values[n]), Pack{});
    }
  std::array<double, 7> sum{};
  for (std::size_t n = 0; n < sum.size(); ++n)
    for (int l = 0; l < simd_width; ++l) sum[n] += sums[n][l];
  return sum;
}

}  // namespace

SolidTotals totals(const MappedSolid& solid, bool with_stress) {
  const double volume = solid.grid->spacing.prod();
  double von_mises = 0;
  TileSums<8> sums;  // moments(), strain energy
  for (int t = 0; t < solid.grid->forest.local_count(); ++t) {
    if (!solid.map->field().tile(t).allocated()) continue;
    std::array<double, 8>& sum = sums.add_tile(0, solid.grid->forest.first_global() + t);
    std::ranges::copy(moments(solid, t), sum.begin());
    if (!with_stress) continue;
    for_each_mapped_cell_of(solid, t, solid.blur, [&](const Index<2>& c, std::size_t, const MappedCell& cell) {
      const double det = cell.map_gradient.determinant();
      if (!(det > 0)) return;
      const ElasticState state = state_of(cell, center_of(solid, t, c));
      if (cell.phi < 0) von_mises = std::max(von_mises, cauchy_stress_of(solid.material, state).von_mises());
      sum[7] += solid_share(cell.phi, 1 / solid.blur) * det * volume * strain_energy_of(solid.material, state);
    });
  }
  const Communicator& comm = solid.grid->forest.communicator();
  return totals_of(sums.total(comm), comm.max(von_mises));
}

double least_j(const MappedSolid& solid) {
  double largest = 0;  // of 1/J
  for_each_mapped_cell(solid, everywhere, [&](int, const Index<2>&, std::size_t, const MappedCell& cell) {
    if (cell.phi < 0) largest = std::max(largest, cell.map_gradient.determinant());
  });
  return 1 / solid.grid->forest.communicator().max(largest);
}

std::optional<MappedPoint> material_point(const MappedSolid& solid, const Point<2>& X) {
  struct Nearest {
    double distance;
    std::int64_t tile;
    std::array<double, 2> x;
    ElasticState state;
  };
  if (solid.map->level_set()(X.x(), X.y()) >= 0) return std::nullopt;
  const ComponentGrid<2>& grid = *solid.grid;
  std::vector<Nearest> mine;
  for_each_mapped_cell(solid, everywhere, [&](int t, const Index<2>& c, std::size_t k, const MappedCell& cell) {
    const double distance = (cell.xi - X).norm();
    if (cell.layer > 1 || (!mine.empty() && !(distance < mine.back().distance))) return;
    const Point<2> center = center_of(solid, t, c), x = center + cell.map_gradient.inverse() * (X - cell.xi);
    ElasticState state = state_of(cell, center);
    const Point<2> d = (x - center).cwiseQuotient(grid.spacing);
    const auto s = static_cast<std::size_t>(grid.shape.stride);
    const Point<2> slope = 0.5 * (d.x() * (solid.velocity(t, k + 1) - solid.velocity(t, k - 1)) +
                                  d.y() * (solid.velocity(t, k + s) - solid.velocity(t, k - s)));
    state[0] += slope.x();
    state[1] += slope.y();
    state[6] = x.x() - X.x();
    state[7] = x.y() - X.y();
    mine.assign(1, {distance, grid.forest.first_global() + t, {x.x(), x.y()}, state});
  });
  const std::vector<Nearest> all = grid.forest.communicator().gather_all(mine);
  if (all.empty()) return std::nullopt;
  const Nearest& nearest = *std::min_element(all.begin(), all.end(), [](const Nearest& a, const Nearest& b) {
    return std::pair(a.distance, a.tile) < std::pair(b.distance, b.tile);
  });
  return MappedPoint{{nearest.x[0], nearest.x[1]}, nearest.state};
}

}  // namespace mortise
