// Nodes of the body grids: fixed in the body's frame, placed in space for each step.
#include <cmath>

#include "mortise/fluid/euler_solver.hpp"

namespace mortise {
namespace {

/// Node (i, j) of a grid fitted to a body, extended smoothly beyond its first and last layer for ghost cells.
Point<2> extended_node(const BodyAtlas& atlas, int, int i, int j) {
  const GrownGrid& grid = atlas.grid();
  if (j < 0) return grid.node(i, 0) + static_cast<double>(j) * (grid.node(i, 1) - grid.node(i, 0));
  if (j > grid.layers)
    return grid.node(i, grid.layers) + static_cast<double>(j - grid.layers) * (grid.node(i, grid.layers) - grid.node(i, grid.layers - 1));
  return grid.node(i, j);
}

Point<1> extended_node(const LineAtlas& atlas, int side, int i, int) { return Point<1>(atlas.node(side, i)); }

}  // namespace

template <int Dim>
void EulerSolver<Dim>::build_reference_nodes() {
  reference_.resize(grids_.size());
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    Index<Dim> nodes = grid.shape.cells;
    for (int& n : nodes) ++n;
    node_shapes_.emplace_back(nodes);
    if (grid.background()) continue;
    const Atlas<Dim>& atlas = *setup_.bodies[static_cast<std::size_t>(grid.body)].shape.atlas;
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      std::array<std::vector<double>, Dim> planes;
      for (auto& plane : planes) plane.assign(node_shapes_[g].plane, 0.0);
      const Index<Dim> first = grid.first_cell(t);
      for_each_cell<Dim>(node_shapes_[g], TileShape<Dim>::ghosts, [&](const Index<Dim>& c) {
        int j = 0;
        if constexpr (Dim == 2) j = first[1] + c[1];
        const Point<Dim> X = extended_node(atlas, grid.side, first[0] + c[0], j);
        for (int d = 0; d < Dim; ++d) planes[static_cast<std::size_t>(d)][node_shapes_[g].at(c)] = X[d];
      });
      reference_[g].push_back(std::move(planes));
    }
  }
}

template <int Dim>
void EulerSolver<Dim>::place_nodes(int grid, int tile, const Pose<Dim>& pose, std::array<std::vector<double>, Dim>& nodes) const {
  const auto& reference = reference_[static_cast<std::size_t>(grid)][static_cast<std::size_t>(tile)];
  const std::size_t n = reference[0].size();
  for (auto& plane : nodes) plane.resize(n);
  if constexpr (Dim == 2) {
    const double cosine = std::cos(pose.angle), sine = std::sin(pose.angle);
    const double x0 = pose.position[0], y0 = pose.position[1];
    const double *X = reference[0].data(), *Y = reference[1].data();
    double *x = nodes[0].data(), *y = nodes[1].data();
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = x0 + (cosine * X[k] - sine * Y[k]);
      y[k] = y0 + (sine * X[k] + cosine * Y[k]);
    }
  } else {
    for (std::size_t k = 0; k < n; ++k) nodes[0][k] = pose.position[0] + reference[0][k];
  }
}

/// Node positions at start + theta (end − start) and their velocities, in positions_ and velocities_.
template <int Dim>
void EulerSolver<Dim>::place(int grid, int tile, const BodyPath<Dim>& path, double dt, double theta) {
  place_nodes(grid, tile, path.start, positions_);
  place_nodes(grid, tile, path.end, velocities_);
  const double inverse = dt > 0 ? 1 / dt : 0.0;
  for (std::size_t d = 0; d < Dim; ++d) {
    double *x = positions_[d].data(), *w = velocities_[d].data();
    for (std::size_t k = 0; k < positions_[d].size(); ++k) {
      const double moved = w[k] - x[k];
      x[k] += theta * moved;
      w[k] = moved * inverse;
    }
  }
  if constexpr (Dim == 1) velocities_[0][0] = (path.end.position[0] - path.start.position[0]) * inverse;
}

template <int Dim>
Point<Dim> EulerSolver<Dim>::cell_center(int grid, int tile, const Index<Dim>& cell, const Pose<Dim>& pose) const {
  const auto g = static_cast<std::size_t>(grid);
  if (grids_[g].background()) {
    Index<Dim> global = grids_[g].first_cell(tile);
    for (std::size_t d = 0; d < Dim; ++d) global[d] += cell[d];
    return grids_[g].center(global);
  }
  const auto& nodes = reference_[g][static_cast<std::size_t>(tile)];
  const TileShape<Dim>& shape = node_shapes_[g];
  Point<Dim> X;
  for (std::size_t d = 0; d < Dim; ++d) {
    if constexpr (Dim == 2)
      X[static_cast<int>(d)] = 0.25 * (nodes[d][shape.at(cell[0], cell[1])] + nodes[d][shape.at(cell[0] + 1, cell[1])] +
                                       nodes[d][shape.at(cell[0], cell[1] + 1)] + nodes[d][shape.at(cell[0] + 1, cell[1] + 1)]);
    else
      X[0] = 0.5 * (nodes[0][shape.at(cell[0])] + nodes[0][shape.at(cell[0] + 1)]);
  }
  return Frame<Dim>(pose).to_space(X);
}

template <int Dim>
double EulerSolver<Dim>::cell_volume(int grid, int tile, const Index<Dim>& cell) const {
  const auto g = static_cast<std::size_t>(grid);
  if (grids_[g].background()) return grids_[g].spacing.prod();
  const auto& nodes = reference_[g][static_cast<std::size_t>(tile)];
  const TileShape<Dim>& shape = node_shapes_[g];
  if constexpr (Dim == 2) {
    const auto at = [&](int i, int j) { return Point<2>(nodes[0][shape.at(i, j)], nodes[1][shape.at(i, j)]); };
    const Point<2> a = at(cell[0] + 1, cell[1] + 1) - at(cell[0], cell[1]);
    const Point<2> b = at(cell[0], cell[1] + 1) - at(cell[0] + 1, cell[1]);
    return 0.5 * (a[0] * b[1] - a[1] * b[0]);
  } else {
    return nodes[0][shape.at(cell[0] + 1)] - nodes[0][shape.at(cell[0])];
  }
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
