#include "mortise/coupler/reference_map/body_map.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/coupler/reference_map/map_branches.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/simd.hpp"

namespace mortise {
namespace {

constexpr double replaced = 98;  // in place of a layer: holds ξ that is to be replaced

/// Weights of the parabola through −1, 0, 1 at −d.
template <class T>
struct Parabola {
  T before, here, after;
  MORTISE_INLINE explicit Parabola(T d)
      : before(0.5 * (d * (d + 1.0))), here(1.0 - d * d), after(0.5 * (d * (d - 1.0))) {}
};

}  // namespace

BodyMap::BodyMap(Setup setup, const ComponentGrid<2>& grid)
    : setup_(std::move(setup)),
      grid_(grid),
      now_(grid),
      half_(grid),
      exchange_(grid.forest, grid.shape, MapField::components) {
  for (const int cells : grid.shape.cells)
    if (cells < reach())
      throw InputError("the reference map needs tiles at least " + std::to_string(reach()) + " cells wide");
}

void BodyMap::resume() {
  now_.widen();
  now_.keep_inside();
  settle();
}

bool BodyMap::initialize() {
  const Box<2> around = setup_.level_set->box();
  for (int t = 0; t < grid_.forest.local_count(); ++t) {
    now_.hold(t);
    TileBlock& block = now_.tile(t);
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
  now_.widen();
  settle();
  return admissible(now_);
}

/// Sets φ and tells inside from outside, from ξ; cells that are neither inside nor next to it hold no ξ from now on.
void BodyMap::classify(TileBlock& block, const TileWindow& window) const {
  now_.for_packs(window, [&](std::size_t k, PackMask own) {
    const Pack layer = load(block.component(3) + k);
    if (!any(own & (layer < unknown_layer))) return;
    const Pack phi = (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k));
    const PackMask inside = own & (layer <= 2) & (phi < 0);
    store(block.component(2) + k, select(inside, phi, load(block.component(2) + k)));
    store(block.component(3) + k, select(inside, Pack{}, layer));
    MapField::empty(block, k, own & ~inside);
  });
}

/// φ of the cells that hold ξ, from `first_layer` on.
void BodyMap::measure(TileBlock& block, const TileWindow& window, double first_layer) const {
  now_.for_packs(window, [&](std::size_t k, PackMask own) {
    const Pack layer = load(block.component(3) + k);
    double* const phi = block.component(2) + k;
    own = own & (layer >= first_layer) & (layer < unknown_layer);
    if (any(own))
      store(phi,
            select(own, (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k)), load(phi)));
  });
}

/// After the cells inside hold ξ and all others nothing: the band around them, which follows from them alone.
void BodyMap::settle() {
  now_.follow_inside(reach());
  continue_band();
  for (const int t : now_.held()) measure(now_.tile(t), now_.window(t), 1);
}

void BodyMap::continue_band() {
  fill_band(0);
  folded_ = grid_.forest.communicator().any(jumps());
  if (!folded_) return;
  now_.keep_inside();
  fill_band(branch_jump * grid_.spacing.maxCoeff());
}

void BodyMap::fill_band(double largest_jump) {
  const std::vector<int> tiles = now_.held();
  orphans_ = 0;
  now_.fill_ghosts(exchange_);
  for (int number = 1; number <= layers(); ++number) {
    for (const int t : tiles) {
      const int orphans = extend_layer(grid_.shape, now_.cells(t), number, now_.tile(t), largest_jump);
      if (number <= 2) orphans_ += orphans;
    }
    now_.fill_ghosts(exchange_);
  }
}

/// Neighbours on this rank whose ξ are further apart than a deformation takes them.
bool BodyMap::jumps() const {
  PackMask found{};
  for (const int t : now_.held())
    now_.for_packs(now_.cells(t), [&](std::size_t k, PackMask own) {
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
  const std::vector<int> tiles = now_.held();
  std::int64_t count = 0, inside = 0;
  for (const int t : tiles) {
    TileBlock& block = now_.tile(t);
    std::vector<std::size_t> wrong;
    now_.for_packs(now_.cells(t), [&](std::size_t k, PackMask own) {
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
    now_.for_packs(now_.window(t), [&](std::size_t k, PackMask own) {
      const Pack layer = load(now_.tile(t).component(3) + k);
      MapField::empty(now_.tile(t), k, own & (layer != 0));
      double* const phi = now_.tile(t).component(2) + k;
      store(phi, select(own & (layer == replaced), Pack{}, load(phi)));  // marks what comes back inside if φ < 0
    });
  continue_band();
  for (const int t : tiles)
    now_.for_packs(now_.cells(t), [&](std::size_t k, PackMask own) {
      TileBlock& block = now_.tile(t);
      double *const phi = block.component(2) + k, *const layer = block.component(3) + k;
      own = own & (load(phi) == 0) & (load(layer) < unknown_layer);
      if (!any(own)) return;
      const Pack level = (*setup_.level_set)(load(block.component(0) + k), load(block.component(1) + k));
      store(phi, select(own, level, load(phi)));
      store(layer, select(own & (level < 0), Pack{}, load(layer)));
    });
  now_.keep_inside();
  settle();
  return true;
}

/// ξ(x) ← ξ(x − d), d = τ v(x − ½τ v(x)), by the biquadratic through 9 cells, in the body and `last_layer` layers;
/// where those 9 are not of one part of the body by upwind differences within the part. Other cells of the window hold
/// nothing from now on.
void BodyMap::advect_tile(int tile, const MapField& field, MapField& to_field, const TileVelocity& velocity,
                          double time, double last_layer) const {
  const TileShape<2>& shape = grid_.shape;
  const TileBlock& from = field.tile(tile);
  TileBlock& to = to_field.tile(tile);
  const std::ptrdiff_t s = shape.stride;
  const double cx = time / grid_.spacing.x(), cy = time / grid_.spacing.y();
  const TileWindow window = field.cells(tile);
  for (int j = window.low[1]; j < window.high[1]; ++j) {
    const std::size_t k = shape.at(0, j);
    const double* layer = from.component(3) + k;
    const double *u = velocity.u + j * s, *v = velocity.v + j * s;
    for (int i = window.low[0]; i < window.high[0]; i += simd_width) {
      const PackMask own = lanes_below(window.high[0] - i);
      MapField::empty(to, k + static_cast<std::size_t>(i), own);
      const Pack here = load(layer + i);
      const PackMask moves = own & (here < last_layer + 0.5);
      if (!any(moves)) continue;
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
  half_.take_place_of(now_);
  for (const int t : half_.held()) {
    advect_tile(t, now_, half_, velocity(t), time, layers() - 1);
    measure(half_.tile(t), half_.cells(t), 0);
  }
  half_.fill_ghosts(exchange_);
  return setup_.keeps_volume || admissible(half_);
}

bool BodyMap::drift_to_end(double time, const Velocity& velocity) {
  for (const int t : half_.held()) {
    advect_tile(t, half_, now_, velocity(t), time, 3);
    classify(now_.tile(t), now_.cells(t));
  }
  settle();
  return setup_.keeps_volume ? repair() : admissible(now_);
}

bool BodyMap::admissible(const MapField& field) const {
  PackMask bad{};
  for (const int t : field.held())
    field.for_packs(field.cells(t), [&](std::size_t k, PackMask own) {
      const TileBlock& block = field.tile(t);
      bad |= own & (load(block.component(3) + k) == 0) & ~(determinant(block, k) > 0);
    });
  return !grid_.forest.communicator().any(any(bad));
}

Pack BodyMap::determinant(const TileBlock& tile, std::size_t k) const {
  return folded_ ? branch_determinant(tile, k, grid_.shape.stride, grid_.spacing)
                 : map_determinant(tile, k, grid_.shape.stride, grid_.spacing);
}

}  // namespace mortise
