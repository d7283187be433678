#include "mortise/coupler/reference_map/body_map.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/coupler/reference_map/map_branches.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

constexpr std::array<double, BodyMap::components> nothing = {0, 0, 1e30, BodyMap::unknown};

constexpr double replaced = 98;  // in place of a layer: holds ξ that is to be replaced

Field<2> empty_field(const ComponentGrid<2>& grid) {
  return Field<2>::unallocated(grid.shape, BodyMap::components, grid.forest.local_count());
}

void clear_block(const TileShape<2>& shape, const TileWindow& window, TileBlock& block) {
  if (window.empty()) return;
  const auto width = static_cast<std::size_t>(window.high[0] - window.low[0]);
  for (int c = 0; c < BodyMap::components; ++c)
    for (int j = window.low[1]; j < window.high[1]; ++j)
      std::fill_n(block.component(c) + shape.at(window.low[0], j), width, nothing[static_cast<std::size_t>(c)]);
}

/// visit(offset, lanes that count) for the cells of a window, a vector at a time.
template <class Visit>
void for_packs(const TileShape<2>& shape, const TileWindow& window, Visit visit) {
  for (int j = window.low[1]; j < window.high[1]; ++j)
    for (int i = window.low[0]; i < window.high[0]; i += simd_width)
      visit(shape.at(i, j), lanes_below(window.high[0] - i));
}

/// Cells of these lanes hold nothing from now on.
MORTISE_INLINE void empty(TileBlock& block, std::size_t k, PackMask lanes) {
  for (int n = 0; n < BodyMap::components; ++n) {
    double* const q = block.component(n) + k;
    store(q, select(lanes, broadcast(nothing[static_cast<std::size_t>(n)]), load(q)));
  }
}

/// The smallest window around the cells inside the body.
TileWindow inside_of(const TileShape<2>& shape, const TileWindow& window, const TileBlock& block) {
  TileWindow box;
  for (int j = window.low[1]; j < window.high[1]; ++j) {
    const double* const layer = block.component(3) + shape.at(0, j);
    int first = window.low[0], last = window.high[0];
    while (first < last && layer[first] != 0) ++first;
    while (first < last && layer[last - 1] != 0) --last;
    box = box | TileWindow{{first, j}, {last, j + 1}};
  }
  return box;
}

/// Weights of the parabola through −1, 0, 1 at −d.
template <class T>
struct Parabola {
  T before, here, after;
  MORTISE_INLINE explicit Parabola(T d)
      : before(0.5 * (d * (d + 1.0))), here(1.0 - d * d), after(0.5 * (d * (d - 1.0))) {}
};

/// Local tiles that hold the map.
std::vector<int> held(const Field<2>& field) {
  std::vector<int> tiles;
  for (int t = 0; t < field.tiles(); ++t)
    if (field.tile(t).allocated()) tiles.push_back(t);
  return tiles;
}

std::size_t index(int tile) { return static_cast<std::size_t>(tile); }

}  // namespace

BodyMap::BodyMap(Setup setup, const ComponentGrid<2>& grid)
    : setup_(std::move(setup)),
      grid_(grid),
      now_(empty_field(grid)),
      half_(empty_field(grid)),
      now_windows_(index(grid.forest.local_count())),
      half_windows_(now_windows_),
      exchange_(grid.forest, grid.shape, components) {
  for (const int cells : grid.shape.cells)
    if (cells < reach())
      throw InputError("the reference map needs tiles at least " + std::to_string(reach()) + " cells wide");
}

std::size_t BodyMap::memory_bytes() const {
  std::size_t bytes = 0;
  for (int t = 0; t < now_.tiles(); ++t) bytes += now_.tile(t).bytes() + half_.tile(t).bytes();
  return bytes;
}

void BodyMap::clear(Field<2>& field, const Windows& windows) const {
  for (const int t : held(field)) clear_block(grid_.shape, windows[index(t)], field.tile(t));
}

void BodyMap::resume() {
  for (const int t : held(now_)) {
    TileBlock& block = now_.tile(t);
    now_windows_[index(t)] = tile_cells_and_ghosts(grid_.shape);
    for_packs(grid_.shape, now_windows_[index(t)],
              [&](std::size_t k, PackMask own) { empty(block, k, own & (load(block.component(3) + k) != 0)); });
  }
  settle();
}

bool BodyMap::initialize() {
  const Box<2> around = setup_.level_set->box();
  for (int t = 0; t < now_.tiles(); ++t) {
    now_.allocate(t);
    now_windows_[index(t)] = tile_cells_and_ghosts(grid_.shape);
    TileBlock& block = now_.tile(t);
    clear_block(grid_.shape, now_windows_[index(t)], block);
    const Index<2> first = grid_.first_cell(t);
    for_each_cell<2>(grid_.shape, 0, [&](const Index<2>& c) {
      const Point<2> xi = setup_.initial(grid_.center({first[0] + c[0], first[1] + c[1]}));
      if (!(xi.x() > around.low.x() && xi.x() < around.high.x() && xi.y() > around.low.y() && xi.y() < around.high.y()))
        return;
      const std::size_t k = grid_.shape.at(c);
      block.component(0)[k] = xi.x();
      block.component(1)[k] = xi.y();
      block.component(3)[k] = 0;
    });
    classify(block, tile_cells(grid_.shape));
  }
  settle();
  return admissible(now_, now_windows_);
}

/// Sets φ and tells inside from outside, from ξ; cells that are neither inside nor next to it hold no ξ from now on.
void BodyMap::classify(TileBlock& block, const TileWindow& window) const {
  for_packs(grid_.shape, window, [&](std::size_t k, PackMask own) {
    const Pack layer = load(block.component(3) + k);
    if (!any(own & (layer < unknown))) return;
    const Pack phi = (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k));
    const PackMask inside = own & (layer <= 2) & (phi < 0);
    store(block.component(2) + k, select(inside, phi, load(block.component(2) + k)));
    store(block.component(3) + k, select(inside, Pack{}, layer));
    empty(block, k, own & ~inside);
  });
}

/// φ of the cells that hold ξ, from `first_layer` on.
void BodyMap::measure(TileBlock& block, const TileWindow& window, double first_layer) const {
  for_packs(grid_.shape, window, [&](std::size_t k, PackMask own) {
    const Pack layer = load(block.component(3) + k);
    double* const phi = block.component(2) + k;
    own = own & (layer >= first_layer) & (layer < unknown);
    if (any(own))
      store(phi,
            select(own, (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k)), load(phi)));
  });
}

/// Tiles with cells in the new windows, around the cells inside, hold the map, others do not.
void BodyMap::move_windows(Field<2>& field, Windows& windows) const {
  const TileWindow cells = tile_cells(grid_.shape);
  Windows boxes(windows.size());
  for (const int t : held(field)) boxes[index(t)] = inside_of(grid_.shape, windows[index(t)] & cells, field.tile(t));
  windows = windows_around(grid_, boxes, reach());
  for (int t = 0; t < field.tiles(); ++t) {
    TileWindow& window = windows[index(t)];
    const bool wanted = !(window & cells).empty();
    if (!wanted) window = {};
    if (wanted == field.tile(t).allocated()) continue;
    if (wanted) {
      field.allocate(t);
      clear_block(grid_.shape, tile_cells_and_ghosts(grid_.shape), field.tile(t));
    } else {
      field.tile(t).release();
    }
  }
}

/// After the cells inside hold ξ and all others nothing: the band around them, which follows from them alone.
void BodyMap::settle() {
  move_windows(now_, now_windows_);
  continue_band();
  for (const int t : held(now_)) measure(now_.tile(t), now_windows_[index(t)], 1);
}

void BodyMap::continue_band() {
  fill_band(0);
  folded_ = grid_.forest.communicator().any(jumps());
  if (!folded_) return;
  for (const int t : held(now_))
    for_packs(grid_.shape, now_windows_[index(t)], [&](std::size_t k, PackMask own) {
      empty(now_.tile(t), k, own & (load(now_.tile(t).component(3) + k) != 0));
    });
  fill_band(branch_jump * grid_.spacing.maxCoeff());
}

void BodyMap::fill_band(double largest_jump) {
  const std::vector<int> tiles = held(now_);
  const TileWindow cells = tile_cells(grid_.shape);
  orphans_ = 0;
  fill_ghosts(now_, now_windows_);
  for (int number = 1; number <= layers(); ++number) {
    for (const int t : tiles) {
      const int orphans = extend_layer(grid_.shape, now_windows_[index(t)] & cells, number, now_.tile(t), largest_jump);
      if (number <= 2) orphans_ += orphans;
    }
    fill_ghosts(now_, now_windows_);
  }
}

/// Neighbours on this rank whose ξ are further apart than a deformation takes them.
bool BodyMap::jumps() const {
  PackMask found{};
  for (const int t : held(now_))
    for_packs(grid_.shape, now_windows_[index(t)] & tile_cells(grid_.shape), [&](std::size_t k, PackMask own) {
      const MapBranch branch(now_.tile(t), k, grid_.spacing.maxCoeff());
      own = own & branch.known(0);
      const double largest = suspicious_jump * suspicious_jump;
      found |= own & branch.known(-1) & (branch.jump2(-1) > largest);
      found |= own & branch.known(-grid_.shape.stride) & (branch.jump2(-grid_.shape.stride) > largest);
    });
  return any(found);
}

/// Sharp bends and liquid that shears past a surface may tear at the map of a few cells, layer after layer, since no
/// stress brings back their volume. Cells that have lost or gained half of it are continued from others, as the band
/// is. False when they are more than a quarter of the body: there is nothing to continue from.
bool BodyMap::repair() {
  const TileWindow cells = tile_cells(grid_.shape);
  const std::vector<int> tiles = held(now_);
  std::int64_t count = 0, inside = 0;
  for (const int t : tiles) {
    TileBlock& block = now_.tile(t);
    std::vector<std::size_t> wrong;
    for_packs(grid_.shape, now_windows_[index(t)] & cells, [&](std::size_t k, PackMask own) {
      const Pack det = determinant(block, k);
      own = own & (load(block.component(3) + k) == 0);
      for (int l = 0; l < simd_width; ++l) inside += own[l] != 0;
      own = own & ~((det >= 0.5) & (det <= 2));
      for (int l = 0; l < simd_width && any(own); ++l)
        if (own[l]) wrong.push_back(k + static_cast<std::size_t>(l));
    });
    for (const std::size_t k : wrong) block.component(3)[k] = replaced;
    count += static_cast<std::int64_t>(wrong.size());
  }
  const Communicator& comm = grid_.forest.communicator();
  const std::int64_t all = comm.sum(count);
  if (all == 0) return true;
  if (4 * all > comm.sum(inside)) return false;
  repaired_ += count;
  for (const int t : tiles)
    for_packs(grid_.shape, now_windows_[index(t)], [&](std::size_t k, PackMask own) {
      const Pack layer = load(now_.tile(t).component(3) + k);
      empty(now_.tile(t), k, own & (layer != 0));
      double* const phi = now_.tile(t).component(2) + k;
      store(phi, select(own & (layer == replaced), Pack{}, load(phi)));  // marks what comes back inside if φ < 0
    });
  continue_band();
  for (const int t : tiles)
    for_packs(grid_.shape, now_windows_[index(t)] & cells, [&](std::size_t k, PackMask own) {
      TileBlock& block = now_.tile(t);
      double *const phi = block.component(2) + k, *const layer = block.component(3) + k;
      own = own & (load(phi) == 0) & (load(layer) < unknown);
      if (!any(own)) return;
      const Pack level = (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k));
      store(phi, select(own, level, load(phi)));
      store(layer, select(own & (level < 0), Pack{}, load(layer)));
    });
  for (const int t : tiles)
    for_packs(grid_.shape, now_windows_[index(t)], [&](std::size_t k, PackMask own) {
      empty(now_.tile(t), k, own & (load(now_.tile(t).component(3) + k) != 0));
    });
  settle();
  return true;
}

/// From neighbours; beyond the sides of the domain linearly from the two cells there, where both hold the map.
void BodyMap::fill_ghosts(Field<2>& field, const Windows& windows) const {
  const bool alone = grid_.forest.communicator().size() == 1;
  if (!alone) exchange_.fill(field, nothing);
  for (const int t : held(field)) {
    if (alone)
      for (int side = 0; side < offset_count<2>; ++side) copy_ghosts(field, t, offset_of<2>(side), windows[index(t)]);
    // Sides of direction 1 come last and take the corners along.
    for (int side = 0; side < 4; ++side) {
      Index<2> outward{};
      outward[static_cast<std::size_t>(side / 2)] = side % 2 != 0 ? 1 : -1;
      if (grid_.forest.neighbor(t, outward).kind == Neighbor::Kind::boundary)
        fill_ghosts_beyond(field.tile(t), outward, windows[index(t)]);
    }
  }
}

/// From the neighbour at `offset`, on this rank.
void BodyMap::copy_ghosts(Field<2>& field, int tile, const Index<2>& offset, const TileWindow& window) const {
  const TileShape<2>& shape = grid_.shape;
  const Index<2> shift{offset[0] * shape.cells[0], offset[1] * shape.cells[1]};
  const TileWindow ghosts = tile_cells(shape).moved(shift) & window;
  if (offset == Index<2>{0, 0} || ghosts.empty()) return;
  const Neighbor& neighbor = grid_.forest.neighbor(tile, offset);
  if (neighbor.kind == Neighbor::Kind::boundary) return;
  TileBlock& here = field.tile(tile);
  const TileBlock& there = field.tile(neighbor.local);
  if (!there.allocated()) {
    clear_block(shape, ghosts, here);
    return;
  }
  const auto width = static_cast<std::size_t>(ghosts.high[0] - ghosts.low[0]);
  for (int c = 0; c < components; ++c)
    for (int j = ghosts.low[1]; j < ghosts.high[1]; ++j)
      std::copy_n(there.component(c) + shape.at(ghosts.low[0] - shift[0], j - shift[1]), width,
                  here.component(c) + shape.at(ghosts.low[0], j));
}

void BodyMap::fill_ghosts_beyond(TileBlock& block, const Index<2>& outward, const TileWindow& window) const {
  const TileShape<2>& shape = grid_.shape;
  const std::size_t d = outward[0] != 0 ? 0 : 1;
  const bool high = outward[d] > 0;
  if (high ? window.high[d] <= shape.cells[d] : window.low[d] >= 0) return;
  const std::ptrdiff_t inward = (d == 0 ? 1 : shape.stride) * -outward[d];
  for (int k = window.low[1 - d]; k < window.high[1 - d]; ++k) {
    Index<2> c{};
    c[d] = high ? shape.cells[d] - 1 : 0;
    c[1 - d] = k;
    const std::size_t at = shape.at(c), next = at + static_cast<std::size_t>(inward);
    const double layer = std::max(block.component(3)[at], block.component(3)[next]);
    for (int far = 1; far <= TileShape<2>::ghosts; ++far) {
      const std::size_t ghost = at - static_cast<std::size_t>(far * inward);
      for (int n = 0; n < components; ++n) {
        const double* q = block.component(n);
        block.component(n)[ghost] = layer >= unknown ? nothing[static_cast<std::size_t>(n)]
                                    : n == 3         ? std::max(layer, 1.0)
                                                     : q[at] + far * (q[at] - q[next]);
      }
    }
  }
}

/// ξ(x) ← ξ(x − d), d = τ v(x − ½τ v(x)), by the biquadratic through 9 cells, in the body and `last_layer` layers;
/// where those 9 are not of one part of the body by upwind differences within the part.
void BodyMap::advect_tile(int tile, const Field<2>& field, Field<2>& to_field, const TileVelocity& velocity,
                          double time, double last_layer) const {
  const TileShape<2>& shape = grid_.shape;
  const TileBlock& from = field.tile(tile);
  TileBlock& to = to_field.tile(tile);
  const std::ptrdiff_t s = shape.stride;
  const double cx = time / grid_.spacing.x(), cy = time / grid_.spacing.y();
  const TileWindow window = (&field == &now_ ? now_windows_ : half_windows_)[index(tile)] & tile_cells(shape);
  for (int j = window.low[1]; j < window.high[1]; ++j) {
    const std::size_t k = shape.at(0, j);
    const double* layer = from.component(3) + k;
    const double *u = velocity.u + j * s, *v = velocity.v + j * s;
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const Pack here = load(layer + i);
      const PackMask moves = (here < last_layer + 0.5) & lanes_below(window.high[0] - i);
      const auto shifted = [&](const double* q) {  // τ/h q, at the middle of the way
        const Pack dx = cx * load(u + i), dy = cy * load(v + i);
        return load(q + i) -
               0.25 * (dx * (load(q + i + 1) - load(q + i - 1)) + dy * (load(q + i + s) - load(q + i - s)));
      };
      const Parabola<Pack> px(cx * shifted(u)), py(cy * shifted(v));
      double* const known = to.component(3) + k + i;
      store(known, select(moves, here, load(known)));
      for (int c = 0; c < 2; ++c) {
        const double* q = from.component(c) + k + i;
        double* const out = to.component(c) + k + i;
        const auto row = [&](const double* p) {
          return px.before * load(p - 1) + px.here * load(p) + px.after * load(p + 1);
        };
        store(out, select(moves, Pack(py.before * row(q - s) + py.here * row(q) + py.after * row(q + s)), load(out)));
      }
      if (!folded_) continue;
      const MapBranch branch(from, k + static_cast<std::size_t>(i), grid_.spacing.maxCoeff());
      const PackMask torn = moves & ~branch.reaches_all(s);
      if (!any(torn)) continue;
      const Pack dx = cx * load(u + i), dy = cy * load(v + i);
      for (int c = 0; c < 2; ++c) {
        const double* q = from.component(c) + k + i;
        double* const out = to.component(c) + k + i;
        store(out, select(torn,
                          Pack(load(q) - dx * branch_upwind(branch, q, 1, dx > 0) -
                               dy * branch_upwind(branch, q, s, dy > 0)),
                          load(out)));
      }
    }
  }
}

/// The band moves along: half a step of the flow beside the body's own is not worth a new one.
bool BodyMap::drift_to_half(double time, const Velocity& velocity) {
  clear(half_, half_windows_);
  half_windows_ = now_windows_;
  for (int t = 0; t < now_.tiles(); ++t) {
    if (!now_.tile(t).allocated()) {
      half_.tile(t).release();
      continue;
    }
    if (!half_.tile(t).allocated()) {
      half_.allocate(t);
      clear_block(grid_.shape, tile_cells_and_ghosts(grid_.shape), half_.tile(t));
    }
    advect_tile(t, now_, half_, velocity(t), time, layers() - 1);
    measure(half_.tile(t), half_windows_[index(t)] & tile_cells(grid_.shape), 0);
  }
  fill_ghosts(half_, half_windows_);
  return setup_.keeps_volume || admissible(half_, half_windows_);
}

bool BodyMap::drift_to_end(double time, const Velocity& velocity) {
  clear(now_, now_windows_);
  for (const int t : held(half_)) {
    advect_tile(t, half_, now_, velocity(t), time, 3);
    classify(now_.tile(t), now_windows_[index(t)] & tile_cells(grid_.shape));
  }
  settle();
  return setup_.keeps_volume ? repair() : admissible(now_, now_windows_);
}

bool BodyMap::admissible(const Field<2>& field, const Windows& windows) const {
  PackMask bad{};
  for (const int t : held(field))
    for_packs(grid_.shape, windows[index(t)] & tile_cells(grid_.shape), [&](std::size_t k, PackMask own) {
      const TileBlock& block = field.tile(t);
      bad |= own & (load(block.component(3) + k) == 0) & ~(determinant(block, k) > 0);
    });
  return !grid_.forest.communicator().any(any(bad));
}

Pack BodyMap::determinant(const TileBlock& block, std::size_t k) const {
  return folded_ ? branch_determinant(block, k, grid_.shape.stride, grid_.spacing)
                 : map_determinant(block, k, grid_.shape.stride, grid_.spacing);
}

}  // namespace mortise
