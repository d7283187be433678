// Donors: where fringe and exposed cells take their values from.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mortise/grids/overlap/overlap.hpp"

namespace mortise {
namespace {

/// Middle of the stencil around X and X's offset from it, on the grid on one side of a body. tight: points a little
/// inside the body count as on the wall row.
bool locate_in(const BodyAtlas& atlas, int, const Point<2>& X, bool tight, Index<2>& center, std::array<double, 2>& offset) {
  StencilPoint where;
  if (!(tight ? atlas.locate_clamped(X, where) : atlas.locate(X, where))) return false;
  center = where.center;
  offset = {where.offset[0], where.offset[1]};
  return true;
}

bool locate_in(const LineAtlas& atlas, int side, const Point<1>& X, bool tight, Index<1>& center, std::array<double, 1>& offset) {
  Point<1> logical;
  if (!atlas.locate(X, side, logical) && !tight) return false;
  logical[0] = std::clamp(logical[0], 0.0, atlas.layers() - 1.0);
  center[0] = std::clamp(static_cast<int>(std::lround(logical[0])), 1, atlas.layers() - 2);
  offset[0] = logical[0] - center[0];
  return true;
}

/// Offset of the point at `place` from the middle of another stencil, where `offset` is nearly right: what makes
/// extrapolation of linear functions exact.
void refine(const BodyAtlas& atlas, const Index<2>& center, const std::array<double, 2>& place, std::array<double, 2>& offset) {
  StencilPoint where{center, {offset[0], offset[1]}};
  if (atlas.locate_on({place[0], place[1]}, where)) offset = {where.offset[0], where.offset[1]};
}
void refine(const LineAtlas&, const Index<1>&, const std::array<double, 1>&, std::array<double, 1>&) {}

/// All shifts with entries −range … range, those closest to the point at `offset` first: no direction is preferred.
template <int Dim>
std::vector<Index<Dim>> nearest_first(int range, const std::array<double, Dim>& offset) {
  std::vector<Index<Dim>> shifts;
  Index<Dim> low, high;
  low.fill(-range);
  high.fill(range + 1);
  for_each_index<Dim>(low, high, [&](const Index<Dim>& c) { shifts.push_back(c); });
  const auto distance2 = [&](const Index<Dim>& c) {
    double sum = 0;
    for (std::size_t d = 0; d < Dim; ++d) sum += (c[d] - offset[d]) * (c[d] - offset[d]);
    return sum;
  };
  std::stable_sort(shifts.begin(), shifts.end(), [&](const Index<Dim>& a, const Index<Dim>& b) { return distance2(a) < distance2(b); });
  return shifts;
}

}  // namespace

template <int Dim>
Point<Dim> Overlap<Dim>::position(const Receiver& receiver) const {
  const auto g = static_cast<std::size_t>(receiver.grid);
  const ComponentGrid<Dim>& grid = grids_[g];
  Index<Dim> cell = grid.first_cell(receiver.tile);
  const int offset = static_cast<int>(receiver.cell);
  cell[0] += offset % grid.shape.stride - grid.shape.slack;
  if constexpr (Dim == 2) cell[1] += offset / grid.shape.stride - grid.shape.ghosts;
  if (grid.background()) return grid.center(cell);
  std::size_t index = static_cast<std::size_t>(cell[0]);
  if constexpr (Dim == 2) index += static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(grid.cells[0]);
  return frames_[static_cast<std::size_t>(grid.body)].to_space(body_centers_[g][index]);
}

template <int Dim>
int Overlap<Dim>::component(int body, const Point<Dim>& X) const {
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    if (grids_[g].body != body) continue;
    if constexpr (Dim == 1) {
      const LineAtlas& atlas = *bodies_[static_cast<std::size_t>(body)].atlas;
      const int side = X[0] - atlas.right() > atlas.left() - X[0] ? 1 : -1;
      if (grids_[g].side != side) continue;
    }
    return static_cast<int>(g);
  }
  return -1;
}

/// Grids that may hold a donor for x, the preferred first; `own_grid` itself is none of them (−1: all grids count).
template <int Dim>
void Overlap<Dim>::list_choices(int own_grid, const Point<Dim>& x, std::vector<Choice>& choices) const {
  const int own_body = own_grid < 0 ? -1 : grids_[static_cast<std::size_t>(own_grid)].body;
  const bool own_background = own_grid >= 0 && own_body < 0;
  choices.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (static_cast<int>(b) != own_body && reaches(b, x)) choices.push_back({static_cast<int>(b), false});
  const std::size_t near = choices.size();
  bool inside_a_body = false;
  if (near > 1) {  // nearest body first
    const auto from_it = [&](const Choice& c) { return distance(static_cast<std::size_t>(c.body), x); };
    std::stable_sort(choices.begin(), choices.end(), [&](const Choice& a, const Choice& b) { return from_it(a) < from_it(b); });
    inside_a_body = from_it(choices.front()) <= 0;
  }
  const std::vector<Choice> bodies = near > 1 ? choices : std::vector<Choice>{};
  if (inside_a_body) choices.clear();
  if (!own_background) {
    const bool first = near == 0 || wanted_by_background(x);
    choices.insert(first ? choices.begin() : choices.end(), Choice{});
  }
  if (own_grid < 0) return;
  if (near == 1) choices.push_back({own_background || choices.front().body >= 0 ? choices.front().body : choices.back().body, true});
  for (const Choice& body : bodies) choices.push_back({body.body, true});
  if (!own_background) choices.push_back({-1, true});
}

template <int Dim>
bool Overlap<Dim>::locate(const Choice& choice, const Point<Dim>& x, Candidate& found) const {
  found.tight = choice.tight;
  if (choice.body < 0) {
    found.grid = 0;
    return on_background(x, found);
  }
  const auto b = static_cast<std::size_t>(choice.body);
  const Point<Dim> X = frames_[b].to_body(periods_.near(x, reaches_[b]));
  for (std::size_t d = 0; d < Dim; ++d) found.place[d] = X[static_cast<int>(d)];
  found.grid = component(choice.body, X);
  return found.grid >= 0 && locate_in(*bodies_[b].atlas, grids_[static_cast<std::size_t>(found.grid)].side, X, choice.tight, found.center, found.offset);
}

/// Active now and before: a cell that holds a value of the present time.
template <int Dim>
bool Overlap<Dim>::usable(int g, int tile, std::size_t cell) const {
  const TileMask& mask = grids_[static_cast<std::size_t>(g)].masks[static_cast<std::size_t>(tile)];
  const std::vector<std::uint8_t>& before = tile_of(g, tile).active_before;
  return (mask.active.empty() || mask.active[cell]) && (before.empty() || before[cell]);
}

template <int Dim>
bool Overlap<Dim>::stencil_valid(int g, int tile, const Index<Dim>& center) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(g)];
  const Index<Dim> first = grid.first_cell(tile);
  bool valid = true;
  Index<Dim> low = center, high = center;
  for (std::size_t d = 0; d < Dim; ++d) {
    low[d] -= 1;
    high[d] += 2;
    if (!grid.periodic[d] && (low[d] + first[d] < 0 || high[d] + first[d] > grid.cells[d])) return false;
  }
  for_each_index<Dim>(low, high, [&](const Index<Dim>& c) {
    valid = valid && usable(g, tile, grid.shape.at(c));
  });
  return valid;
}

/// The cell of the background around x; false outside it, or the nearest cell where a donor of lower order will do.
template <int Dim>
bool Overlap<Dim>::on_background(const Point<Dim>& x, Candidate& found) const {
  const ComponentGrid<Dim>& grid = grids_.front();
  for (std::size_t d = 0; d < Dim; ++d) {
    const int k = static_cast<int>(d), n = grid.cells[d];
    double logical = (x[k] - grid.origin[k]) / grid.spacing[k] - 0.5;
    if (grid.periodic[d]) logical -= n * std::floor((logical + 0.5) / n);
    if (!found.tight && (logical < -0.5 || logical > n - 0.5)) return false;
    if (!grid.periodic[d]) logical = std::clamp(logical, -0.5, n - 0.5);
    found.center[d] = std::clamp(static_cast<int>(std::lround(logical)), 0, n - 1);
    found.offset[d] = logical - found.center[d];
  }
  return true;
}

/// The tile that holds the middle of a candidate's stencil.
template <int Dim>
Neighbor Overlap<Dim>::owner(const Candidate& candidate) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(candidate.grid)];
  Index<Dim> tile;
  for (std::size_t d = 0; d < Dim; ++d) tile[d] = candidate.center[d] / grid.shape.cells[d];
  return grid.forest.find(tile);
}

template <int Dim>
bool Overlap<Dim>::accept(const Candidate& request, Donor<Dim>& donor) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(request.grid)];
  const Neighbor at = owner(request);
  if (at.rank != comm_.rank()) return false;
  Index<Dim> middle = request.center;
  for (std::size_t d = 0; d < Dim; ++d) middle[d] %= grid.shape.cells[d];
  donor.grid = request.grid;
  donor.tile = at.local;
  const auto accept_shifted = [&](const Index<Dim>& shift) {
    Index<Dim> center = middle;
    for (std::size_t d = 0; d < Dim; ++d) center[d] += shift[d];
    if (!stencil_valid(request.grid, at.local, center)) return false;
    donor.center = grid.shape.at(center);
    std::array<double, Dim> offset = request.offset;
    for (std::size_t d = 0; d < Dim; ++d) offset[d] -= shift[d];
    if (shift != Index<Dim>{} && !grid.background() && !request.tight && !options_.clip) {
      Index<Dim> on_grid = request.center;
      for (std::size_t d = 0; d < Dim; ++d) {
        on_grid[d] += shift[d];
        if (grid.periodic[d]) on_grid[d] = (on_grid[d] + grid.cells[d]) % grid.cells[d];
      }
      refine(*bodies_[static_cast<std::size_t>(grid.body)].atlas, on_grid, request.place, offset);
    }
    for (std::size_t d = 0; d < Dim; ++d) donor.weights[d] = quadratic_weights(offset[d]);
    return true;
  };
  if (accept_shifted(Index<Dim>{})) return true;
  for (const Index<Dim>& shift : nearest_first<Dim>(1, request.offset))
    if (accept_shifted(shift)) return true;
  return request.tight && accept_reduced(request, at.local, middle, donor);
}

/// For pockets where no stencil of nine fits: the value of the nearest usable cell. First-order, counted as tight.
template <int Dim>
bool Overlap<Dim>::accept_reduced(const Candidate& request, int tile, const Index<Dim>& middle, Donor<Dim>& donor) const {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(request.grid)];
  const Index<Dim> first = grid.first_cell(tile);
  for (const Index<Dim>& shift : nearest_first<Dim>(2, request.offset)) {
    Index<Dim> cell = middle;
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      cell[d] += shift[d];
      inside = inside && cell[d] >= 1 - grid.shape.ghosts && cell[d] < grid.shape.cells[d] + grid.shape.ghosts - 1;
      inside = inside && (grid.periodic[d] || (cell[d] + first[d] >= 0 && cell[d] + first[d] < grid.cells[d]));
    }
    if (!inside || !usable(request.grid, tile, grid.shape.at(cell))) continue;
    donor.center = grid.shape.at(cell);
    for (std::size_t d = 0; d < Dim; ++d) donor.weights[d] = {0, 1, 0};
    return true;
  }
  return false;
}

/// Goes through the choices from `next` on as long as they are on this rank. True: a donor was found and linked. False: the choice
/// `next` is on another rank, or there are no more.
template <int Dim>
bool Overlap<Dim>::try_local(const Receiver& receiver, const Point<Dim>& x, const std::vector<Choice>& choices, std::size_t& next) {
  for (; next < choices.size(); ++next) {
    Candidate candidate;
    if (!locate(choices[next], x, candidate)) continue;
    if (owner(candidate).rank != comm_.rank()) return false;
    Donor<Dim> donor;
    if (!accept(candidate, donor)) continue;
    TileOverlap& tile = tile_of(receiver.grid, receiver.tile);
    tile.links.push_back({receiver.cell, donor});
    tile.tight += candidate.tight;
    return true;
  }
  return false;
}

template <int Dim>
void Overlap<Dim>::find_donors() {
  report_.tight = report_.orphans = 0;  // of receivers served by other ranks; count() adds the others
  std::vector<Receiver> open;
  std::vector<std::vector<Choice>> open_choices;
  std::vector<std::size_t> open_next;
  std::vector<Choice> choices;
  for (std::size_t g = 0; g < grids_.size(); ++g)
    for (std::size_t t = 0; t < tiles_[g].size(); ++t) {
      TileOverlap& tile = tiles_[g][t];
      if (!tile.recut) continue;
      tile.links.clear();
      tile.tight = 0;
      for (const std::size_t cell : tile.receivers) {
        const Receiver receiver{static_cast<int>(g), static_cast<int>(t), cell};
        const Point<Dim> x = position(receiver);
        list_choices(receiver.grid, x, choices);
        std::size_t next = 0;
        if (try_local(receiver, x, choices, next)) continue;
        open.push_back(receiver);
        open_choices.push_back(choices);
        open_next.push_back(next);
      }
    }
  find_remote_donors(std::move(open), std::move(open_choices), std::move(open_next));
  list_donor_tiles();
}

template <int Dim>
void Overlap<Dim>::list_donor_tiles() {
  std::vector<std::vector<std::uint8_t>> gives;
  for (const std::vector<TileOverlap>& of_grid : tiles_) gives.emplace_back(of_grid.size(), std::uint8_t{0});
  const auto note = [&](const Donor<Dim>& donor) { gives[static_cast<std::size_t>(donor.grid)][static_cast<std::size_t>(donor.tile)] = 1; };
  for (const std::vector<TileOverlap>& of_grid : tiles_)
    for (const TileOverlap& tile : of_grid)
      for (const Link& link : tile.links) note(link.donor);
  for (const std::vector<Donor<Dim>>& of_rank : donors_)
    for (const Donor<Dim>& donor : of_rank) note(donor);
  donor_tiles_.assign(grids_.size(), {});
  for (std::size_t g = 0; g < gives.size(); ++g)
    for (std::size_t t = 0; t < gives[g].size(); ++t)
      if (gives[g][t]) donor_tiles_[g].push_back(static_cast<int>(t));
}

/// The rest by rounds of questions to the ranks that hold the choices, each receiver in the order of its choices, so that
/// the donors are those a single rank would find.
template <int Dim>
void Overlap<Dim>::find_remote_donors(std::vector<Receiver> open, std::vector<std::vector<Choice>> choices, std::vector<std::size_t> next) {
  const auto ranks = static_cast<std::size_t>(comm_.size());
  remote_receivers_.clear();
  accepted_.assign(ranks, {});
  donors_.assign(ranks, {});
  std::vector<std::size_t> waiting(open.size());
  for (std::size_t k = 0; k < open.size(); ++k) waiting[k] = k;
  while (comm_.any(!waiting.empty())) {
    std::vector<std::vector<Candidate>> requests(ranks);
    std::vector<std::vector<std::size_t>> asked(ranks);
    for (const std::size_t k : waiting) {
      const Point<Dim> x = position(open[k]);
      if (try_local(open[k], x, choices[k], next[k])) continue;
      if (next[k] == choices[k].size()) {
        ++report_.orphans;
        describe_orphan(open[k]);
        continue;
      }
      Candidate candidate;
      locate(choices[k][next[k]], x, candidate);
      const auto rank = static_cast<std::size_t>(owner(candidate).rank);
      requests[rank].push_back(candidate);
      asked[rank].push_back(k);
    }
    waiting.clear();
    const std::vector<std::vector<Candidate>> incoming = comm_.exchange(requests);
    std::vector<std::vector<std::uint8_t>> answers(ranks);
    for (std::size_t rank = 0; rank < ranks; ++rank)
      for (const Candidate& request : incoming[rank]) {
        Donor<Dim> donor;
        answers[rank].push_back(accept(request, donor) ? 1 : 0);
        if (answers[rank].back()) donors_[rank].push_back(donor);
      }
    const std::vector<std::vector<std::uint8_t>> replies = comm_.exchange(answers);
    for (std::size_t rank = 0; rank < ranks; ++rank)
      for (std::size_t q = 0; q < asked[rank].size(); ++q) {
        const std::size_t k = asked[rank][q];
        if (!replies[rank][q]) {
          ++next[k];
          waiting.push_back(k);
          continue;
        }
        report_.tight += choices[k][next[k]].tight;
        accepted_[rank].push_back(static_cast<int>(remote_receivers_.size()));
        remote_receivers_.push_back(open[k]);
      }
  }
}

template <int Dim>
void Overlap<Dim>::describe_orphan(const Receiver& receiver) {
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(receiver.grid)];
  std::ostringstream text;
  const Index<Dim> first = grid.first_cell(receiver.tile);
  text << "grid " << grid.name << ", cell (" << first[0] + static_cast<int>(receiver.cell) % grid.shape.stride - grid.shape.slack;
  if constexpr (Dim == 2) text << ", " << first[1] + static_cast<int>(receiver.cell) / grid.shape.stride - grid.shape.ghosts;
  text << ") at (" << position(receiver).transpose() << ")";
  report_.first_orphan = text.str();
}

template class Overlap<1>;
template class Overlap<2>;

}  // namespace mortise
