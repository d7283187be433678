// Nodes of the body grids: known in the body's frame, where only deforming grids change them, and placed in space for
// each step.
#include <algorithm>
#include <cmath>

#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Nodes (i0 − 2 … i0 + count + 1, j) of a grid, the first to x[−2] and y[−2].
void read_row(const GrownGrid& mesh, int i0, int j, int count, double* x, double* y) {
  constexpr int ghosts = TileShape<2>::ghosts;
  const auto put = [x, y](int i, const Point<2>& X) { x[i] = X[0], y[i] = X[1]; };
  const bool stored = j >= 0 && j <= mesh.layers;
  const int begin = stored ? std::max(-ghosts, -i0) : count + ghosts, end = std::min(count + ghosts, mesh.row() - i0);
  for (int i = -ghosts; i < begin; ++i) put(i, mesh.node(i0 + i, j));
  for (int i = begin; i < end; ++i) put(i, mesh.nodes[static_cast<std::size_t>(j * mesh.row() + i0 + i)]);
  for (int i = std::max(begin, end); i < count + ghosts; ++i) put(i, mesh.node(i0 + i, j));
}

/// x = position + R(angle) X for a plane of nodes; x may be X.
void to_space(const Pose<2>& pose, const std::array<std::vector<double>, 2>& from, std::array<std::vector<double>, 2>& to) {
  const double cosine = std::cos(pose.angle), sine = std::sin(pose.angle);
  const double x0 = pose.position[0], y0 = pose.position[1];
  const double *X = from[0].data(), *Y = from[1].data();
  double *x = to[0].data(), *y = to[1].data();
  for (std::size_t k = 0; k < from[0].size(); ++k) {
    const double along = X[k], up = Y[k];
    x[k] = x0 + (cosine * along - sine * up);
    y[k] = y0 + (sine * along + cosine * up);
  }
}

void to_space(const Pose<1>& pose, const std::array<std::vector<double>, 1>& from, std::array<std::vector<double>, 1>& to) {
  for (std::size_t k = 0; k < from[0].size(); ++k) to[0][k] = pose.position[0] + from[0][k];
}

}  // namespace

template <int Dim>
void EulerSolver<Dim>::build_reference_nodes() {
  if constexpr (Dim == 2)
    for (const FittedBody<2>& body : setup_.bodies) {
      const auto& atlas = body.shape.atlas;
      meshes_.push_back(has_background() ? std::shared_ptr<const GrownGrid>(atlas, &atlas->grid()) : body.mesh);
    }
  reference_.resize(grids_.size());
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    Index<Dim> nodes = grid.shape.cells;
    for (int& n : nodes) ++n;
    node_shapes_.emplace_back(nodes);
    if (grid.background()) continue;
    reference_[g].resize(static_cast<std::size_t>(grid.forest.local_count()));
    for (int t = 0; t < grid.forest.local_count(); ++t) {
      std::array<std::vector<double>, Dim>& planes = reference_[g][static_cast<std::size_t>(t)];
      if constexpr (Dim == 2) {
        read_nodes(*meshes_[static_cast<std::size_t>(grid.body)], static_cast<int>(g), t, planes);
      } else {
        planes[0].assign(node_shapes_[g].plane, 0.0);
        for_each_cell<1>(node_shapes_[g], TileShape<1>::ghosts, [&](const Index<1>& c) {
          planes[0][node_shapes_[g].at(c)] = setup_.bodies[static_cast<std::size_t>(grid.body)].shape.atlas->node(grid.side, grid.first_cell(t)[0] + c[0]);
        });
      }
    }
  }
}

/// The nodes of a tile, ghosts included, from those of its grid.
template <int Dim>
void EulerSolver<Dim>::read_nodes(const GrownGrid& mesh, int g, int t, std::array<std::vector<double>, Dim>& nodes) const {
  if constexpr (Dim == 2) {
    const ComponentGrid<2>& grid = grids_[static_cast<std::size_t>(g)];
    const TileShape<2>& shape = node_shapes_[static_cast<std::size_t>(g)];
    const auto [i0, j0] = grid.first_cell(t);
    MORTISE_ASSERT(mesh.along == grid.cells[0] && mesh.layers >= grid.cells[1], "a grid of " + grid.name + " with other cells");
    for (std::vector<double>& plane : nodes) plane.resize(shape.plane);
    for (int j = -shape.ghosts; j < shape.cells[1] + shape.ghosts; ++j) {
      const std::size_t first = shape.at(0, j);
      read_row(mesh, i0, j0 + j, shape.cells[0], nodes[0].data() + first, nodes[1].data() + first);
    }
  }
}

template <int Dim>
void EulerSolver<Dim>::place_nodes(int grid, int tile, const Pose<Dim>& pose, std::array<std::vector<double>, Dim>& nodes) const {
  const auto& reference = reference_[static_cast<std::size_t>(grid)][static_cast<std::size_t>(tile)];
  if (pose == Pose<Dim>{}) {
    nodes = reference;
    return;
  }
  for (auto& plane : nodes) plane.resize(reference[0].size());
  to_space(pose, reference, nodes);
}

/// Node positions at start + theta (end − start) and their velocities, in positions_ and velocities_.
template <int Dim>
void EulerSolver<Dim>::place(int grid, int tile, const BodyPath<Dim>& path, double dt, double theta) {
  place_nodes(grid, tile, path.start, positions_);
  if (path.end_mesh) {
    read_nodes(*path.end_mesh, grid, tile, velocities_);
    if (!(path.end == Pose<Dim>{})) to_space(path.end, velocities_, velocities_);
  } else {
    place_nodes(grid, tile, path.end, velocities_);
  }
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
Pose<Dim> EulerSolver<Dim>::pose_of(int grid) const {
  const ComponentGrid<Dim>& of = grids_[static_cast<std::size_t>(grid)];
  return of.background() ? Pose<Dim>{} : poses_[static_cast<std::size_t>(of.body)];
}

template <int Dim>
Point<Dim> EulerSolver<Dim>::present_node(int g, const Index<Dim>& node) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  if (grid.background()) {
    Point<Dim> x;
    for (int d = 0; d < Dim; ++d) x[d] = grid.origin[d] + node[static_cast<std::size_t>(d)] * grid.spacing[d];
    return x;
  }
  const auto body = static_cast<std::size_t>(grid.body);
  if constexpr (Dim == 2)
    return Frame<2>(poses_[body]).to_space(meshes_[body]->node(node[0], node[1]));
  else
    return Point<1>(poses_[body].position[0] + setup_.bodies[body].shape.atlas->node(grid.side, node[0]));
}

template <int Dim>
Point<Dim> EulerSolver<Dim>::cell_center(int grid, int tile, const Index<Dim>& cell) const {
  return cell_center(grid, tile, cell, pose_of(grid));
}

/// Where the centre of a cell of a body grid is at the end of a path.
template <int Dim>
Point<Dim> EulerSolver<Dim>::end_center(int grid, int tile, const Index<Dim>& cell, const BodyPath<Dim>& path) const {
  if constexpr (Dim == 2)
    if (path.end_mesh) {
      const auto [i0, j0] = grids_[static_cast<std::size_t>(grid)].first_cell(tile);
      const int i = i0 + cell[0], j = j0 + cell[1];
      const GrownGrid& mesh = *path.end_mesh;
      return Frame<2>(path.end).to_space(0.25 * (mesh.node(i, j) + mesh.node(i + 1, j) + mesh.node(i, j + 1) + mesh.node(i + 1, j + 1)));
    }
  return cell_center(grid, tile, cell, path.end);
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

template <int Dim>
Corners<Dim> EulerSolver<Dim>::cell_corners(int grid, int tile, const Index<Dim>& cell) const {
  const Index<Dim> first = grids_[static_cast<std::size_t>(grid)].first_cell(tile);
  Corners<Dim> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Index<Dim> node;
    for (std::size_t d = 0; d < Dim; ++d) node[d] = first[d] + cell[d] + static_cast<int>(k >> d & 1U);
    corners[k] = present_node(grid, node);
  }
  return corners;
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
