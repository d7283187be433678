// Fluid state at the faces of a wall: the cell next to it extrapolated with its slope (wall_slope.hpp), at t and, by the
// same Hancock half step as in the kernels (reconstruction.hpp), at t + ½Δt. Second order.
#include "mortise/fluid/line_kernel.hpp"
#include "mortise/fluid/node_rows.hpp"
#include "mortise/fluid/rows.hpp"
#include "mortise/fluid/step_kernels.hpp"
#include "mortise/fluid/wall_slope.hpp"

namespace mortise {
namespace {

Primitive<1> line_cell(const MovingLineTile& tile, int i, double gamma) {
  const double* U = tile.line.now + tile.line.shape->at(i);
  const std::size_t plane = tile.line.shape->plane;
  return to_primitive(Conserved<1>{U[0], {U[plane]}, U[2 * plane]}, gamma);
}

template <Limiter limiter>
WallTrace1 line_trace(const MovingLineTile& tile, bool right_end, double dt, const StepOptions& options) {
  const int last = tile.line.shape->cells[0] - 1;
  const Primitive<1> W = line_cell(tile, right_end ? last : 0, options.gamma);
  const Primitive<1> inner = line_cell(tile, right_end ? last - 1 : 1, options.gamma);
  const Primitive<1> outer = beyond_wall<limiter>(W, inner, line_cell(tile, right_end ? last - 2 : 2, options.gamma));
  HalfSlopes<1, double> h = {{limited_half_slopes<limiter>(right_end ? inner : outer, W, right_end ? outer : inner,
                                                           rows::limiter_floor<1>(options))}};
  WallTrace1 trace;
  trace.now = right_end ? W + h[0] : W - h[0];
  Primitive<1> half =
      half_step(W, 1 / W.density, h, line_terms(W, h, tile.velocity, dt / tile.line.spacing[0]), options.gamma);
  ensure_positive_faces(W, half, h);
  trace.half = right_end ? half + h[0] : half - h[0];
  return trace;
}

/// Traces of a vector of cells along the wall.
struct PlaneTrace {
  Primitive<2, Pack> now, half;
};
template <Limiter limiter>
PlaneTrace plane_trace(const CurvilinearTile& tile, const MovingCell<Pack>& nodes, int i, double dt,
                       const StepOptions& options) {
  const TileShape<2>& shape = *tile.shape;
  const auto state = [&](int column, int row) {
    const int cells = shape.cells[0] + 2 - column;
    return to_primitive(
        rows::valid_beyond<2>(cells, rows::load_conserved<2>(tile.now + shape.at(column, row), shape.plane)),
        options.gamma);
  };
  const Primitive<2> floor = rows::limiter_floor<2>(options);
  const Primitive<2, Pack> W = state(i, 0), inner = state(i, 1);
  HalfSlopes<2, Pack> h = {{limited_half_slopes<limiter>(state(i - 1, 0), W, state(i + 1, 0), floor),
                            limited_half_slopes<limiter>(beyond_wall<limiter>(W, inner, state(i, 2)), W, inner, floor)}};
  PlaneTrace trace;
  trace.now = W - h[1];
  const MovingCell<Pack> cell = nodes.after(0.5 * dt);
  const Pack volume = select(lanes_below(shape.cells[0] - i), nodes.area(0), broadcast(1.0));
  const auto terms =
      curvilinear_terms(W, h, cell.west() + cell.east(), cell.south() + cell.north(), (0.5 * dt) / volume);
  Primitive<2, Pack> half = half_step(W, 1.0 / W.density, h, terms, options.gamma);
  ensure_positive_faces(W, half, h);
  trace.half = half - h[1];
  return trace;
}

Primitive<2> lane_of(const Primitive<2, Pack>& W, int k) {
  return {lane(W.density, k), {lane(W.velocity[0], k), lane(W.velocity[1], k)}, lane(W.pressure, k)};
}

}  // namespace

WallTrace1 wall_trace(const MovingLineTile& tile, bool right_end, double dt, const StepOptions& options) {
  return with_limiter(options.limiter,
                      [&]<Limiter limiter>() { return line_trace<limiter>(tile, right_end, dt, options); });
}

void wall_traces(const CurvilinearTile& tile, double dt, const StepOptions& options, WallTrace2* traces) {
  const int nx = tile.shape->cells[0];
  const RowWorkspace work(nx, 1);
  std::fill(work.row(0) + row_start, work.row(0) + nx + 2, 0.0);
  const rows::NodeRows nodes(tile, work.row(0));
  for (int i = 0; i < nx; i += simd_width) {
    const PlaneTrace trace = with_limiter(options.limiter, [&]<Limiter limiter>() {
      return plane_trace<limiter>(tile, nodes.cell(i, 0), i, dt, options);
    });
    for (int k = 0; k < std::min(simd_width, nx - i); ++k)
      traces[i + k] = {lane_of(trace.now, k), lane_of(trace.half, k)};
  }
}

}  // namespace mortise
