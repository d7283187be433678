// Tiles for the tests of the elastic kernels: one tile with its ghosts, filled from a function of the cell index.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "mortise/solid/elastic_step.hpp"
#include "unit/noise.hpp"

namespace mortise::testing {

/// (v, σ, u) or (v, F, u).
using Numbers = std::array<double, 8>;

inline ElasticOptions elastic_options(StressLaw law, ElasticLimiter limiter = ElasticLimiter::none) {
  ElasticOptions o;
  o.material = {law, 1.3, 1.7, 0.8};
  o.limiter = limiter;
  return o;
}

/// The state at rest, displaced by u.
inline Numbers at_rest(StressLaw law, double ux = 0, double uy = 0) {
  if (law == StressLaw::linear) return {0, 0, 0, 0, 0, ux, uy, 0};
  return {0, 0, 1, 0, 0, 1, ux, uy};
}

/// A tile and its ghosts; nodes if it is curvilinear.
struct SolidTile {
  using StateOf = std::function<Numbers(int, int)>;
  using PointOf = std::function<Point<2>(int, int)>;

  SolidTile(StressLaw law, Index<2> cells)
      : components(elastic_components(law)),
        shape(cells),
        nodes({cells[0] + 1, cells[1] + 1}),
        now(shape.plane, components),
        next(shape.plane, components),
        active(shape.plane, 1) {}
  SolidTile(StressLaw law, Index<2> cells, const StateOf& state) : SolidTile(law, cells) { fill(state); }

  void fill(const StateOf& state) {
    for (int j = -2; j < shape.cells[1] + 2; ++j)
      for (int i = -2; i < shape.cells[0] + 2; ++i) {
        const Numbers W = state(i, j);
        for (int c = 0; c < components; ++c) now.component(c)[shape.at(i, j)] = W[static_cast<std::size_t>(c)];
      }
  }
  void place(const PointOf& position) {
    x.assign(nodes.plane, 0), y.assign(nodes.plane, 0);
    for (int j = -2; j < nodes.cells[1] + 2; ++j)
      for (int i = -2; i < nodes.cells[0] + 2; ++i) {
        x[nodes.at(i, j)] = position(i, j)[0];
        y[nodes.at(i, j)] = position(i, j)[1];
      }
  }
  static Numbers get(const TileBlock& block, const TileShape<2>& shape, int components, int i, int j) {
    Numbers W{};
    for (int c = 0; c < components; ++c) W[static_cast<std::size_t>(c)] = block.component(c)[shape.at(i, j)];
    return W;
  }
  Numbers before(int i, int j) const { return get(now, shape, components, i, j); }
  Numbers after(int i, int j) const { return get(next, shape, components, i, j); }

  void copy_periodic_ghosts() {
    const int nx = shape.cells[0], ny = shape.cells[1];
    for (int c = 0; c < components; ++c)
      for (int j = -2; j < ny + 2; ++j)
        for (int i = -2; i < nx + 2; ++i)
          now.component(c)[shape.at(i, j)] = now.component(c)[shape.at((i + nx) % nx, (j + ny) % ny)];
  }
  ElasticTile tile(double hx = 1, double hy = 1) {
    ElasticTile t;
    t.shape = &shape;
    t.nodes = &nodes;
    t.now = now.component(0);
    t.next = next.component(0);
    t.spacing = {hx, hy};
    if (!x.empty()) t.x = x.data(), t.y = y.data();
    return t;
  }
  ElasticTile masked(double hx = 1, double hy = 1) {
    ElasticTile t = tile(hx, hy);
    t.active = active.data();
    return t;
  }
  void accept() { std::swap(now, next); }

  int components;
  TileShape<2> shape, nodes;
  TileBlock now, next;
  std::vector<double> x, y;          // indexed by nodes.at(); empty: Cartesian
  std::vector<std::uint8_t> active;  // indexed by shape.at()
};

/// Largest difference of two states.
inline double distance(const Numbers& a, const Numbers& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c) largest = std::max(largest, std::fabs(a[c] - b[c]));
  return largest;
}

/// A state at rest with noise of the given size in all components.
inline Numbers noisy_state(StressLaw law, double size, int i, int j) {
  Numbers W = at_rest(law);
  for (std::size_t c = 0; c < (law == StressLaw::linear ? 7u : 8u); ++c)
    W[c] += size * (2 * noise(i, j, static_cast<int>(c)) - 1);
  return W;
}

/// Nodes of a wavy grid of unit cells, periodic over nx × ny of them.
inline Point<2> wavy_node(int i, int j, int nx, int ny, double amplitude) {
  const double a = 2 * M_PI * i / nx, b = 2 * M_PI * j / ny;
  return {i + amplitude * nx * std::sin(a + b) / (2 * M_PI), j + amplitude * ny * std::cos(a - b) / (2 * M_PI)};
}

inline const std::array<StressLaw, 3> all_laws = {StressLaw::linear, StressLaw::saint_venant_kirchhoff,
                                                  StressLaw::neo_hookean};
inline const std::array<ElasticLimiter, 3> all_limiters = {ElasticLimiter::none, ElasticLimiter::minmod,
                                                           ElasticLimiter::mc};

}  // namespace mortise::testing
