// Setting up grids and fields, ghost cells, and what follows a motion of the bodies.
#include "mortise/fluid/euler_solver.hpp"

#include <algorithm>

#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Cells per tile along the surface of a body grid: the whole way round, or an even part of it no longer than 128.
int tile_length(int along) {
  for (int parts = 1;; ++parts)
    if (along % parts == 0 && along / parts <= 128 && along / parts % 2 == 0) return along / parts;
}

void append_body_grids(std::vector<ComponentGrid<2>>& grids, const Communicator& comm, const FittedBody<2>& body, int index) {
  const int along = body.shape.atlas->grid().along;
  const int layers = body.shape.layers;
  grids.emplace_back(body.name, comm, Index<2>{along, layers}, std::array<bool, 2>{true, false}, TileShape<2>({tile_length(along), layers}));
  grids.back().body = index;
  grids.back().spacing.setConstant(body.shape.spacing);
}

void append_body_grids(std::vector<ComponentGrid<1>>& grids, const Communicator& comm, const FittedBody<1>& body, int index) {
  for (const int side : {-1, 1}) {
    if (!std::isfinite(side < 0 ? body.shape.atlas->left() : body.shape.atlas->right())) continue;
    grids.emplace_back(body.name + (side < 0 ? "_left" : "_right"), comm, Index<1>{body.shape.layers}, std::array<bool, 1>{false},
                       TileShape<1>({body.shape.layers}));
    grids.back().body = index;
    grids.back().side = side;
    grids.back().spacing.setConstant(body.shape.spacing);
  }
}

}  // namespace

template <int Dim>
EulerSolver<Dim>::EulerSolver(const Communicator& comm, EulerSetup<Dim> setup, PhaseTimers& timers)
    : comm_(comm), setup_(std::move(setup)), timers_(timers) {
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) {
    periodic[d] = setup_.boundaries.kind[2 * d] == BoundaryKind::periodic;
    if (setup_.cells[d] % setup_.tile[d] != 0)
      throw InputError("a background of " + std::to_string(setup_.cells[d]) + " cells cannot be cut into tiles of " + std::to_string(setup_.tile[d]));
  }
  grids_.emplace_back("background", comm_, setup_.cells, periodic, TileShape<Dim>(setup_.tile));
  grids_[0].origin = setup_.domain.low;
  for (int d = 0; d < Dim; ++d)
    grids_[0].spacing[d] = (setup_.domain.high[d] - setup_.domain.low[d]) / setup_.cells[static_cast<std::size_t>(d)];
  std::vector<OverlapBody<Dim>> shapes;
  for (std::size_t b = 0; b < setup_.bodies.size(); ++b) {
    append_body_grids(grids_, comm_, setup_.bodies[b], static_cast<int>(b));
    shapes.push_back(setup_.bodies[b].shape);
  }
  for (const ComponentGrid<Dim>& grid : grids_) {
    const int tiles = grid.forest.local_count();
    now_.emplace_back(grid.shape, components, tiles);
    next_.emplace_back(grid.shape, components, tiles);
    exchanges_.emplace_back(grid.forest, grid.shape, components);
    rates_.emplace_back(static_cast<std::size_t>(tiles), 0.0);
    uniform_.emplace_back(static_cast<std::size_t>(tiles), std::uint8_t{0});
    computed_.emplace_back(static_cast<std::size_t>(tiles), std::uint8_t{0});
  }
  new_rates_ = rates_;
  build_reference_nodes();
  overlap_ = std::make_unique<Overlap<Dim>>(comm_, grids_, std::move(shapes), setup_.domain, setup_.overlap);
}

template <int Dim>
void EulerSolver<Dim>::initialize(const StateFunction<Dim>& initial, const std::vector<Pose<Dim>>& poses, double time) {
  const Conserved<Dim> hole = to_conserved(initial(setup_.domain.low + 0.999 * (setup_.domain.high - setup_.domain.low), time), setup_.gas.gamma);
  filler_[0] = hole.density;
  for (std::size_t d = 0; d < Dim; ++d) filler_[1 + d] = hole.momentum[d];
  filler_[Dim + 1] = hole.energy;
  poses_ = poses;
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t) {
      for (TileBlock* block : {&now_[g].tile(t), &next_[g].tile(t)})
        for (int c = 0; c < components; ++c)
          std::fill_n(block->component(c), grids_[g].shape.plane, filler_[static_cast<std::size_t>(c)]);
      const Pose<Dim> pose = grids_[g].background() ? Pose<Dim>{} : poses[static_cast<std::size_t>(grids_[g].body)];
      for_each_cell<Dim>(grids_[g].shape, 0, [&](const Index<Dim>& c) {
        const Point<Dim> x = cell_center(static_cast<int>(g), t, c, pose);
        put<Dim>(now_[g].tile(t), grids_[g].shape.at(c), to_conserved(initial(x, time), setup_.gas.gamma));
      });
    }
  resume(poses, time);
}

template <int Dim>
void EulerSolver<Dim>::resume(const std::vector<Pose<Dim>>& poses, double time) {
  poses_ = poses;
  if (!setup_.bodies.empty()) cut(poses, true);
  fill_ghosts(time);
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t)
      uniform_[g][static_cast<std::size_t>(t)] = uniform(static_cast<int>(g), t, now_[g].tile(t));
}

template <int Dim>
void EulerSolver<Dim>::commit(const std::vector<Pose<Dim>>& poses, double time) {
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t)
      if (computed_[g][static_cast<std::size_t>(t)]) std::swap(now_[g].tile(t), next_[g].tile(t));
  rates_ = new_rates_;
  poses_ = poses;
  if (!setup_.bodies.empty()) {
    cut(poses, false);
    {
      const auto scope = timers_("ghosts");
      for (std::size_t g = 0; g < grids_.size(); ++g) exchanges_[g].fill(now_[g], filler_, overlap_->donor_tiles(static_cast<int>(g)));
    }
    interpolate();
  }
  fill_ghosts(time);
}

/// Cuts holes for the poses; `fresh`: every active cell holds a valid state already.
template <int Dim>
void EulerSolver<Dim>::cut(const std::vector<Pose<Dim>>& poses, bool fresh) {
  const auto scope = timers_("overlap");
  if (overlap_->update(poses, fresh)) blank_holes();
  const OverlapReport& report = overlap_->report();
  if (report.orphans > 0)
    throw NumericalError("the overlap has " + std::to_string(report.orphans) + " cells without a donor, the first in " + report.first_orphan);
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
    exchanges_[g].fill(now_[g], filler_);
    if (!grids_[g].background()) continue;
    for (int t = 0; t < now_[g].tiles(); ++t)
      if (now_[g].tile(t).allocated()) fill_boundary<Dim>(grids_[g], t, now_[g].tile(t), setup_.boundaries, setup_.gas.gamma, time);
  }
  fill_inner_edges(time);
}

/// Ghost layers inside bodies whose surface carries exact data instead of a wall.
template <int Dim>
void EulerSolver<Dim>::fill_inner_edges(double time) {
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    if (grid.background() || setup_.bodies[static_cast<std::size_t>(grid.body)].wall) continue;
    for (int t = 0; t < now_[g].tiles(); ++t) {
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
        const Point<Dim> x = cell_center(static_cast<int>(g), t, c, poses_[static_cast<std::size_t>(grid.body)]);
        put<Dim>(now_[g].tile(t), grid.shape.at(c), to_conserved(setup_.boundaries.exact(x, time), setup_.gas.gamma));
      });
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
