// Where the cells of an elastic solid are in the reference frame, and values between them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/solid/elastic_solver.hpp"

namespace mortise {

void ElasticSolver::build_nodes() {
  nodes_.resize(grids_.size());
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<2>& grid = grids_[g];
    node_shapes_.emplace_back(Index<2>{grid.shape.cells[0] + 1, grid.shape.cells[1] + 1});
    if (grid.background()) continue;
    const TileShape<2>& shape = node_shapes_[g];
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      std::array<std::vector<double>, 2> planes;
      for (auto& plane : planes) plane.assign(shape.plane, 0.0);
      for_each_cell<2>(shape, TileShape<2>::ghosts, [&](const Index<2>& c) {
        const Point<2> X = tile_node(static_cast<int>(g), t, c[0], c[1]);
        planes[0][shape.at(c)] = X.x();
        planes[1][shape.at(c)] = X.y();
      });
      nodes_[g].push_back(std::move(planes));
    }
  }
}

Point<2> ElasticSolver::node(int g, int i, int j) const {
  const ComponentGrid<2>& grid = grid_of(g);
  if (!grid.background()) return setup_.fitted->node(i, j);
  return grid.origin + Point<2>(i * grid.spacing.x(), j * grid.spacing.y());
}

Point<2> ElasticSolver::tile_node(int g, int t, int i, int j) const {
  const Index<2> first = grid_of(g).first_cell(t);
  return node(g, first[0] + i, first[1] + j);
}

Point<2> ElasticSolver::cell_center(int g, int t, const Index<2>& cell) const {
  const Index<2> first = grid_of(g).first_cell(t);
  if (grid_of(g).background()) return grid_of(g).center({first[0] + cell[0], first[1] + cell[1]});
  const auto at = [&](int i, int j) { return tile_node(g, t, cell[0] + i, cell[1] + j); };
  return 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1));
}

ElasticState ElasticSolver::state_of_cell(const ElasticFunction& of, int g, int t, const Index<2>& cell,
                                          double time) const {
  if (!setup_.smooth) return of(cell_center(g, t, cell), time);
  return cell_mean<2>(cell_corners(g, t, cell), [&](const Point<2>& X) { return of(X, time); });
}

Corners<2> ElasticSolver::cell_corners(int g, int t, const Index<2>& cell) const {
  const auto at = [&](int i, int j) { return tile_node(g, t, cell[0] + i, cell[1] + j); };
  return {at(0, 0), at(1, 0), at(0, 1), at(1, 1)};
}

double ElasticSolver::cell_volume(int g, int t, const Index<2>& cell) const {
  if (grid_of(g).background()) return grid_of(g).spacing.prod();
  const auto at = [&](int i, int j) { return tile_node(g, t, cell[0] + i, cell[1] + j); };
  return 0.5 * cross(at(1, 1) - at(0, 0), at(0, 1) - at(1, 0));
}

double ElasticSolver::share(int g, const Point<2>& X) const { return overlap_ ? overlap_->share(g, X) : 1; }

/// One grid only: the middle of the 3 × 3 cells around X, which stay on the grid, and X's offset from it in cells.
bool ElasticSolver::find_stencil(const Point<2>& X, Index<2>& center, std::array<double, 2>& offset) const {
  if (finder_) return finder_->find(X, center, offset);
  if (!setup_.domain.contains(X)) return false;
  const ComponentGrid<2>& grid = grids_.front();
  for (std::size_t d = 0; d < 2; ++d) {
    const int k = static_cast<int>(d), n = grid.cells[d], rim = grid.periodic[d] ? 0 : 1;
    const double cell = (X[k] - grid.origin[k]) / grid.spacing[k] - 0.5;
    center[d] = std::clamp(static_cast<int>(std::lround(cell)), rim, n - 1 - rim);
    offset[d] = cell - center[d];
  }
  return true;
}

std::vector<ElasticState> ElasticSolver::sample(std::span<const Point<2>> points) const {
  ElasticState nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<ElasticState> values(points.size(), nothing);
  if (overlap_) {
    const auto sampled = [&]<int Components>() {
      const auto found =
          overlap_->sample<Components>(now_, points, [](const double* U, double* W) { std::copy_n(U, Components, W); });
      for (std::size_t p = 0; p < points.size(); ++p) std::copy_n(found[p].begin(), Components, values[p].begin());
    };
    if (components() == 7)
      sampled.template operator()<7>();
    else
      sampled.template operator()<8>();
    return values;
  }
  struct Found {
    std::size_t point;
    ElasticState state;
  };
  std::vector<Found> mine;
  const ComponentGrid<2>& grid = grids_.front();
  for (std::size_t p = 0; p < points.size(); ++p) {
    Index<2> center;
    std::array<double, 2> offset;
    if (!find_stencil(points[p], center, offset)) continue;
    const Neighbor owner = grid.forest.find({center[0] / grid.shape.cells[0], center[1] / grid.shape.cells[1]});
    if (owner.rank != comm_.rank()) continue;
    const Index<2> local = {center[0] % grid.shape.cells[0], center[1] % grid.shape.cells[1]};
    mine.push_back({p, interpolated(now_.front().tile(owner.local), grid.shape, local, offset)});
  }
  for (const Found& found : comm_.gather_all(mine)) values[found.point] = found.state;
  return values;
}

/// Biquadratic, not clipped.
ElasticState ElasticSolver::interpolated(const TileBlock& block, const TileShape<2>& shape, const Index<2>& center,
                                         const std::array<double, 2>& offset) const {
  const std::array<double, 3> along = quadratic_weights(offset[0]), across = quadratic_weights(offset[1]);
  ElasticState sum{};
  for (int c = 0; c < components(); ++c)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        sum[static_cast<std::size_t>(c)] += along[static_cast<std::size_t>(i)] * across[static_cast<std::size_t>(j)] *
                                            block.component(c)[shape.at(center[0] + i - 1, center[1] + j - 1)];
  return sum;
}

}  // namespace mortise
