#include "mortise/coupler/reference_map/projection.hpp"

#include <cmath>
#include <limits>

#include "mortise/grids/core/row_workspace.hpp"

namespace mortise {
namespace {

/// 1/ρ on the edge between the cells at offsets a and b.
template <bool variable>
MORTISE_INLINE Pack edge_volume(const ProjectionTile& tile, std::size_t a, std::size_t b) {
  if constexpr (variable) return 2.0 / (load(tile.density + a) + load(tile.density + b));
  return broadcast(1 / tile.fluid_density);
}

template <bool variable>
void correct_edges_of(const ProjectionTile tile, const double* q, double* x_edges, double* y_edges) {
  const TileShape<2>& shape = *tile.shape;
  const auto s = static_cast<std::size_t>(shape.stride);
  double* const v = y_edges + shape.plane;
  const double ax = 1 / tile.spacing[0], ay = 1 / tile.spacing[1];
  for (int j = 0; j <= shape.cells[1]; ++j) {
    const std::size_t first = shape.at(0, j);
    if (j < shape.cells[1])
      for (std::size_t o = first; o <= first + static_cast<std::size_t>(shape.cells[0]); o += simd_width)
        store(x_edges + o,
              load(x_edges + o) - ax * edge_volume<variable>(tile, o - 1, o) * (load(q + o) - load(q + o - 1)));
    for (std::size_t o = first; o < first + static_cast<std::size_t>(shape.cells[0]); o += simd_width)
      store(v + o, load(v + o) - ay * edge_volume<variable>(tile, o - s, o) * (load(q + o) - load(q + o - s)));
  }
}

template <bool variable>
void correct_velocity_of(const ProjectionTile tile, double dt, const double* star, const double* p, double* velocity) {
  const TileShape<2>& shape = *tile.shape;
  const std::ptrdiff_t s = shape.stride, plane = static_cast<std::ptrdiff_t>(shape.plane);
  const double cx = 0.5 * dt / tile.spacing[0], cy = 0.5 * dt / tile.spacing[1];
  for (int j = 0; j < shape.cells[1]; ++j) {
    const auto first = static_cast<std::ptrdiff_t>(shape.at(0, j));
    for (std::ptrdiff_t o = first; o < first + shape.cells[0]; o += simd_width) {
      const Pack volume = variable ? 1.0 / load(tile.density + o) : broadcast(1 / tile.fluid_density);
      const Pack sw = load(p + o), se = load(p + o + 1), nw = load(p + o + s), ne = load(p + o + s + 1);
      store(velocity + o, load(star + o) - cx * volume * ((se - sw) + (ne - nw)));
      store(velocity + plane + o, load(star + plane + o) - cy * volume * ((nw - sw) + (ne - se)));
    }
  }
}

}  // namespace

void fill_edge_divergence(const ProjectionTile& tile, const double* x_edges, const double* y_edges, double* right) {
  const TileShape<2>& shape = *tile.shape;
  const double* const v = y_edges + shape.plane;
  const double scale = tile.density ? 1 : tile.fluid_density;
  const double cx = scale * tile.spacing[1], cy = scale * tile.spacing[0], area = scale * tile.spacing.prod();
  for (int j = 0; j < shape.cells[1]; ++j) {
    const std::size_t first = shape.at(0, j);
    for (std::size_t o = first; o < first + static_cast<std::size_t>(shape.cells[0]); o += simd_width) {
      Pack sum = cx * (load(x_edges + o) - load(x_edges + o + 1)) + cy * (load(v + o) - load(v + o + shape.stride));
      if (tile.divergence) sum = sum + area * load(tile.divergence + o);
      store(right + o, sum);
    }
  }
}

void correct_edges(const ProjectionTile& tile, const double* q, double* x_edges, double* y_edges) {
  if (tile.density)
    correct_edges_of<true>(tile, q, x_edges, y_edges);
  else
    correct_edges_of<false>(tile, q, x_edges, y_edges);
}

void fill_nodal_divergence(const ProjectionTile& tile, double dt, const double* star, double* right) {
  const TileShape<2>& shape = *tile.shape;
  const std::ptrdiff_t s = shape.stride;
  const double scale = (tile.density ? 1 : tile.fluid_density) / dt;
  const double cx = 0.5 * scale * tile.spacing[1], cy = 0.5 * scale * tile.spacing[0],
               quarter = 0.25 * scale * tile.spacing.prod();
  for (int j = 0; j <= shape.cells[1]; ++j) {
    const auto first = static_cast<std::ptrdiff_t>(shape.at(0, j));
    for (std::ptrdiff_t o = first; o <= first + shape.cells[0]; o += simd_width) {
      const double *const u = star + o, *const v = u + shape.plane;
      const Pack du = (load(u - s - 1) + load(u - 1)) - (load(u - s) + load(u));
      const Pack dv = (load(v - s - 1) + load(v - s)) - (load(v - 1) + load(v));
      Pack sum = cx * du + cy * dv;
      if (tile.divergence) {
        const double* const d = tile.divergence + o;
        sum = sum + quarter * ((load(d - s - 1) + load(d - s)) + (load(d - 1) + load(d)));
      }
      store(right + o, sum);
    }
  }
}

void correct_velocity(const ProjectionTile& tile, double dt, const double* star, const double* p, double* velocity) {
  if (tile.density)
    correct_velocity_of<true>(tile, dt, star, p, velocity);
  else
    correct_velocity_of<false>(tile, dt, star, p, velocity);
}

FlowMeasure measure(const ProjectionTile& tile, const double* velocity) {
  const TileShape<2>& shape = *tile.shape;
  Pack largest_u{}, largest_v{}, squares{};
  for (int j = 0; j < shape.cells[1]; ++j) {
    const double* const row = velocity + shape.at(0, j);
    for (int i = 0; i < shape.cells[0]; i += simd_width) {
      const PackMask counts = lanes_below(shape.cells[0] - i);
      const Pack u = select(counts, load(row + i), Pack{}), v = select(counts, load(row + shape.plane + i), Pack{});
      largest_u = larger_magnitude(largest_u, u);
      largest_v = larger_magnitude(largest_v, v);
      squares = squares + (u * u + v * v);
    }
  }
  FlowMeasure sum{{horizontal_max(largest_u), horizontal_max(largest_v)}, 0};
  for (int k = 0; k < simd_width; ++k) sum.energy += squares[k];
  sum.energy *= tile.fluid_density * tile.spacing[0] * tile.spacing[1];
  if (!std::isfinite(sum.energy)) sum.largest.setConstant(std::numeric_limits<double>::infinity());
  return sum;
}

}  // namespace mortise
