#include "mortise/cases/driver/mapped_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mortise/cases/driver/local_cells.hpp"
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

/// visit(tile, local index, offset, cell) for the cells on this rank that hold the map and have φ below `level`, but
/// those of its outermost layer.
template <class Visit>
void for_each_mapped_cell(const MappedSolid& solid, double level, Visit&& visit) {
  const TileShape<2>& shape = solid.grid->shape;
  for (int t = 0; t < solid.grid->forest.local_count(); ++t) {
    const TileBlock& map = solid.map->field().tile(t);
    if (!map.allocated()) continue;
    const TileWindow window = solid.map->window(t, false) & tile_cells(shape);
    for (int j = window.low[1]; j < window.high[1]; ++j)
      for (int i = window.low[0]; i < window.high[0]; ++i) {
        const std::size_t k = shape.at(i, j);
        if (map.component(3)[k] < solid.map->layers() && map.component(2)[k] < level) visit(t, Index<2>{i, j}, k, cell_of(solid, t, k));
      }
  }
}

/// Lines φ = 0 between cell centres, as closed polygons: marching squares, saddles joined through their middle value.
class Contours {
 public:
  Contours(Index<2> low, Index<2> size, std::vector<double> phi) : low_(low), size_(size), phi_(std::move(phi)) {}

  std::vector<std::vector<Point<2>>> polygons(const ComponentGrid<2>& grid) {
    for (int j = 0; j + 1 < size_[1]; ++j)
      for (int i = 0; i + 1 < size_[0]; ++i) square(i, j);
    std::vector<std::vector<Point<2>>> all;
    while (!links_.empty()) {
      std::vector<Point<2>> polygon;
      for (int edge = links_.begin()->first; links_.contains(edge);) {
        polygon.push_back(crossing(edge, grid));
        const int next = links_[edge];
        links_.erase(edge);
        edge = next;
      }
      if (polygon.size() > 2) all.push_back(std::move(polygon));
    }
    return all;
  }

 private:
  double phi(int i, int j) const { return phi_[static_cast<std::size_t>(j * size_[0] + i)]; }
  // Edges: 2 n leads from point n in direction 0, 2 n + 1 in direction 1.
  int edge(int i, int j, int direction) const { return 2 * (j * size_[0] + i) + direction; }

  Point<2> crossing(int edge, const ComponentGrid<2>& grid) const {
    const int n = edge / 2, i = n % size_[0], j = n / size_[0], di = 1 - edge % 2, dj = edge % 2;
    const double a = phi(i, j), b = phi(i + di, j + dj), s = a / (a - b);
    const Point<2> from = grid.center({low_[0] + i, low_[1] + j});
    return from + s * Point<2>(di * grid.spacing.x(), dj * grid.spacing.y());
  }

  /// Links of the edges of one square; the inside is on the left of every link.
  void square(int i, int j) {
    const bool corner[] = {phi(i, j) < 0, phi(i + 1, j) < 0, phi(i + 1, j + 1) < 0, phi(i, j + 1) < 0};
    const int edges[] = {edge(i, j, 0), edge(i + 1, j, 1), edge(i, j + 1, 0), edge(i, j, 1)};
    std::vector<int> entries, exits;  // going round counter-clockwise: into the inside, out of it
    for (int k = 0; k < 4; ++k) {
      const bool here = corner[k], next = corner[(k + 1) % 4];
      if (!here && next) entries.push_back(k);
      if (here && !next) exits.push_back(k);
    }
    const bool middle = phi(i, j) + phi(i + 1, j) + phi(i + 1, j + 1) + phi(i, j + 1) < 0;
    for (std::size_t k = 0; k < entries.size(); ++k) {
      // Where the inside is joined through the middle an exit belongs to the entry behind it, else to that before it.
      int best = exits[0];
      for (const int exit : exits) {
        const auto turn = [&](int e) { return (e - entries[k] + 4) % 4; };
        if (middle ? turn(exit) > turn(best) : turn(exit) < turn(best)) best = exit;
      }
      links_[edges[best]] = edges[entries[k]];
    }
  }

  Index<2> low_, size_;
  std::vector<double> phi_;
  std::map<int, int> links_;
};

}  // namespace

std::vector<MappedSolid> mapped_solids(const Simulation<2>& simulation) {
  std::vector<MappedSolid> all;
  const ReferenceMapScene* scene = simulation.reference_map();
  if (!scene) return all;
  for (std::size_t b = 0; b < scene->maps().size(); ++b)
    all.push_back({scene->setup().bodies[b].name, &simulation.fluid().grids().front(), scene->maps()[b].get(),
                   scene->setup().bodies[b].material, scene->setup().blur,
                   [&simulation](int t, std::size_t k) -> Point<2> {
                     const TileBlock& U = simulation.fluid().fields().front().tile(t);
                     return Point<2>(U.component(1)[k], U.component(2)[k]) / U.component(0)[k];
                   }});
  return all;
}

std::vector<MappedSolid> mapped_solids(const FlowSolids& solids, const IncompressibleSolver& flow) {
  std::vector<MappedSolid> all;
  for (std::size_t b = 0; b < solids.maps().size(); ++b) {
    const FlowBody& body = solids.setup().bodies[b];
    all.push_back({body.name, &flow.grid(), solids.maps()[b].get(),
                   Material{StressLaw::neo_hookean, body.density, 0, body.shear_modulus},
                   solids.setup().blur * flow.grid().spacing.minCoeff(), [&flow](int t, std::size_t k) -> Point<2> {
                     return {flow.velocity().tile(t).component(0)[k], flow.velocity().tile(t).component(1)[k]};
                   }});
  }
  return all;
}

void add_mapped_solid(const MappedSolid& solid, Snapshot& snapshot) {
  struct Record {
    Index<2> cell;
    double phi;
    std::array<double, solid_field_names.size()> values;
  };
  const ComponentGrid<2>& grid = *solid.grid;
  std::vector<Record> mine;
  for_each_mapped_cell(solid, everywhere, [&](int t, const Index<2>& c, std::size_t, const MappedCell& cell) {
    const Index<2> first = grid.first_cell(t), index = {first[0] + c[0], first[1] + c[1]};
    mine.push_back({index, cell.phi, {}});
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
  std::vector<double> phi(out.cell_count(), 1e30);
  for (const Record& record : all) {
    const std::size_t k = out.cell(record.cell[0] - low[0], record.cell[1] - low[1]);
    phi[k] = record.phi;
    if (!(record.phi < 0)) continue;
    out.mask[k] = mask_active;
    for (std::size_t f = 0; f < record.values.size(); ++f) out.fields[f].second[k] = record.values[f];
  }
  snapshot.grids.push_back(std::move(out));
  for (std::vector<Point<2>>& polygon :
       Contours(low, {high[0] - low[0] + 1, high[1] - low[1] + 1}, std::move(phi)).polygons(grid))
    snapshot.surfaces.push_back(std::move(polygon));
}

SolidTotals totals(const MappedSolid& solid, bool with_stress) {
  const double volume = solid.grid->spacing.prod();
  double von_mises = 0;
  TileSums<8> sums;  // m, m x, m v, m x × v, kinetic and strain energy
  std::array<double, 8>* sum = nullptr;
  int tile = -1;
  for_each_mapped_cell(solid, solid.blur, [&](int t, const Index<2>& c, std::size_t, const MappedCell& cell) {
    if (t != tile) sum = &sums.add_tile(0, solid.grid->forest.first_global() + t);
    tile = t;
    const double share = solid_share(cell.phi, 1 / solid.blur), det = cell.map_gradient.determinant();
    if (share == 0 || !(det > 0)) return;
    const Point<2> x = center_of(solid, t, c), v = cell.velocity;
    const double reference = share * det * volume, m = solid.material.density * reference;
    const std::array<double, 7> moments{
        m, m * x.x(), m * x.y(), m * v.x(), m * v.y(), m * (x.x() * v.y() - x.y() * v.x()), 0.5 * m * v.squaredNorm()};
    for (std::size_t k = 0; k < moments.size(); ++k) (*sum)[k] += moments[k];
    if (!with_stress) return;
    const ElasticState state = state_of(cell, x);
    if (cell.phi < 0) von_mises = std::max(von_mises, cauchy_stress_of(solid.material, state).von_mises());
    (*sum)[7] += reference * strain_energy_of(solid.material, state);
  });
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
