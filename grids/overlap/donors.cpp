// Donors: where fringe and exposed cells take their values from.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "mortise/grids/overlap/overlap.hpp"

namespace mortise {
namespace {

/// Middle of the stencil around X and X's offset from it, on the grid on one side of a body. tight: points a little
/// inside the body count as on the wall row.
bool locate(const BodyAtlas& atlas, int, const Point<2>& X, bool tight, Index<2>& center, std::array<double, 2>& offset) {
  StencilPoint where;
  if (!(tight ? atlas.locate_clamped(X, where) : atlas.locate(X, where))) return false;
  center = where.center;
  offset = {where.offset[0], where.offset[1]};
  return true;
}

bool locate(const LineAtlas& atlas, int side, const Point<1>& X, bool tight, Index<1>& center, std::array<double, 1>& offset) {
  Point<1> logical;
  if (!atlas.locate(X, side, logical) && !tight) return false;
  logical[0] = std::clamp(logical[0], 0.0, atlas.layers() - 1.0);
  center[0] = std::clamp(static_cast<int>(std::lround(logical[0])), 1, atlas.layers() - 2);
  offset[0] = logical[0] - center[0];
  return true;
}

/// All offsets with entries −range … range, the nearest first.
template <int Dim>
std::vector<Index<Dim>> nearest_first(int range) {
  std::vector<Index<Dim>> offsets;
  Index<Dim> low, high;
  low.fill(-range);
  high.fill(range + 1);
  for_each_index<Dim>(low, high, [&](const Index<Dim>& c) { offsets.push_back(c); });
  const auto length = [](const Index<Dim>& c) {
    int sum = 0;
    for (const int k : c) sum += k * k;
    return sum;
  };
  std::stable_sort(offsets.begin(), offsets.end(), [&](const Index<Dim>& a, const Index<Dim>& b) { return length(a) < length(b); });
  return offsets;
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
void Overlap<Dim>::collect_receivers() {
  receivers_.clear();
  for (std::size_t g = 0; g < grids_.size(); ++g) {
    const ComponentGrid<Dim>& grid = grids_[g];
    for (std::size_t t = 0; t < grid.masks.size(); ++t) {
      const TileMask& mask = grid.masks[t];
      const std::vector<std::uint8_t>& before = previous_[g][t];
      if (!mask.cut() && before.empty()) continue;
      for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
        const std::size_t k = grid.shape.at(c);
        const CellState state = mask.cut() ? mask.state[k] : CellState::active;
        const bool exposed = state == CellState::active && !before.empty() && !before[k];
        if (state == CellState::fringe || exposed) receivers_.push_back({static_cast<int>(g), static_cast<int>(t), k, exposed});
      });
    }
  }
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

template <int Dim>
std::vector<typename Overlap<Dim>::Candidate> Overlap<Dim>::candidates(int own_grid, const Point<Dim>& x) const {
  const int own_body = own_grid < 0 ? -1 : grids_[static_cast<std::size_t>(own_grid)].body;
  std::vector<std::pair<double, int>> near;  // (distance, body)
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (static_cast<int>(b) != own_body && reaches_[b].contains(x))
      near.emplace_back(bodies_[b].atlas->distance(frames_[b].to_body(x)), static_cast<int>(b));
  std::sort(near.begin(), near.end());

  std::vector<Candidate> found;
  const auto add_background = [&](bool tight) {
    if (own_grid >= 0 && grids_[static_cast<std::size_t>(own_grid)].background()) return;
    Candidate candidate{.center = {}, .offset = {}, .grid = 0, .tight = tight};
    if (on_background(x, candidate)) found.push_back(candidate);
  };
  const auto add_bodies = [&](bool tight) {
    for (const auto& [distance, b] : near) {
      const Point<Dim> X = frames_[static_cast<std::size_t>(b)].to_body(x);
      const Atlas<Dim>& atlas = *bodies_[static_cast<std::size_t>(b)].atlas;
      const int g = component(b, X);
      if (g < 0 || distance > bodies_[static_cast<std::size_t>(b)].layers * bodies_[static_cast<std::size_t>(b)].spacing) continue;
      const int side = grids_[static_cast<std::size_t>(g)].side;
      Candidate candidate{.center = {}, .offset = {}, .grid = g, .tight = tight};
      if (locate(atlas, side, X, tight, candidate.center, candidate.offset)) found.push_back(candidate);
    }
  };
  const bool background_first = own_grid != 0 && (near.empty() || wanted_by_background(x));
  const bool inside_a_body = !near.empty() && near.front().first <= 0;
  if (background_first) add_background(false);
  if (!inside_a_body) add_bodies(false);
  if (!background_first) add_background(false);
  if (own_grid >= 0) {
    add_bodies(true);
    add_background(true);
  }
  return found;
}

/// Active now and before: a cell that holds a value of the present time.
template <int Dim>
bool Overlap<Dim>::usable(int g, int tile, std::size_t cell) const {
  const TileMask& mask = grids_[static_cast<std::size_t>(g)].masks[static_cast<std::size_t>(tile)];
  const std::vector<std::uint8_t>& before = previous_[static_cast<std::size_t>(g)][static_cast<std::size_t>(tile)];
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
  static const std::vector<Index<Dim>> shifts = nearest_first<Dim>(1);
  for (const Index<Dim>& shift : shifts) {
    Index<Dim> center = middle;
    for (std::size_t d = 0; d < Dim; ++d) center[d] += shift[d];
    if (!stencil_valid(request.grid, at.local, center)) continue;
    donor.center = grid.shape.at(center);
    for (std::size_t d = 0; d < Dim; ++d) donor.weights[d] = quadratic_weights(request.offset[d] - shift[d]);
    return true;
  }
  return request.tight && accept_reduced(request, at.local, middle, donor);
}

/// For pockets where no stencil of nine fits: the value of the nearest usable cell. First-order, counted as tight.
template <int Dim>
bool Overlap<Dim>::accept_reduced(const Candidate& request, int tile, const Index<Dim>& middle, Donor<Dim>& donor) const {
  static const std::vector<Index<Dim>> shifts = nearest_first<Dim>(2);
  const ComponentGrid<Dim>& grid = grids_[static_cast<std::size_t>(request.grid)];
  const Index<Dim> first = grid.first_cell(tile);
  for (const Index<Dim>& shift : shifts) {
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

template <int Dim>
void Overlap<Dim>::find_donors() {
  const auto ranks = static_cast<std::size_t>(comm_.size());
  accepted_.assign(ranks, {});
  donors_.assign(ranks, {});
  report_.tight = report_.orphans = 0;
  std::vector<std::vector<Candidate>> choices;
  std::vector<int> open(receivers_.size());
  choices.reserve(receivers_.size());
  for (std::size_t r = 0; r < receivers_.size(); ++r) {
    open[r] = static_cast<int>(r);
    choices.push_back(candidates(receivers_[r].grid, position(receivers_[r])));
  }
  for (std::size_t round = 0; comm_.any(!open.empty()); ++round) {
    std::vector<std::vector<Candidate>> requests(ranks);
    std::vector<std::vector<int>> asked(ranks);
    std::vector<int> orphaned;
    for (const int r : open) {
      const std::vector<Candidate>& list = choices[static_cast<std::size_t>(r)];
      if (round >= list.size()) {
        orphaned.push_back(r);
        continue;
      }
      const Candidate& candidate = list[round];
      const int rank = owner(candidate).rank;
      requests[static_cast<std::size_t>(rank)].push_back(candidate);
      asked[static_cast<std::size_t>(rank)].push_back(r);
    }
    report_.orphans += static_cast<std::int64_t>(orphaned.size());
    if (!orphaned.empty()) describe_orphan(receivers_[static_cast<std::size_t>(orphaned.front())]);

    const std::vector<std::vector<Candidate>> incoming = comm_.exchange(requests);
    std::vector<std::vector<std::uint8_t>> answers(ranks);
    for (std::size_t rank = 0; rank < ranks; ++rank)
      for (const Candidate& request : incoming[rank]) {
        Donor<Dim> donor;
        const bool good = accept(request, donor);
        answers[rank].push_back(good ? 1 : 0);
        if (good) donors_[rank].push_back(donor);
      }
    const std::vector<std::vector<std::uint8_t>> replies = comm_.exchange(answers);
    open.clear();
    for (std::size_t rank = 0; rank < ranks; ++rank)
      for (std::size_t k = 0; k < asked[rank].size(); ++k) {
        const int r = asked[rank][k];
        if (!replies[rank][k]) {
          open.push_back(r);
          continue;
        }
        accepted_[rank].push_back(r);
        report_.tight += choices[static_cast<std::size_t>(r)][round].tight;
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
