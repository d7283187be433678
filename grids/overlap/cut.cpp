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

const Box<2>& vicinity(const BodyAtlas& atlas) { return atlas.vicinity(); }
const Box<1>& vicinity(const LineAtlas& atlas) { return atlas.reach(); }

/// Whether a box in space may hold points whose side of the curve, or whose place on the body's grid, is new.
bool near_interface(const BodyAtlas& atlas, const Frame<2>& frame, const Box<2>& box) {
  if (!atlas.inward()) return true;
  Box<2> in_body;
  for (const double x : {box.low[0], box.high[0]})
    for (const double y : {box.low[1], box.high[1]}) in_body.include(frame.to_body(Point<2>(x, y)));
  return atlas.near_grid(in_body);
}
bool near_interface(const LineAtlas&, const Frame<1>&, const Box<1>&) { return true; }

}  // namespace

template <int Dim>
Overlap<Dim>::Overlap(const Communicator& comm, std::vector<ComponentGrid<Dim>>& grids, std::vector<OverlapBody<Dim>> bodies,
                      Box<Dim> domain, OverlapOptions options)
    : comm_(comm), grids_(grids), bodies_(std::move(bodies)), domain_(domain), options_(options) {
  periodic_ = grids_.front().periodic;
  periods_ = Periods<Dim>(domain_, periodic_);
  moved_.assign(bodies_.size(), 0);
  donor_tiles_.resize(grids_.size());
  donors_.resize(static_cast<std::size_t>(comm_.size()));
  accepted_.resize(static_cast<std::size_t>(comm_.size()));
  for (ComponentGrid<Dim>& grid : grids_) {
    tiles_.emplace_back(grid.masks.size());
    for (TileMask& mask : grid.masks) mask.active_count = grid.shape.count();
  }
  reshaped_.assign(bodies_.size(), 0);
  body_centers_.resize(grids_.size());
  own_distances_.resize(grids_.size());
  for (std::size_t g = 0; g < grids_.size(); ++g)
    if (!grids_[g].background()) measure(g);
}

/// The centres of a body grid's cells and their distances from the body.
template <int Dim>
void Overlap<Dim>::measure(std::size_t g) {
  const Atlas<Dim>& atlas = *bodies_[static_cast<std::size_t>(grids_[g].body)].atlas;
  body_centers_[g] = cell_centers(grids_[g], atlas);
  own_distances_[g].clear();
  for (const Point<Dim>& X : body_centers_[g]) own_distances_[g].push_back(atlas.distance(X));
}

template <int Dim>
void Overlap<Dim>::reshape(std::size_t body, std::shared_ptr<const Atlas<Dim>> atlas) {
  bodies_[body].atlas = std::move(atlas);
  reshaped_[body] = 1;
  for (std::size_t g = 0; g < grids_.size(); ++g)
    if (grids_[g].body == static_cast<int>(body)) measure(g);
}

template <int Dim>
bool Overlap<Dim>::update(const std::vector<Pose<Dim>>& poses, bool fresh) {
  if (!note_motion(poses, fresh)) return false;
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    for (std::size_t t = 0; t < tiles_[g].size(); ++t) {
      tiles_[g][t].was_recut = tiles_[g][t].recut;
      tiles_[g][t].recut = false;
      grids_[g].masks[t].new_holes.clear();
    }
    if (grids_[g].background())
      cut_background(static_cast<int>(g), fresh);
    else
      cut_body_grid(static_cast<int>(g), fresh);
    for (std::size_t t = 0; t < tiles_[g].size(); ++t) {
      TileOverlap& tile = tiles_[g][t];
      if (tile.recut || !tile.was_recut) continue;
      tile.active_before = grids_[g].masks[t].active;  // left alone now: nothing is exposed any more
      tile.state_before = grids_[g].masks[t].state;
      tile.exposed = 0;
    }
  }
  find_donors();
  count();
  return true;
}

/// Which bodies matter to this update: those that moved now or at the last one, and those close to them. A second
/// update after the last motion leaves donors that do not depend on what was exposed, as a restart would find them.
template <int Dim>
bool Overlap<Dim>::note_motion(const std::vector<Pose<Dim>>& poses, bool fresh) {
  std::vector<std::uint8_t> restless(bodies_.size(), 0);
  std::vector<Box<Dim>> swept;
  bool any = false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::uint8_t moves = fresh || poses_.empty() || reshaped_[b] || !(poses[b] == poses_[b]);
    restless[b] = moves | moved_[b];
    moved_[b] = moves;
    any = any || restless[b];
  }
  if (!any) return false;
  const std::vector<Box<Dim>> before = vicinities_;
  std::swap(before_, now_);
  now_.clear();
  if (fresh) before_.clear();
  poses_ = poses;
  frames_.clear();
  reaches_.clear();
  vicinities_.clear();
  reshaped_.assign(bodies_.size(), 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    frames_.emplace_back(poses_[b]);
    reaches_.push_back(frames_[b].to_space(bodies_[b].atlas->reach()));
    vicinities_.push_back(frames_[b].to_space(vicinity(*bodies_[b].atlas)));
    now_.push_back({bodies_[b].atlas, frames_[b]});
    swept.push_back(before_.empty() ? reaches_[b] : vicinities_[b]);
    if (before.empty()) continue;
    swept[b].low = swept[b].low.cwiseMin(before[b].low);
    swept[b].high = swept[b].high.cwiseMax(before[b].high);
  }
  const bool all = comm_.size() > 1;  // across ranks all donors are found anew
  touched_.assign(bodies_.size(), Box<Dim>{});
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t a = 0; a < bodies_.size(); ++a)
      if (all || (restless[a] && (a == b || !periods_.images(swept[a], swept[b]).empty()))) touched_[b] = swept[b];
  return true;
}

/// Whether a body matters to the cells in `box` at this update. Of an inward body only the curve moves: what is far outside
/// it stays covered.
template <int Dim>
bool Overlap<Dim>::touches(std::size_t body, const Box<Dim>& box) const {
  for (const Point<Dim>& shift : periods_.images(touched_[body], box)) {
    const Box<Dim> there{box.low - shift, box.high - shift};
    if (before_.empty() || near_interface(*now_[body].atlas, now_[body].frame, there) ||
        near_interface(*before_[body].atlas, before_[body].frame, there))
      return true;
  }
  return false;
}

template <int Dim>
double Overlap<Dim>::edge_distance(const Point<Dim>& x) const {
  double distance = 1e300;
  for (int d = 0; d < Dim; ++d)
    if (!periodic_[static_cast<std::size_t>(d)]) distance = std::min({distance, x[d] - domain_.low[d], domain_.high[d] - x[d]});
  return distance;
}

/// Distance of x from a body; reaches(): whether it is within what the body's grid can take a share in.
template <int Dim>
double Overlap<Dim>::distance(std::size_t body, const Point<Dim>& x) const {
  return bodies_[body].atlas->distance(frames_[body].to_body(periods_.near(x, reaches_[body])));
}

template <int Dim>
bool Overlap<Dim>::reaches(std::size_t body, const Point<Dim>& x) const {
  return reaches_[body].contains(periods_.near(x, reaches_[body]));
}

template <int Dim>
bool Overlap<Dim>::covers_background(const OverlapBody<Dim>& body, double distance, double edge) const {
  return distance <= 0 || (distance < inner_reach(body) && edge > distance + options_.margin * body.spacing);
}

template <int Dim>
bool Overlap<Dim>::wanted_by_background(const Point<Dim>& x) const {
  const double edge = edge_distance(x);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (reaches(b, x) && covers_background(bodies_[b], distance(b, x), edge)) return false;
  return edge > 0;
}

template <int Dim>
bool Overlap<Dim>::wanted_by_body(int body, double own_distance, const Point<Dim>& x) const {
  const double limit = own_distance - options_.margin * bodies_[static_cast<std::size_t>(body)].spacing;
  const double edge = edge_distance(x);
  if (edge <= 0 || limit > edge) return false;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (static_cast<int>(b) == body || !reaches(b, x)) continue;
    const double from_it = distance(b, x);
    if (from_it <= 0 || limit > from_it) return false;
  }
  return true;
}

/// Background cells closer to the body than this are holes or fringe.
template <int Dim>
double Overlap<Dim>::inner_reach(const OverlapBody<Dim>& body) const {
  return (body.layers - 2 - options_.overlap) * body.spacing;
}

/// Remembers the tile's cells as they were and marks all of them, ghosts included.
template <int Dim>
void Overlap<Dim>::begin_cut(int grid, int tile, std::uint8_t active) {
  const ComponentGrid<Dim>& of = grids_[static_cast<std::size_t>(grid)];
  TileMask& mask = grids_[static_cast<std::size_t>(grid)].masks[static_cast<std::size_t>(tile)];
  mask.active.assign(of.shape.plane, active);
  mask.state.assign(of.shape.plane, CellState::active);
}

template <int Dim>
void Overlap<Dim>::cut_background(int g, bool fresh) {
  ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    const Box<Dim> box = grid.box(t).grown(4 * grid.spacing.maxCoeff());
    bool touched = false;
    for (std::size_t b = 0; b < bodies_.size() && !touched; ++b) touched = touches(b, box);
    if (!touched) continue;
    TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
    TileOverlap& tile = tile_of(g, t);
    tile.recut = true;
    tile.active_before.swap(mask.active);
    tile.state_before.swap(mask.state);
    mask.active.clear();
    mask.state.clear();
    mask.hole = false;
    mask.active_count = grid.shape.count();
    Index<Dim> low = grid.shape.cells, high{};  // region with inactive cells
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      for (const Point<Dim>& shift : periods_.images(reaches_[b], box)) cut_by_body(g, t, b, shift, low, high);
    if (fresh) tile.active_before = mask.active, tile.state_before.clear();
    std::swap(tile.low, low);
    std::swap(tile.high, high);
    for (std::size_t d = 0; d < Dim; ++d) {  // cells that were cut before may be exposed now
      low[d] = std::min(low[d], tile.low[d]);
      high[d] = std::max(high[d], tile.high[d]);
    }
    mark_fringe(g, t, low, high);
  }
}

/// Takes from a background tile what a body, or its image by `shift`, covers; widens [low, high) to the cells concerned.
template <int Dim>
void Overlap<Dim>::cut_by_body(int g, int t, std::size_t b, const Point<Dim>& shift, Index<Dim>& low, Index<Dim>& high) {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  const OverlapBody<Dim>& body = bodies_[b];
  const Box<Dim> covered = body.atlas->reach().grown(inner_reach(body) - (body.atlas->width() + 5 * body.spacing));  // body frame
  Box<Dim> in_space = frames_[b].to_space(covered);
  in_space.low += shift;
  in_space.high += shift;
  const Index<Dim> first = grid.first_cell(t);
  Index<Dim> from, to;
  for (std::size_t d = 0; d < Dim; ++d) {
    const int k = static_cast<int>(d);
    const auto cell_at = [&](double x) {  // x may be infinite
      const double cell = std::floor((x - grid.origin[k]) / grid.spacing[k]) - first[d];
      return static_cast<int>(std::clamp<double>(cell, -grid.shape.ghosts, grid.shape.cells[d] + grid.shape.ghosts));
    };
    from[d] = cell_at(in_space.low[k]);
    to[d] = std::min(cell_at(in_space.high[k]) + 1, grid.shape.cells[d] + grid.shape.ghosts);
    if (from[d] >= to[d]) return;
  }
  TileMask& mask = grids_[static_cast<std::size_t>(g)].masks[static_cast<std::size_t>(t)];
  if (mask.active.empty()) begin_cut(g, t, 1);
  for (std::size_t d = 0; d < Dim; ++d) {
    low[d] = std::min(low[d], from[d]);
    high[d] = std::max(high[d], to[d]);
  }
  const double reach = inner_reach(body);
  Index<Dim> row_end = to;
  row_end[0] = from[0] + 1;
  for_each_index<Dim>(from, row_end, [&](Index<Dim> c) {
    Index<Dim> global = c;
    for (std::size_t d = 0; d < Dim; ++d) global[d] += first[d];
    const Point<Dim> X0 = frames_[b].to_body(grid.center(global) - shift);
    ++global[0];
    const Point<Dim> step = frames_[b].to_body(grid.center(global) - shift) - X0;
    double begin = 0, end = to[0] - from[0] - 1;  // part of the row within `covered`
    for (int d = 0; d < Dim; ++d) {
      if (std::fabs(step[d]) < 1e-12 * body.spacing) continue;
      const double a = (covered.low[d] - X0[d]) / step[d], z = (covered.high[d] - X0[d]) / step[d];
      begin = std::max(begin, std::min(a, z));
      end = std::min(end, std::max(a, z));
    }
    if (begin > end) return;
    for (int i = static_cast<int>(std::ceil(begin)); i <= static_cast<int>(std::floor(end)); ++i) {
      c[0] = from[0] + i;
      global[0] = first[0] + c[0];
      const Point<Dim> x = grid.center(global);
      const double from_body = body.atlas->distance(frames_[b].to_body(x - shift));
      if (from_body <= 0 || (from_body < reach && covers_background(body, from_body, edge_distance(x)))) mask.active[grid.shape.at(c)] = 0;
    }
  });
}

template <int Dim>
void Overlap<Dim>::cut_body_grid(int g, bool fresh) {
  ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  const auto body = static_cast<std::size_t>(grid.body);
  if (touched_[body].low[0] > touched_[body].high[0]) return;
  Box<Dim> room = domain_.grown(0);
  for (int d = 0; d < Dim; ++d)
    if (periodic_[static_cast<std::size_t>(d)]) room.low[d] = -1e300, room.high[d] = 1e300;
  const auto surroundings = [&](std::size_t b) {  // a grid's own cells, and as far as it can cut another's
    return frames_[b].to_space(vicinity(*bodies_[b].atlas).grown(-5 * bodies_[b].spacing));
  };
  const Box<Dim> own = surroundings(body).grown(bodies_[body].atlas->width());  // the edge of the domain cuts as a body does
  bool alone = room.contains(own.low) && room.contains(own.high);
  for (std::size_t b = 0; b < bodies_.size(); ++b) alone = alone && (b == body || periods_.images(surroundings(b), surroundings(body)).empty());
  for (int t = 0; t < grid.forest.local_count(); ++t) {
    TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
    TileOverlap& tile = tile_of(g, t);
    tile.recut = true;
    if (alone && tile.alone && tile.exposed == 0 && !fresh) {  // as before: the same mask, other donors
      tile.active_before = mask.active;
      tile.state_before = mask.state;
      tile.exposed = 0;
      continue;
    }
    tile.alone = alone;
    tile.active_before.swap(mask.active);
    tile.state_before.swap(mask.state);
    begin_cut(g, t, 0);
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
      const auto of_grid = static_cast<std::size_t>(g);
      const bool wanted =
          alone || wanted_by_body(grid.body, own_distances_[of_grid][index], frames_[body].to_space(body_centers_[of_grid][index]));
      mask.active[grid.shape.at(c)] = wanted ? 1 : 0;
    });
    if (fresh) tile.active_before = mask.active, tile.state_before.clear();
    mark_fringe(g, t, Index<Dim>{}, grid.shape.cells);
  }
}

/// state = active, fringe where the stencil |di| + |dj| ≤ 2 of an active cell reaches, hole elsewhere. Cells outside [low, high)
/// are active.
template <int Dim>
void Overlap<Dim>::mark_fringe(int g, int t, Index<Dim> low, Index<Dim> high) {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  TileMask& mask = grids_[static_cast<std::size_t>(g)].masks[static_cast<std::size_t>(t)];
  for (std::size_t d = 0; d < Dim; ++d) {
    low[d] = std::max(low[d], 0);
    high[d] = std::min(high[d], grid.shape.cells[d]);
  }
  int inactive = 0, holes = 0;
  if (!mask.active.empty()) {
    const std::ptrdiff_t s = grid.shape.stride;
    for (int j = Dim == 2 ? low[Dim - 1] : 0; j < (Dim == 2 ? high[Dim - 1] : 1); ++j) {
      const std::uint8_t* a = mask.active.data() + grid.shape.at(0, j);
      CellState* state = mask.state.data() + grid.shape.at(0, j);
      for (int i = low[0]; i < high[0]; ++i) {
        unsigned reached = a[i - 2] | a[i - 1] | a[i + 1] | a[i + 2];
        if constexpr (Dim == 2)
          reached |= unsigned(a[i - s - 1] | a[i - s] | a[i - s + 1] | a[i + s - 1] | a[i + s] | a[i + s + 1] | a[i - 2 * s] | a[i + 2 * s]);
        state[i] = a[i] ? CellState::active : reached ? CellState::fringe : CellState::hole;
        inactive += !a[i];
        holes += state[i] == CellState::hole;
      }
    }
  }
  mask.active_count = grid.shape.count() - inactive;
  mask.hole = holes == grid.shape.count();
  if (inactive == 0 && std::count(mask.active.begin(), mask.active.end(), 0) == 0) mask.active.clear(), mask.state.clear();
  collect_receivers(g, t, low, high);
}

/// Fringe and exposed cells, and new holes, among [low, high).
template <int Dim>
void Overlap<Dim>::collect_receivers(int g, int t, const Index<Dim>& low, const Index<Dim>& high) {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  TileMask& mask = grids_[static_cast<std::size_t>(g)].masks[static_cast<std::size_t>(t)];
  TileOverlap& tile = tile_of(g, t);
  tile.receivers.clear();
  tile.exposed = 0;
  if (!mask.cut() && tile.active_before.empty()) return;
  const bool cut_before = !tile.state_before.empty();
  for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
    const std::size_t k = grid.shape.at(c);
    const CellState state = mask.cut() ? mask.state[k] : CellState::active;
    const bool exposed = state == CellState::active && !tile.active_before.empty() && !tile.active_before[k];
    if (state == CellState::fringe || exposed) tile.receivers.push_back(k);
    tile.exposed += exposed;
    if (state == CellState::hole && !(cut_before && tile.state_before[k] == CellState::hole)) mask.new_holes.push_back(k);
  });
}

template <int Dim>
void Overlap<Dim>::count() {
  std::int64_t exposed = 0, tight = 0;
  for (const std::vector<TileOverlap>& of_grid : tiles_)
    for (const TileOverlap& tile : of_grid) {
      exposed += tile.exposed;
      tight += tile.tight;
    }
  report_.exposed = comm_.sum(exposed);
  report_.tight = comm_.sum(tight + report_.tight);
  report_.orphans = comm_.sum(report_.orphans);
}

template <int Dim>
OverlapReport Overlap<Dim>::census() const {
  OverlapReport report = report_;
  for (const ComponentGrid<Dim>& grid : grids_)
    for (const TileMask& mask : grid.masks) {
      if (!mask.cut()) continue;
      for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
        report.fringe += mask.state[grid.shape.at(c)] == CellState::fringe;
        report.holes += mask.state[grid.shape.at(c)] == CellState::hole;
      });
    }
  report.fringe = comm_.sum(report.fringe);
  report.holes = comm_.sum(report.holes);
  return report;
}

template <int Dim>
double Overlap<Dim>::share(int grid, const Point<Dim>& x) const {
  // 1 on a body's grid near the wall, falling smoothly to 0 across the overlap; the background takes the rest.
  double background = 1, own = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!reaches(b, x)) continue;
    const double outer = (bodies_[b].layers - 2) * bodies_[b].spacing;
    const double s = std::clamp((outer - distance(b, x)) / (std::max(options_.overlap, 0.5) * bodies_[b].spacing), 0.0, 1.0);
    const double weight = s * s * (3 - 2 * s);
    background *= 1 - weight;
    if (static_cast<int>(b) == grids_[static_cast<std::size_t>(grid)].body) own = weight;
  }
  return grids_[static_cast<std::size_t>(grid)].background() ? background : own;
}

template class Overlap<1>;
template class Overlap<2>;

}  // namespace mortise
