#include "mortise/coupler/reference_map/body_map.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr std::array<double, BodyMap::components> nothing = {0, 0, 1e30, BodyMap::unknown};

Field<2> empty_field(const ComponentGrid<2>& grid) {
  return Field<2>::unallocated(grid.shape, BodyMap::components, grid.forest.local_count());
}

void clear(TileBlock& block, std::size_t plane) {
  for (int c = 0; c < BodyMap::components; ++c)
    std::fill_n(block.component(c), plane, nothing[static_cast<std::size_t>(c)]);
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

}  // namespace

BodyMap::BodyMap(Setup setup, const ComponentGrid<2>& grid)
    : setup_(std::move(setup)),
      grid_(grid),
      now_(empty_field(grid)),
      half_(empty_field(grid)),
      exchange_(grid.forest, grid.shape, components) {
  for (const int cells : grid.shape.cells)
    if (cells < reach)
      throw InputError("the reference map needs tiles at least " + std::to_string(reach) + " cells wide");
}

std::size_t BodyMap::memory_bytes() const {
  std::size_t bytes = 0;
  for (int t = 0; t < now_.tiles(); ++t) bytes += now_.tile(t).bytes() + half_.tile(t).bytes();
  return bytes;
}

void BodyMap::resume() {
  for (const int t : held(now_)) {
    TileBlock& block = now_.tile(t);
    for_each_cell<2>(grid_.shape, 0, [&](const Index<2>& c) {
      const std::size_t k = grid_.shape.at(c);
      if (block.component(3)[k] == 0) return;
      for (int n = 0; n < components; ++n) block.component(n)[k] = nothing[static_cast<std::size_t>(n)];
    });
  }
  fit_tiles(now_);
  extend(now_);
}

/// Sets φ and tells inside from outside, from ξ; cells that are neither inside nor next to it hold no ξ from now on.
void BodyMap::classify(TileBlock& block) const {
  const LevelSet& level_set = *setup_.level_set;
  for_each_cell<2>(grid_.shape, 0, [&](const Index<2>& c) {
    const std::size_t k = grid_.shape.at(c);
    double& layer = block.component(3)[k];
    double& phi = block.component(2)[k];
    if (layer <= 2) {
      phi = level_set(block.component(0)[k], block.component(1)[k]);
      if (phi < 0) {
        layer = 0;
        return;
      }
    }
    for (int n = 0; n < components; ++n) block.component(n)[k] = nothing[static_cast<std::size_t>(n)];
  });
}

bool BodyMap::initialize() {
  const Box<2> around = setup_.level_set->box();
  for (int t = 0; t < now_.tiles(); ++t) {
    TileBlock block(grid_.shape.plane, components);
    clear(block, grid_.shape.plane);
    bool any = false;
    for_each_cell<2>(grid_.shape, 0, [&](const Index<2>& c) {
      const Index<2> first = grid_.first_cell(t);
      const Point<2> xi = setup_.initial(grid_.center({first[0] + c[0], first[1] + c[1]}));
      if (!(xi.x() > around.low.x() && xi.x() < around.high.x() && xi.y() > around.low.y() && xi.y() < around.high.y()))
        return;
      const std::size_t k = grid_.shape.at(c);
      block.component(0)[k] = xi.x();
      block.component(1)[k] = xi.y();
      block.component(3)[k] = 0;
    });
    classify(block);
    for_each_cell<2>(grid_.shape, 0,
                     [&](const Index<2>& c) { any = any || block.component(3)[grid_.shape.at(c)] == 0; });
    if (any) now_.tile(t) = std::move(block);
  }
  fit_tiles(now_);
  extend(now_);
  return admissible(now_);
}

/// Tiles within `reach` of a cell inside hold the map, others do not.
void BodyMap::fit_tiles(Field<2>& field) const {
  struct Touch {
    std::int64_t tile;
    std::int64_t sides;  // bit k: a cell inside is within reach of the neighbour at offset_of<2>(k)
  };
  const int nx = grid_.shape.cells[0], ny = grid_.shape.cells[1];
  std::vector<Touch> mine;
  for (const int t : held(field)) {
    const double* layer = field.tile(t).component(3);
    std::int64_t sides = 0;
    for (int j = 0; j < ny; ++j) {
      const double* row = layer + grid_.shape.at(0, j);
      const auto any = [&](int from, int to) {
        return std::any_of(row + from, row + to, [](double x) { return x == 0; });
      };
      const bool west = any(0, std::min(reach, nx)), east = any(std::max(0, nx - reach), nx),
                 middle = west || east || any(0, nx);
      const auto mark = [&](int dy) {
        const int base = 3 * (dy + 1);
        sides |=
            (std::int64_t{west} << base) | (std::int64_t{middle} << (base + 1)) | (std::int64_t{east} << (base + 2));
      };
      mark(0);
      if (j < reach) mark(-1);
      if (j >= ny - reach) mark(1);
    }
    mine.push_back({grid_.forest.first_global() + t, sides});
  }
  std::vector<Touch> all = grid_.forest.communicator().gather_all(mine);
  std::sort(all.begin(), all.end(), [](const Touch& a, const Touch& b) { return a.tile < b.tile; });
  for (int t = 0; t < field.tiles(); ++t) {
    bool wanted = false;
    for (int side = 0; side < offset_count<2> && !wanted; ++side) {
      const Index<2> offset = offset_of<2>(side);
      std::int64_t tile = grid_.forest.first_global() + t;
      if (side != 4) {
        const Neighbor& neighbor = grid_.forest.neighbor(t, offset);
        if (neighbor.kind == Neighbor::Kind::boundary) continue;
        tile = neighbor.global;
      }
      const auto found =
          std::lower_bound(all.begin(), all.end(), tile, [](const Touch& a, std::int64_t b) { return a.tile < b; });
      wanted = found != all.end() && found->tile == tile && (found->sides >> (offset_count<2> - 1 - side) & 1) != 0;
    }
    if (wanted == field.tile(t).allocated()) continue;
    if (wanted) {
      field.allocate(t);
      clear(field.tile(t), grid_.shape.plane);
    } else {
      field.tile(t).release();
    }
  }
}

/// ξ of a cell from its 24 neighbours. False when too few of them hold it.
bool BodyMap::extend_cell(TileBlock& block, std::size_t cell, double layer) const {
  const double *const x = block.component(0), *const y = block.component(1), *const known = block.component(3);
  const std::ptrdiff_t stride = grid_.shape.stride;
  // Normal equations of ξ ≈ a + b·(i, j), weights 1/(i² + j²)².
  double w = 0, wi = 0, wj = 0, wii = 0, wij = 0, wjj = 0;
  std::array<std::array<double, 3>, 2> right{};
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const std::size_t k = cell + static_cast<std::size_t>(j * stride + i);
      if (!(known[k] < layer)) continue;
      const double r2 = i * i + j * j, weight = 1 / (r2 * r2);
      w += weight, wi += weight * i, wj += weight * j;
      wii += weight * i * i, wij += weight * i * j, wjj += weight * j * j;
      for (std::size_t c = 0; c < 2; ++c) {
        const double value = weight * (c == 0 ? x[k] : y[k]);
        right[c][0] += value, right[c][1] += value * i, right[c][2] += value * j;
      }
    }
  if (w == 0) return false;
  // Moments about the mean; the value at (0, 0) is mean − slope · mean position.
  const double mi = wi / w, mj = wj / w, cii = wii - wi * mi, cij = wij - wi * mj, cjj = wjj - wj * mj;
  const double det = cii * cjj - cij * cij;
  if (!(det > 1e-3 * w * w)) return false;
  for (std::size_t c = 0; c < 2; ++c) {
    const double mean = right[c][0] / w, ri = right[c][1] - right[c][0] * mi, rj = right[c][2] - right[c][0] * mj;
    const double bi = (cjj * ri - cij * rj) / det, bj = (cii * rj - cij * ri) / det;
    block.component(static_cast<int>(c))[cell] = mean - bi * mi - bj * mj;
  }
  return true;
}

/// From neighbours; beyond the sides of the domain linearly from the two cells there, where both hold the map.
void BodyMap::fill_ghosts(Field<2>& field) const {
  exchange_.fill(field, nothing);
  const TileShape<2>& shape = grid_.shape;
  for (const int t : held(field))
    for (int side = 0; side < 4; ++side) {
      const auto d = static_cast<std::size_t>(side / 2);
      const bool high = side % 2 != 0;
      Index<2> outward{};
      outward[d] = high ? 1 : -1;
      if (grid_.forest.neighbor(t, outward).kind != Neighbor::Kind::boundary) continue;
      const std::ptrdiff_t inward = (d == 0 ? 1 : shape.stride) * (high ? -1 : 1);
      TileBlock& block = field.tile(t);
      // Sides of direction 1 come last and take the corners along.
      for (int k = d == 0 ? 0 : -TileShape<2>::ghosts; k < shape.cells[1 - d] + (d == 0 ? 0 : TileShape<2>::ghosts);
           ++k) {
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
}

void BodyMap::extend(Field<2>& field) {
  orphans_ = 0;
  const std::vector<int> tiles = held(field);
  fill_ghosts(field);
  const std::ptrdiff_t stride = grid_.shape.stride;
  std::vector<std::size_t> found;
  for (int number = 1; number <= layers; ++number) {
    const double layer = number;
    for (const int t : tiles) {
      TileBlock& block = field.tile(t);
      double* known = block.component(3);
      found.clear();
      for (int j = 0; j < grid_.shape.cells[1]; ++j) {
        const double* row = known + grid_.shape.at(0, j);
        for (int i = 0; i < grid_.shape.cells[0]; i += simd_width) {
          Pack least = broadcast(unknown);
          for (const std::ptrdiff_t dj : {-stride, std::ptrdiff_t{0}, stride})
            for (const int di : {-1, 0, 1}) least = min(least, load(row + dj + i + di));
          const Pack here = load(row + i);
          for (int l = 0; l < simd_width && i + l < grid_.shape.cells[0]; ++l)
            if (here[l] == unknown && least[l] < layer) found.push_back(grid_.shape.at(i + l, j));
        }
      }
      std::size_t kept = 0;
      for (const std::size_t cell : found)
        if (extend_cell(block, cell, layer)) found[kept++] = cell;
      if (number <= 2) orphans_ += static_cast<std::int64_t>(found.size() - kept);
      found.resize(kept);
      for (const std::size_t cell : found) {
        known[cell] = layer;
        block.component(2)[cell] = (*setup_.level_set)(block.component(0)[cell], block.component(1)[cell]);
      }
    }
    fill_ghosts(field);
  }
}

/// ξ(x) ← ξ(x − d), d = τ v(x − ½τ v(x)), by the biquadratic through 9 cells.
void BodyMap::advect_tile(const TileBlock& from, TileBlock& to, const TileVelocity& velocity, double time) const {
  const TileShape<2>& shape = grid_.shape;
  const std::ptrdiff_t s = shape.stride;
  const double cx = time / grid_.spacing.x(), cy = time / grid_.spacing.y();
  for (int j = 0; j < shape.cells[1]; ++j) {
    const std::size_t k = shape.at(0, j);
    const double* layer = from.component(3) + k;
    const double *u = velocity.u + j * s, *v = velocity.v + j * s;
    for (int i = 0; i < shape.cells[0]; i += simd_width) {
      const auto shifted = [&](const double* q) {  // τ/h q, at the middle of the way
        const Pack dx = cx * load(u + i), dy = cy * load(v + i);
        return load(q + i) -
               0.25 * (dx * (load(q + i + 1) - load(q + i - 1)) + dy * (load(q + i + s) - load(q + i - s)));
      };
      const Parabola<Pack> px(cx * shifted(u)), py(cy * shifted(v));
      const Pack here = load(layer + i);
      const PackMask moves = here < 3.5;
      store(to.component(3) + k + i, here);
      for (int c = 0; c < 2; ++c) {
        const double* q = from.component(c) + k + i;
        const auto row = [&](const double* p) {
          return px.before * load(p - 1) + px.here * load(p) + px.after * load(p + 1);
        };
        const Pack moved = py.before * row(q - s) + py.here * row(q) + py.after * row(q + s);
        store(to.component(c) + k + i, select(moves, moved, load(q)));
      }
    }
  }
}

bool BodyMap::drift(const Field<2>& from, Field<2>& to, double time, const Velocity& velocity) {
  for (int t = 0; t < from.tiles(); ++t) {
    if (!from.tile(t).allocated()) {
      to.tile(t).release();
      continue;
    }
    if (!to.tile(t).allocated()) to.allocate(t);
    clear(to.tile(t), grid_.shape.plane);
    advect_tile(from.tile(t), to.tile(t), velocity(t), time);
    classify(to.tile(t));
  }
  fit_tiles(to);
  extend(to);
  return admissible(to);
}

bool BodyMap::admissible(const Field<2>& field) const {
  bool good = true;
  const std::ptrdiff_t s = grid_.shape.stride;
  for (const int t : held(field)) {
    const TileBlock& block = field.tile(t);
    for (int j = 0; j < grid_.shape.cells[1]; ++j) {
      const std::size_t k = grid_.shape.at(0, j);
      const double *x = block.component(0) + k, *y = block.component(1) + k, *layer = block.component(3) + k;
      for (int i = 0; i < grid_.shape.cells[0]; ++i) {
        const double det =
            (x[i + 1] - x[i - 1]) * (y[i + s] - y[i - s]) - (x[i + s] - x[i - s]) * (y[i + 1] - y[i - 1]);
        good = good && (layer[i] != 0 || det > 0);
      }
    }
  }
  return !grid_.forest.communicator().any(!good);
}

}  // namespace mortise
