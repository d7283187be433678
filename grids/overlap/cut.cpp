// Cutting: which cells are active, fringe, holes (see overlap.hpp for the rules).
#include <algorithm>

#include "mortise/grids/overlap/overlap.hpp"

namespace mortise {
namespace {

/// Side (1D) and layer of a body grid's cell, counted from the wall.
template <int Dim>
int layer_of(const ComponentGrid<Dim>& grid, const Index<Dim>& cell) {
  if constexpr (Dim == 2) return cell[1];
  return grid.side > 0 ? cell[0] : grid.cells[0] - 1 - cell[0];
}

/// Centres of all cells of a body grid in the body's frame, direction 0 fastest.
std::vector<Point<2>> cell_centers(const ComponentGrid<2>& grid, const BodyAtlas& atlas) {
  std::vector<Point<2>> centers;
  for_each_index<2>({0, 0}, grid.cells, [&](const Index<2>& c) { centers.push_back(atlas.center(c[0], c[1])); });
  return centers;
}

std::vector<Point<1>> cell_centers(const ComponentGrid<1>& grid, const LineAtlas& atlas) {
  std::vector<Point<1>> centers;
  for (int i = 0; i < grid.cells[0]; ++i)
    centers.push_back(Point<1>(0.5 * (atlas.node(grid.side, i) + atlas.node(grid.side, i + 1))));
  return centers;
}

}  // namespace

template <int Dim>
Overlap<Dim>::Overlap(const Communicator& comm, std::vector<ComponentGrid<Dim>>& grids, std::vector<OverlapBody<Dim>> bodies,
                      Box<Dim> domain, OverlapOptions options)
    : comm_(comm), grids_(grids), bodies_(std::move(bodies)), domain_(domain), options_(options) {
  periodic_ = grids_.front().periodic;
  previous_.resize(grids_.size());
  for (const ComponentGrid<Dim>& grid : grids_) {
    std::vector<double> distances;
    std::vector<Point<Dim>> centers;
    if (!grid.background()) {
      const Atlas<Dim>& atlas = *bodies_[static_cast<std::size_t>(grid.body)].atlas;
      centers = cell_centers(grid, atlas);
      for (const Point<Dim>& X : centers) distances.push_back(atlas.distance(X));
    }
    body_centers_.push_back(std::move(centers));
    own_distances_.push_back(std::move(distances));
  }
}

template <int Dim>
bool Overlap<Dim>::update(const std::vector<Pose<Dim>>& poses, bool fresh) {
  if (poses == poses_ && !exposed_last_ && !fresh) return false;
  poses_ = poses;
  frames_.clear();
  reaches_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    frames_.emplace_back(poses_[b]);
    reaches_.push_back(frames_[b].to_space(bodies_[b].atlas->reach()));
  }
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    previous_[g].resize(grids_[g].masks.size());
    if (grids_[g].background())
      cut_background(grids_[g]);
    else
      cut_body_grid(grids_[g]);
    if (fresh)
      for (std::size_t t = 0; t < grids_[g].masks.size(); ++t) previous_[g][t] = grids_[g].masks[t].active;
  }
  collect_receivers();
  find_donors();
  count();
  return true;
}

template <int Dim>
double Overlap<Dim>::edge_distance(const Point<Dim>& x) const {
  double distance = 1e300;
  for (int d = 0; d < Dim; ++d)
    if (!periodic_[static_cast<std::size_t>(d)]) distance = std::min({distance, x[d] - domain_.low[d], domain_.high[d] - x[d]});
  return distance;
}

template <int Dim>
bool Overlap<Dim>::covers_background(const OverlapBody<Dim>& body, double distance, double edge) const {
  const double inner = (body.layers - 2 - options_.overlap) * body.spacing;
  return distance <= 0 || (distance < inner && edge > distance + options_.margin * body.spacing);
}

template <int Dim>
bool Overlap<Dim>::wanted_by_background(const Point<Dim>& x) const {
  const double edge = edge_distance(x);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (reaches_[b].contains(x) && covers_background(bodies_[b], bodies_[b].atlas->distance(frames_[b].to_body(x)), edge)) return false;
  return edge > 0;
}

template <int Dim>
bool Overlap<Dim>::wanted_by_body(int body, double own_distance, const Point<Dim>& x) const {
  const double limit = own_distance - options_.margin * bodies_[static_cast<std::size_t>(body)].spacing;
  const double edge = edge_distance(x);
  if (edge <= 0 || limit > edge) return false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (static_cast<int>(b) == body || !reaches_[b].contains(x)) continue;
    const double distance = bodies_[b].atlas->distance(frames_[b].to_body(x));
    if (distance <= 0 || limit > distance) return false;
  }
  return true;
}

template <int Dim>
void Overlap<Dim>::begin_tile(ComponentGrid<Dim>& grid, int tile, std::uint8_t active) {
  TileMask& mask = grid.masks[static_cast<std::size_t>(tile)];
  mask.active.assign(grid.shape.plane, active);
  mask.state.assign(grid.shape.plane, CellState::active);
}

template <int Dim>
void Overlap<Dim>::cut_background(ComponentGrid<Dim>& grid) {
  const auto g = static_cast<std::size_t>(&grid - grids_.data());
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
    previous_[g][static_cast<std::size_t>(t)].swap(mask.active);
    mask.active.clear();
    mask.state.clear();
    mask.hole = false;
    const Box<Dim> box = grid.box(t).grown(4 * grid.spacing.maxCoeff());
    const Index<Dim> first = grid.first_cell(t);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!reaches_[b].meets(box)) continue;
      if (mask.active.empty()) begin_tile(grid, t, 1);
      Index<Dim> low, high;  // cells of the tile (with ghosts) within the body's reach
      for (std::size_t d = 0; d < Dim; ++d) {
        const int k = static_cast<int>(d);
        const auto cell_at = [&](double x) {  // x may be infinite
          const double cell = std::floor((x - grid.origin[k]) / grid.spacing[k]) - first[d];
          return static_cast<int>(std::clamp<double>(cell, -grid.shape.ghosts, grid.shape.cells[d] + grid.shape.ghosts));
        };
        low[d] = cell_at(reaches_[b].low[k]);
        high[d] = std::min(cell_at(reaches_[b].high[k]) + 2, grid.shape.cells[d] + grid.shape.ghosts);
      }
      for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
        Index<Dim> global = c;
        for (std::size_t d = 0; d < Dim; ++d) global[d] += first[d];
        const Point<Dim> x = grid.center(global);
        if (covers_background(bodies_[b], bodies_[b].atlas->distance(frames_[b].to_body(x)), edge_distance(x)))
          mask.active[grid.shape.at(c)] = 0;
      });
    }
    mark_fringe(grid, t);
  }
}

template <int Dim>
void Overlap<Dim>::cut_body_grid(ComponentGrid<Dim>& grid) {
  const auto g = static_cast<std::size_t>(&grid - grids_.data());
  const auto body = static_cast<std::size_t>(grid.body);
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
    previous_[g][static_cast<std::size_t>(t)].swap(mask.active);
    begin_tile(grid, t, 0);
    const Index<Dim> first = grid.first_cell(t);
    for_each_cell<Dim>(grid.shape, grid.shape.ghosts, [&](const Index<Dim>& c) {
      Index<Dim> cell = c;
      std::size_t index = 0;
      for (std::size_t d = Dim; d-- > 0;) {
        cell[d] += first[d];
        if (grid.periodic[d]) cell[d] = (cell[d] + grid.cells[d]) % grid.cells[d];
        if (cell[d] < 0 || cell[d] >= grid.cells[d]) return;
        index = index * static_cast<std::size_t>(grid.cells[d]) + static_cast<std::size_t>(cell[d]);
      }
      if (layer_of<Dim>(grid, cell) >= bodies_[body].layers - 2) return;
      const Point<Dim> x = frames_[body].to_space(body_centers_[g][index]);
      mask.active[grid.shape.at(c)] = wanted_by_body(grid.body, own_distances_[g][index], x) ? 1 : 0;
    });
    mark_fringe(grid, t);
  }
}

/// state = active, fringe where the stencil |di| + |dj| ≤ 2 of an active cell reaches, hole elsewhere.
template <int Dim>
void Overlap<Dim>::mark_fringe(ComponentGrid<Dim>& grid, int tile) {
  TileMask& mask = grid.masks[static_cast<std::size_t>(tile)];
  mask.active_count = grid.shape.count();
  if (mask.active.empty()) return;
  const int rows = Dim == 2 ? grid.shape.cells[Dim - 1] : 1;
  const std::ptrdiff_t s = grid.shape.stride;
  int active = 0, fringe = 0;
  for (int j = 0; j < rows; ++j) {
    const std::uint8_t* a = mask.active.data() + grid.shape.at(0, j);
    CellState* state = mask.state.data() + grid.shape.at(0, j);
    for (int i = 0; i < grid.shape.cells[0]; ++i) {
      unsigned reached = a[i - 2] | a[i - 1] | a[i + 1] | a[i + 2];
      if constexpr (Dim == 2)
        reached |= unsigned(a[i - s - 1] | a[i - s] | a[i - s + 1] | a[i + s - 1] | a[i + s] | a[i + s + 1] | a[i - 2 * s] | a[i + 2 * s]);
      state[i] = a[i] ? CellState::active : reached ? CellState::fringe : CellState::hole;
      active += a[i];
      fringe += state[i] == CellState::fringe;
    }
  }
  mask.active_count = active;
  mask.hole = active + fringe == 0;
  if (active == grid.shape.count()) {
    const std::size_t ghosts_cut = static_cast<std::size_t>(std::count(mask.active.begin(), mask.active.end(), 0));
    if (ghosts_cut == 0) mask.active.clear(), mask.state.clear();
  }
}

template <int Dim>
void Overlap<Dim>::count() {
  OverlapReport local;
  for (const ComponentGrid<Dim>& grid : grids_)
    for (const TileMask& mask : grid.masks) {
      if (!mask.cut()) continue;
      for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
        local.fringe += mask.state[grid.shape.at(c)] == CellState::fringe;
        local.holes += mask.state[grid.shape.at(c)] == CellState::hole;
      });
    }
  for (const Receiver& receiver : receivers_) local.exposed += receiver.exposed;
  report_.fringe = comm_.sum(local.fringe);
  report_.holes = comm_.sum(local.holes);
  report_.exposed = comm_.sum(local.exposed);
  report_.tight = comm_.sum(report_.tight);
  report_.orphans = comm_.sum(report_.orphans);
  exposed_last_ = report_.exposed > 0;
}

template <int Dim>
double Overlap<Dim>::share(int grid, const Point<Dim>& x) const {
  // 1 on a body's grid near the wall, falling smoothly to 0 across the overlap; the background takes the rest.
  double background = 1, own = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!reaches_[b].contains(x)) continue;
    const double distance = bodies_[b].atlas->distance(frames_[b].to_body(x));
    const double outer = (bodies_[b].layers - 2) * bodies_[b].spacing;
    const double s = std::clamp((outer - distance) / (options_.overlap * bodies_[b].spacing), 0.0, 1.0);
    const double weight = s * s * (3 - 2 * s);
    background *= 1 - weight;
    if (static_cast<int>(b) == grids_[static_cast<std::size_t>(grid)].body) own = weight;
  }
  return grids_[static_cast<std::size_t>(grid)].background() ? background : own;
}

template class Overlap<1>;
template class Overlap<2>;

}  // namespace mortise
