// The solid at the faces of one side of a tile: a cell next to it extrapolated with its slope, at t and, by the same
// half step as in the kernels, at t + ½Δt. Second order.
#include <array>

#include "mortise/solid/state_rows.hpp"
#include "mortise/solid/with_options.hpp"

namespace mortise {
namespace elastic {
namespace {

using Vec = Vector<double>;

/// Area vectors, towards increasing index, and area of one cell.
struct CellGeometry {
  Vec west, east, south, north;
  double area;
};

CellGeometry cell_geometry(const ElasticTile& tile, int i, int j) {
  if (!tile.x) {
    const auto [hx, hy] = tile.spacing;
    return {{hy, 0}, {hy, 0}, {0, hx}, {0, hx}, hx * hy};
  }
  const auto node = [&](int a, int b) {
    const std::size_t n = tile.nodes->at(a, b);
    return Vec{tile.x[n], tile.y[n]};
  };
  const auto edge = [](const Vec& a, const Vec& b) { return Vec{b.y - a.y, a.x - b.x}; };
  const Vec sw = node(i, j), se = node(i + 1, j), nw = node(i, j + 1), ne = node(i + 1, j + 1);
  return {edge(sw, nw), edge(se, ne), edge(se, sw), edge(ne, nw),
          0.5 * ((ne.x - sw.x) * (nw.y - se.y) - (ne.y - sw.y) * (nw.x - se.x))};
}

/// Outward area vector of a side of a cell.
Vec outward(const CellGeometry& cell, Side side) {
  switch (side) {
    case Side::west:
      return -1.0 * cell.west;
    case Side::east:
      return cell.east;
    case Side::south:
      return -1.0 * cell.south;
    case Side::north:
      break;
  }
  return cell.north;
}

/// The state at the face of a side.
template <class State>
State at_face(const State& W, const Slopes<State>& h, Side side) {
  switch (side) {
    case Side::west:
      return W - h.xi;
    case Side::east:
      return W + h.xi;
    case Side::south:
      return W - h.eta;
    case Side::north:
      break;
  }
  return W + h.eta;
}

Point<2> point(const Vec& v) { return {v.x, v.y}; }

template <class System, Limiter limiter>
ElasticTrace trace_of(const ElasticTile& tile, int i, int j, Side side, double dt, const System& system) {
  using State = typename System::template StateOf<double>;
  const auto state = [&](int a, int b) {
    return rows::read<State>(tile.now + tile.shape->at(a, b), tile.shape->plane);
  };
  const State W = state(i, j);
  Slopes<State> h = {half_slopes<limiter>(state(i - 1, j), W, state(i + 1, j)),
                     half_slopes<limiter>(state(i, j - 1), W, state(i, j + 1))};
  const CellGeometry cell = cell_geometry(tile, i, j);
  const Vec S = outward(cell, side), N = (1 / length(S)) * S;
  const double factor = 0.5 * dt / cell.area;
  State start = W;
  Slopes<State> h_start = h;
  system.ensure_admissible_faces(W, start, h_start);
  const State now = at_face(start, h_start, side);
  State half = system.half_step(
      W, h, HalfStepMetrics<Vec, Vec, double>{cell.west + cell.east, cell.south + cell.north, factor, factor});
  system.ensure_admissible_faces(W, half, h);
  const State face = at_face(half, h, side);
  ElasticTrace trace;
  trace.velocity = point(face.velocity);
  trace.traction = point(system.traction(face, N));
  trace.velocity_now = point(now.velocity);
  trace.traction_now = point(system.traction(now, N));
  const Vec T = {-N.y, N.x};
  trace.tangent = point(system.stretched(face, T));
  trace.tangent_now = point(system.stretched(now, T));
  trace.admittance << point(system.admit(face, N, Vec{1, 0})), point(system.admit(face, N, Vec{0, 1}));
  return trace;
}

template <class System, Limiter limiter>
void side_traces(const ElasticTile& tile, Side side, double dt, const System& system, ElasticTrace* traces) {
  const auto [nx, ny] = tile.shape->cells;
  const bool along_x = side == Side::south || side == Side::north;
  const int i = side == Side::east ? nx - 1 : 0, j = side == Side::north ? ny - 1 : 0;
  for (int k = 0; k < (along_x ? nx : ny); ++k)
    traces[k] = trace_of<System, limiter>(tile, along_x ? k : i, along_x ? j : k, side, dt, system);
}

}  // namespace
}  // namespace elastic

void elastic_traces(const ElasticTile& tile, Side side, double dt, const ElasticOptions& options,
                    ElasticTrace* traces) {
  elastic::with_system(options.material.law, [&]<class System>() {
    elastic::with_limiter(options.limiter, [&]<Limiter limiter>() {
      elastic::side_traces<System, limiter>(tile, side, dt, System(options), traces);
    });
  });
}

}  // namespace mortise
