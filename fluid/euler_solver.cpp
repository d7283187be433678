// Setting fields, ghost cells, and what follows a motion of the bodies.
#include "mortise/fluid/euler_solver.hpp"

#include <algorithm>

#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

template <int Dim>
void EulerSolver<Dim>::initialize(const StateFunction<Dim>& initial, const std::vector<BodyPath<Dim>>& at, double time) {
  if (has_background()) {
    const Conserved<Dim> hole = to_conserved(initial(setup_.domain.low + 0.999 * (setup_.domain.high - setup_.domain.low), time), setup_.gas.gamma);
    filler_[0] = hole.density;
    for (std::size_t d = 0; d < Dim; ++d) filler_[1 + d] = hole.momentum[d];
    filler_[Dim + 1] = hole.energy;
  }
  move_bodies(at);
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) periodic[d] = has_background() && grids_.front().periodic[d];
  const Periods<Dim> periods(setup_.domain, periodic);  // bodies may reach beyond the domain
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t) {
      for (TileBlock* block : {&now_[g].tile(t), &next_[g].tile(t)})
        for (int c = 0; c < components; ++c)
          std::fill_n(block->component(c), grids_[g].shape.plane, filler_[static_cast<std::size_t>(c)]);
      for_each_cell<Dim>(grids_[g].shape, 0, [&](const Index<Dim>& c) {
        const auto state = [&](const Point<Dim>& x) { return to_conserved(initial(periods.near(x, setup_.domain), time), setup_.gas.gamma); };
        const int grid = static_cast<int>(g);
        put<Dim>(now_[g].tile(t), grids_[g].shape.at(c),
                 setup_.smooth ? mean_state<Dim>(cell_corners(grid, t, c), state) : state(cell_center(grid, t, c)));
      });
    }
  settle(time);
}

template <int Dim>
void EulerSolver<Dim>::resume(const std::vector<BodyPath<Dim>>& at, double time) {
  move_bodies(at);
  settle(time);
}

/// What cells hold is of the present: cuts without exposing anything, fills ghosts.
template <int Dim>
void EulerSolver<Dim>::settle(double time) {
  if (overlap_ && !setup_.bodies.empty()) cut(true);
  fill_ghosts(time);
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t)
      uniform_[g][static_cast<std::size_t>(t)] = uniform(static_cast<int>(g), t, now_[g].tile(t));
}

template <int Dim>
void EulerSolver<Dim>::commit(const std::vector<BodyPath<Dim>>& paths, double time) {
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t)
      if (computed_[g][static_cast<std::size_t>(t)]) std::swap(now_[g].tile(t), next_[g].tile(t));
  rates_ = new_rates_;
  move_bodies(paths);
  if (overlap_ && !setup_.bodies.empty()) {
    cut(false);
    {
      const auto scope = timers_("ghosts");
      for (std::size_t g = 0; g < grids_.size(); ++g) exchanges_[g].fill(now_[g], filler_, overlap_->donor_tiles(static_cast<int>(g)));
    }
    interpolate();
  }
  fill_ghosts(time);
}

/// Puts the bodies, and the nodes of deforming grids, at the ends of their paths.
template <int Dim>
void EulerSolver<Dim>::move_bodies(const std::vector<BodyPath<Dim>>& paths) {
  for (std::size_t b = 0; b < paths.size(); ++b) {
    poses_[b] = paths[b].end;
    if (!paths[b].end_mesh) continue;
    meshes_[b] = paths[b].end_mesh;
    if (overlap_) overlap_->reshape(b, paths[b].end_atlas);
  }
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    if (grids_[g].background() || !paths[static_cast<std::size_t>(grids_[g].body)].end_mesh) continue;
    for (int t = 0; t < now_[g].tiles(); ++t)
      read_nodes(*meshes_[static_cast<std::size_t>(grids_[g].body)], static_cast<int>(g), t, reference_[g][static_cast<std::size_t>(t)]);
  }
}

/// Cuts holes for the bodies where they are; `fresh`: every active cell holds a valid state already.
template <int Dim>
void EulerSolver<Dim>::cut(bool fresh) {
  const auto scope = timers_("overlap");
  if (overlap_->update(poses_, fresh)) blank_holes();
  const OverlapReport& report = overlap_->report();
  if (report.orphans > 0)
    throw NumericalError("the overlap has " + std::to_string(report.orphans) + " cells without a donor, the first in " + report.first_orphan +
                         ": bodies, or a body and the edge of the domain, are closer there than the grids resolve");
}

template <int Dim>
void EulerSolver<Dim>::interpolate() {
  const auto scope = timers_("interpolation");
  const double gamma = setup_.gas.gamma;
  overlap_->template fill<components>(
      now_, [gamma](const double* U, double* W) { decode<Dim>(U, W, gamma); }, [gamma](const double* W, double* U) { encode<Dim>(W, U, gamma); });
}

template <int Dim>
void EulerSolver<Dim>::fill_ghosts(double time) {
  const auto scope = timers_("ghosts");
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const int grid = static_cast<int>(g);
    exchanges_[g].fill(now_[g], filler_);
    if (grids_[g].background()) {
      for (int t = 0; t < now_[g].tiles(); ++t)
        if (now_[g].tile(t).allocated()) fill_boundary<Dim>(grids_[g], t, now_[g].tile(t), setup_.boundaries, setup_.gas.gamma, time);
    } else if (overlap_) {
      fill_inner_edges(grid, time);
    } else {
      fill_sides(grid, time);
    }
  }
}

/// Ghost layers inside bodies whose surface carries exact data instead of a wall.
template <int Dim>
void EulerSolver<Dim>::fill_inner_edges(int g, double time) {
  const auto of_grid = static_cast<std::size_t>(g);
  const ComponentGrid<Dim>& grid = grids_[of_grid];
  if (setup_.bodies[static_cast<std::size_t>(grid.body)].wall) return;
  for (int t = 0; t < now_[of_grid].tiles(); ++t) {
    Index<Dim> low, high;
    for (std::size_t d = 0; d < Dim; ++d) {
      low[d] = -grid.shape.ghosts;
      high[d] = grid.shape.cells[d] + grid.shape.ghosts;
    }
    if (Dim == 2 || grid.side > 0)
      high[Dim - 1] = 0;
    else
      low[0] = grid.shape.cells[0];
    for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
      put<Dim>(now_[of_grid].tile(t), grid.shape.at(c), to_conserved(setup_.boundaries.exact(cell_center(g, t, c), time), setup_.gas.gamma));
    });
  }
}

/// Ghost layers beyond the sides of a mesh.
template <int Dim>
void EulerSolver<Dim>::fill_sides(int g, double time) {
  if constexpr (Dim == 2) {
    const auto of_grid = static_cast<std::size_t>(g);
    const FittedBody<2>& body = setup_.bodies[static_cast<std::size_t>(grids_[of_grid].body)];
    std::array<BoundaryKind, 4> kinds = body.sides;
    kinds[2] = body.wall ? BoundaryKind::wall : BoundaryKind::exact;
    for (int t = 0; t < now_[of_grid].tiles(); ++t) {
      place_nodes(g, t, pose_of(g), positions_);
      fill_boundary(grids_[of_grid], t, now_[of_grid].tile(t), kinds, {&node_shapes_[of_grid], positions_[0].data(), positions_[1].data()},
                    setup_.boundaries, setup_.gas.gamma, time);
    }
  }
}

/// Hole cells hold one fixed state, so that nothing depends on what they held; tiles of nothing else give up their memory.
template <int Dim>
void EulerSolver<Dim>::blank_holes() {
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    for (int t = 0; t < now_[g].tiles(); ++t) {
      const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
      TileBlock& block = now_[g].tile(t);
      if (setup_.skip && mask.cut() && mask.hole) {
        block.release();
        next_[g].tile(t).release();
        continue;
      }
      if (!block.allocated()) {
        for (Field<Dim>* field : {&now_[g], &next_[g]}) {
          field->allocate(t);
          for (int c = 0; c < components; ++c)
            std::fill_n(field->tile(t).component(c), grid.shape.plane, filler_[static_cast<std::size_t>(c)]);
        }
        uniform_[g][static_cast<std::size_t>(t)] = 0;
      }
      for (const std::size_t k : mask.new_holes)
        for (int c = 0; c < components; ++c) block.component(c)[k] = filler_[static_cast<std::size_t>(c)];
    }
  }
}

template <int Dim>
std::size_t EulerSolver<Dim>::memory_bytes() const {
  std::size_t bytes = 0;
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t) bytes += now_[g].tile(t).bytes() + next_[g].tile(t).bytes();
  return bytes;
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
