// The step itself: which tiles are computed, and the kernel's view of each.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/euler_solver.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {

template <int Dim>
CartesianTile<Dim> EulerSolver<Dim>::cartesian(int g, int t) {
  const auto grid = static_cast<std::size_t>(g);
  CartesianTile<Dim> tile;
  tile.shape = &grids_[grid].shape;
  tile.now = now_[grid].tile(t).component(0);
  tile.next = next_[grid].tile(t).component(0);
  for (std::size_t d = 0; d < Dim; ++d) tile.spacing[d] = grids_[grid].spacing[static_cast<int>(d)];
  const TileMask& mask = grids_[grid].masks[static_cast<std::size_t>(t)];
  tile.active = mask.cut() ? mask.active.data() : nullptr;
  return tile;
}

/// The kernel's view of a body-grid tile whose nodes place() has put.
template <int Dim>
FittedTile<Dim> EulerSolver<Dim>::fitted(int g, int t) {
  const CartesianTile<Dim> base = cartesian(g, t);
  FittedTile<Dim> tile{};
  if constexpr (Dim == 2) {
    tile.shape = base.shape;
    tile.nodes = &node_shapes_[static_cast<std::size_t>(g)];
    tile.now = base.now;
    tile.next = base.next;
    tile.active = base.active;
    tile.x = positions_[0].data();
    tile.y = positions_[1].data();
    tile.wx = velocities_[0].data();
    tile.wy = velocities_[1].data();
  } else {
    tile.line = base;
    tile.velocity = velocities_[0][0];
  }
  return tile;
}

template <int Dim>
StepResult EulerSolver<Dim>::step_tile(int g, int t, const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure,
                                       double dt, const StepOptions& options) {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  if (special(g, t)) return stepper_->step(cartesian(g, t), t, dt, options);
  if (grid.background()) return godunov_step(cartesian(g, t), dt, options);
  const auto body = static_cast<std::size_t>(grid.body);
  place(g, t, paths[body], dt, 0.5);
  FittedTile<Dim> tile = fitted(g, t);
  if (carries_wall(g, t)) {
    if constexpr (Dim == 2) {
      tile.south = WallSide{.present = true, .pressure = pressure[body].data() + grid.first_cell(t)[0]};
    } else {
      const bool two_sided = std::isfinite(setup_.bodies[body].shape.atlas->left());
      (grid.side > 0 ? tile.left : tile.right) = WallSide{.present = true, .pressure = pressure[body].data() + (grid.side > 0 && two_sided ? 1 : 0)};
    }
  }
  if constexpr (Dim == 2)
    if (!overlap_) {
      const auto mirror = [&](std::size_t side, bool at_edge) { return at_edge && setup_.bodies[body].sides[side] == BoundaryKind::wall; };
      const Index<2> first = grid.first_cell(t);
      tile.west_mirror = mirror(0, first[0] == 0);
      tile.east_mirror = mirror(1, first[0] + grid.shape.cells[0] == grid.cells[0]);
      tile.north_mirror = mirror(3, first[1] + grid.shape.cells[1] == grid.cells[1]);
    }
  return godunov_step(tile, dt, options);
}

/// A step of first order leaves pressures that are positive but for round-off. Where thermal energy has been lost in the
/// round-off of the total energy the gas is given so much of it back. Returns the new state's rate.
template <int Dim>
StepResult EulerSolver<Dim>::restore_pressure(int g, int t) {
  constexpr double lost = 1e-13;  // part of the total energy per volume
  const auto of_grid = static_cast<std::size_t>(g);
  const TileMask& mask = grids_[of_grid].masks[static_cast<std::size_t>(t)];
  TileBlock& next = next_[of_grid].tile(t);
  for_each_cell<Dim>(grids_[of_grid].shape, 0, [&](const Index<Dim>& c) {
    const std::size_t k = grids_[of_grid].shape.at(c);
    if (mask.cut() && !mask.active[k]) return;
    const Conserved<Dim> U = get<Dim>(next, k);
    Primitive<Dim> W = to_primitive(U, setup_.gas.gamma);
    if (!(W.density > 0) || !(std::fabs(W.pressure) < lost * U.energy)) return;
    W.pressure = lost * U.energy;
    put<Dim>(next, k, to_conserved(W, setup_.gas.gamma));
  });
  if (grids_[of_grid].background()) {
    CartesianTile<Dim> tile = cartesian(g, t);
    tile.now = next.component(0);
    return wave_rate(tile, setup_.options);
  }
  FittedTile<Dim> tile = fitted(g, t);  // where step_tile() has put its nodes
  if constexpr (Dim == 2)
    tile.now = next.component(0);
  else
    tile.line.now = next.component(0);
  return wave_rate(tile, setup_.options);
}

/// The tile lies on a wall; tiles of meshes may be farther out.
template <int Dim>
bool EulerSolver<Dim>::carries_wall(int g, int t) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  return setup_.bodies[static_cast<std::size_t>(grid.body)].wall && (Dim == 1 || grid.first_cell(t)[Dim - 1] == 0);
}

template <int Dim>
bool EulerSolver<Dim>::step(const std::vector<BodyPath<Dim>>& paths, const std::vector<std::vector<double>>& pressure, double dt, bool first_order) {
  const auto scope = timers_("fluid");
  StepOptions options = setup_.options;
  if (first_order) options.limiter = Limiter::flat;
  count_ = {};
  bool admissible = true;
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t) {
      const auto tile = static_cast<std::size_t>(t);
      const TileMask& mask = grids_[g].masks[tile];
      new_rates_[g][tile] = rates_[g][tile];
      computed_[g][tile] = 0;
      if (!now_[g].tile(t).allocated() || (setup_.skip && quiet(static_cast<int>(g), t))) {
        if (now_[g].tile(t).allocated()) count_.skipped += mask.active_count;
        continue;
      }
      if (mask.cut() && mask.active_count == 0 && mask.hole) continue;
      StepResult result = step_tile(static_cast<int>(g), t, paths, pressure, dt, options);
      if (first_order && !result.admissible && !special(static_cast<int>(g), t)) result = restore_pressure(static_cast<int>(g), t);
      computed_[g][tile] = 1;
      new_rates_[g][tile] = result.rate;
      admissible = admissible && result.admissible;
      count_.computed += mask.active_count;
      uniform_[g][tile] = grids_[g].background() && !mask.cut() && uniform(static_cast<int>(g), t, next_[g].tile(t));
    }
  return !comm_.any(!admissible);
}

template <int Dim>
double EulerSolver<Dim>::rate() const {
  double fastest = 0;
  for (const std::vector<double>& of_grid : rates_)
    for (const double rate : of_grid) fastest = std::max(fastest, rate);
  return comm_.max(fastest);
}

template <int Dim>
void EulerSolver<Dim>::measure_rates(const std::vector<BodyPath<Dim>>& paths, double dt) {
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (int t = 0; t < now_[g].tiles(); ++t) {
      double& rate = rates_[g][static_cast<std::size_t>(t)];
      rate = 0;
      const TileMask& mask = grids_[g].masks[static_cast<std::size_t>(t)];
      if (!now_[g].tile(t).allocated() || (mask.cut() && mask.active_count == 0)) continue;
      if (grids_[g].background()) {
        const CartesianTile<Dim> tile = cartesian(static_cast<int>(g), t);
        rate = (special(static_cast<int>(g), t) ? stepper_->rate(tile, t, setup_.options) : wave_rate(tile, setup_.options)).rate;
      } else {
        place(static_cast<int>(g), t, paths[static_cast<std::size_t>(grids_[g].body)], dt, 0);
        rate = wave_rate(fitted(static_cast<int>(g), t), setup_.options).rate;
      }
    }
}

template <int Dim>
std::vector<std::vector<WallTrace<Dim>>> EulerSolver<Dim>::wall_traces(const std::vector<BodyPath<Dim>>& paths, double dt) {
  struct Item {
    int body, face;
    WallTrace<Dim> trace;
  };
  std::vector<Item> mine;
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    if (grid.background()) continue;
    for (int t = 0; t < now_[g].tiles(); ++t) {
      if (!carries_wall(static_cast<int>(g), t)) continue;
      if (!now_[g].tile(t).allocated())
        throw NumericalError("no gas is left around body " + setup_.bodies[static_cast<std::size_t>(grid.body)].name + ": its grid lies in other bodies");
      place(static_cast<int>(g), t, paths[static_cast<std::size_t>(grid.body)], dt, 0);
      FittedTile<Dim> tile = fitted(static_cast<int>(g), t);
      if constexpr (Dim == 2) {
        tile.south.present = true;
        std::vector<WallTrace2> traces(static_cast<std::size_t>(grid.shape.cells[0]));
        mortise::wall_traces(tile, dt, setup_.options, traces.data());
        for (std::size_t i = 0; i < traces.size(); ++i)
          mine.push_back({grid.body, grid.first_cell(t)[0] + static_cast<int>(i), {traces[i].now, traces[i].half}});
      } else {
        (grid.side > 0 ? tile.left : tile.right).present = true;
        const WallTrace1 trace = wall_trace(tile, grid.side < 0, dt, setup_.options);
        mine.push_back({grid.body, grid.side > 0 ? 1 : 0, {trace.now, trace.half}});
      }
    }
  }
  std::vector<Item> all = comm_.gather_all(mine);
  std::stable_sort(all.begin(), all.end(), [](const Item& a, const Item& b) { return std::pair(a.body, a.face) < std::pair(b.body, b.face); });
  std::vector<std::vector<WallTrace<Dim>>> traces(setup_.bodies.size());
  for (const Item& item : all) traces[static_cast<std::size_t>(item.body)].push_back(item.trace);
  return traces;
}

/// All cells of the tile hold the same state, bit for bit.
template <int Dim>
bool EulerSolver<Dim>::uniform(int g, int, const TileBlock& block) const {
  const TileShape<Dim>& shape = grids_[static_cast<std::size_t>(g)].shape;
  if (!grids_[static_cast<std::size_t>(g)].background() || !block.allocated()) return false;
  const int rows = Dim == 2 ? shape.cells[Dim - 1] : 1;
  const std::size_t first = shape.at(0, 0);
  for (int j = 0; j < rows; ++j)
    for (int c = 0; c < components; ++c) {
      const double* row = block.component(c) + shape.at(0, j);
      const double value = block.component(c)[first];
      for (int i = 0; i < shape.cells[0]; ++i)
        if (row[i] != value) return false;
    }
  return true;
}

/// A uniform tile whose ghost cells hold its own state: the step would leave it as it is, bit for bit.
template <int Dim>
bool EulerSolver<Dim>::quiet(int g, int t) const {
  const auto grid = static_cast<std::size_t>(g);
  if (!uniform_[grid][static_cast<std::size_t>(t)] || special(g, t) || grids_[grid].masks[static_cast<std::size_t>(t)].cut()) return false;
  const TileShape<Dim>& shape = grids_[grid].shape;
  const TileBlock& block = now_[grid].tile(t);
  const std::size_t first = shape.at(0, 0);
  const int side_rows = Dim == 2 ? shape.cells[Dim - 1] + shape.ghosts : 1;
  for (int j = Dim == 2 ? -shape.ghosts : 0; j < side_rows; ++j) {
    const bool whole = Dim == 2 && (j < 0 || j >= shape.cells[Dim - 1]);
    for (int c = 0; c < components; ++c) {
      const double value = block.component(c)[first];
      const double* row = block.component(c) + shape.at(0, j);
      for (int i = -shape.ghosts; i < shape.cells[0] + shape.ghosts; ++i) {
        if (!whole && i == 0) i = shape.cells[0];
        if (row[i] != value) return false;
      }
    }
  }
  return true;
}

template <int Dim>
std::string EulerSolver<Dim>::first_bad_cell(const std::vector<BodyPath<Dim>>& paths) const {
  struct Found {
    std::int64_t grid, tile;  // global
    std::array<char, 240> text;
  };
  std::vector<Found> mine;
  for (std::size_t g = 0; g < grids_.size() && mine.empty(); ++g)
    for (int t = 0; t < now_[g].tiles() && mine.empty(); ++t) {
      if (!computed_[g][static_cast<std::size_t>(t)]) continue;
      const std::string text = bad_cell_of_tile(static_cast<int>(g), t, paths);
      if (text.empty()) continue;
      mine.push_back({static_cast<std::int64_t>(g), grids_[g].forest.first_global() + t, {}});
      text.copy(mine.back().text.data(), mine.back().text.size() - 1);
    }
  const std::vector<Found> all = comm_.gather_all(mine);
  const auto first = std::min_element(all.begin(), all.end(), [](const Found& a, const Found& b) {
    return std::pair(a.grid, a.tile) < std::pair(b.grid, b.tile);
  });
  return first == all.end() ? "" : std::string(first->text.data());
}

template <int Dim>
std::string EulerSolver<Dim>::bad_cell_of_tile(int g, int t, const std::vector<BodyPath<Dim>>& paths) const {
  const auto of_grid = static_cast<std::size_t>(g);
  const ComponentGrid<Dim>& grid = grids_[of_grid];
  const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
  std::string found;
  for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
    const std::size_t k = grid.shape.at(c);
    if (!found.empty() || (mask.cut() && !mask.active[k])) return;
    const Primitive<Dim> W = to_primitive(get<Dim>(next_[of_grid].tile(t), k), setup_.gas.gamma);
    if (W.density > 0 && W.pressure > 0 && std::isfinite(W.density) && std::isfinite(W.pressure)) return;
    const Point<Dim> x = grid.background() ? cell_center(g, t, c) : end_center(g, t, c, paths[static_cast<std::size_t>(grid.body)]);
    std::ostringstream text;
    text << "grid " << grid.name << ", cell (" << grid.first_cell(t)[0] + c[0];
    if constexpr (Dim == 2) text << ", " << grid.first_cell(t)[1] + c[1];
    text << ") at (" << x.transpose() << "): density " << W.density << ", pressure " << W.pressure - setup_.gas.p_inf
         << ", velocity";
    for (const double u : W.velocity) text << ' ' << u;
    found = text.str();
  });
  return found;
}

template class EulerSolver<1>;
template class EulerSolver<2>;

}  // namespace mortise
