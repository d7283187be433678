// Tiles for the tests of the step kernels: one tile with its ghosts, filled from a function of the cell index.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/godunov_step.hpp"
#include "unit/fluid/gas_options.hpp"
#include "unit/noise.hpp"

namespace mortise::testing {

/// A plane tile and its ghosts.
struct PlaneTile {
  using StateOf = std::function<Primitive<2>(int, int)>;

  explicit PlaneTile(Index<2> cells)
      : shape(cells), now(shape.plane, 4), next(shape.plane, 4), active(shape.plane, 1) {}
  PlaneTile(Index<2> cells, const StateOf& state) : PlaneTile(cells) { fill(state); }

  void fill(const StateOf& state) {
    for (int j = -2; j < shape.cells[1] + 2; ++j)
      for (int i = -2; i < shape.cells[0] + 2; ++i) put(now, shape.at(i, j), to_conserved(state(i, j), gamma_air));
  }
  Conserved<2> before(int i, int j) const { return get<2>(now, shape.at(i, j)); }
  Conserved<2> after(int i, int j) const { return get<2>(next, shape.at(i, j)); }
  Primitive<2> primitive(int i, int j) const { return to_primitive(before(i, j), gamma_air); }

  void copy_periodic_ghosts() {
    const int nx = shape.cells[0], ny = shape.cells[1];
    for (int j = -2; j < ny + 2; ++j)
      for (int i = -2; i < nx + 2; ++i) put(now, shape.at(i, j), get<2>(now, shape.at((i + nx) % nx, (j + ny) % ny)));
  }
  CartesianTile<2> cartesian(double hx, double hy, bool masked = false) {
    return {&shape, now.component(0), next.component(0), {hx, hy}, masked ? active.data() : nullptr};
  }
  void accept() { std::swap(now, next); }

  TileShape<2> shape;
  TileBlock now, next;
  std::vector<std::uint8_t> active;  // indexed by shape.at()
};

/// Nodes of a curvilinear tile.
struct PlaneNodes {
  using PointOf = std::function<Point<2>(int, int)>;

  explicit PlaneNodes(Index<2> cells)
      : shape({cells[0] + 1, cells[1] + 1}), x(shape.plane), y(shape.plane), wx(shape.plane), wy(shape.plane) {}

  void place(const PointOf& position) { set(x, y, position); }
  void move(const PointOf& velocity) { set(wx, wy, velocity); }
  CurvilinearTile tile(PlaneTile& cells) const {
    return {
        &cells.shape, &shape, cells.now.component(0), cells.next.component(0), x.data(), y.data(), wx.data(), wy.data(),
        nullptr,      {}};
  }

  TileShape<2> shape;
  std::vector<double> x, y, wx, wy;

 private:
  void set(std::vector<double>& a, std::vector<double>& b, const PointOf& value) const {
    for (int j = -2; j < shape.cells[1] + 2; ++j)
      for (int i = -2; i < shape.cells[0] + 2; ++i) {
        a[shape.at(i, j)] = value(i, j)[0];
        b[shape.at(i, j)] = value(i, j)[1];
      }
  }
};

inline bool same_bits(const Conserved<2>& a, const Conserved<2>& b) {
  return a.density == b.density && a.momentum == b.momentum && a.energy == b.energy;
}
/// Largest difference of two states relative to the size of the first.
inline double distance(const Conserved<2>& a, const Conserved<2>& b) {
  const double scale = std::abs(a.density) + std::abs(a.energy);
  return std::max({std::abs(a.density - b.density), std::abs(a.momentum[0] - b.momentum[0]),
                   std::abs(a.momentum[1] - b.momentum[1]), std::abs(a.energy - b.energy)}) /
         scale;
}

/// Smooth flow with features in both directions.
/// Not inlined, so that every caller gets the same bits.
[[gnu::noinline]] inline Primitive<2> wavy_state(double x, double y) {
  return {1 + 0.3 * std::sin(2.1 * x + 0.7) * std::cos(1.3 * y),
          {0.4 * std::cos(1.7 * y + x), -0.3 + 0.5 * std::sin(0.9 * x - y)},
          1.2 + 0.4 * std::cos(1.1 * x + 1.9 * y)};
}
inline Primitive<2> noisy_state(int i, int j) {
  return {0.2 + noise(i, j, 1), {2 * noise(i, j, 2) - 1, 2 * noise(i, j, 3) - 1}, 0.1 + noise(i, j, 4)};
}

}  // namespace mortise::testing
