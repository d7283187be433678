#include "mortise/coupler/reference_map/momentum.hpp"

#include "mortise/grids/core/row_workspace.hpp"

namespace mortise {
namespace {

template <FlowSlopes kind>
void slopes_of(const TileShape<2>& shape, const double* velocity, double* slopes) {
  const std::ptrdiff_t s = shape.stride;
  for (std::size_t c = 0; c < 2; ++c)
    for (int j = 0; j < shape.cells[1]; ++j) {
      const double* const q = velocity + c * shape.plane + shape.at(0, j);
      double* const dx = slopes + c * shape.plane + shape.at(0, j);
      double* const dy = dx + 2 * shape.plane;
      for (int i = 0; i < shape.cells[0]; i += simd_width) {
        const Pack middle = load(q + i);
        store(dx + i,
              flow_slope<kind, Pack>(load(q + i - 2), load(q + i - 1), middle, load(q + i + 1), load(q + i + 2)));
        store(dy + i, flow_slope<kind, Pack>(load(q + i - 2 * s), load(q + i - s), middle, load(q + i + s),
                                             load(q + i + 2 * s)));
      }
    }
}

struct Pair {
  Pack x, y;
};

/// ForceTile with what is the same for all cells.
struct Forces {
  explicit Forces(const ForceTile& t)
      : tile(t), stride(t.shape->stride), plane(static_cast<std::ptrdiff_t>(t.shape->plane)) {
    for (int d = 0; d < 2; ++d) {
      inverse[static_cast<std::size_t>(d)] = 1 / t.spacing[d];
      diffusion[static_cast<std::size_t>(d)] = t.viscosity * t.inverse_density / (t.spacing[d] * t.spacing[d]);
    }
  }
  ForceTile tile;
  std::ptrdiff_t stride, plane;
  std::array<double, 2> inverse{}, diffusion{};
};

MORTISE_INLINE Pair pressure_gradient(const Forces& f, std::ptrdiff_t o) {
  const double* const p = f.tile.pressure + o;
  const Pack sw = load(p), se = load(p + 1), nw = load(p + f.stride), ne = load(p + f.stride + 1);
  return {(0.5 * f.inverse[0]) * ((se - sw) + (ne - nw)), (0.5 * f.inverse[1]) * ((nw - sw) + (ne - se))};
}

MORTISE_INLINE Pack diffusion(const Forces& f, const double* q) {
  const Pack twice = 2.0 * load(q);
  return f.diffusion[0] * (load(q + 1) + load(q - 1) - twice) +
         f.diffusion[1] * (load(q + f.stride) + load(q - f.stride) - twice);
}

MORTISE_INLINE Pair stress_divergence(const Forces& f, std::ptrdiff_t o) {
  const double *const x = f.tile.stress_x + o, *const y = f.tile.stress_y + o;
  const auto along_x = [&](std::ptrdiff_t c) { return f.inverse[0] * (load(x + c + 1) - load(x + c)); };
  const auto along_y = [&](std::ptrdiff_t c) { return f.inverse[1] * (load(y + c + f.stride) - load(y + c)); };
  return {along_x(0) + along_y(0), along_x(f.plane) + along_y(f.plane)};
}

template <bool with_pressure, bool with_solids>
MORTISE_INLINE Pair acceleration_at(const Forces& f, std::ptrdiff_t o) {
  Pair force{};
  if constexpr (with_solids) {
    force = stress_divergence(f, o);
    force.x = force.x + load(f.tile.body_force + o);
    force.y = force.y + load(f.tile.body_force + f.plane + o);
  }
  if constexpr (with_pressure) {
    const Pair gradient = pressure_gradient(f, o);
    force = {force.x - gradient.x, force.y - gradient.y};
  }
  if constexpr (with_solids) {
    const Pack volume = 1.0 / load(f.tile.density + o);
    return {f.tile.gravity[0] + volume * force.x, f.tile.gravity[1] + volume * force.y};
  } else {
    return {f.tile.gravity[0] + f.tile.inverse_density * force.x + diffusion(f, f.tile.velocity + o),
            f.tile.gravity[1] + f.tile.inverse_density * force.y + diffusion(f, f.tile.velocity + f.plane + o)};
  }
}

template <bool with_solids>
void acceleration_of(const Forces f, double* acceleration) {
  const TileShape<2>& shape = *f.tile.shape;
  const int nx = shape.cells[0];
  for (int j = -1; j <= shape.cells[1]; ++j) {
    const auto o = static_cast<std::ptrdiff_t>(shape.at(0, j));
    for (int i = row_start; i < nx + 2; i += simd_width) {
      const Pair a = acceleration_at<true, with_solids>(f, o + i);
      store(acceleration + o + i, a.x);
      store(acceleration + f.plane + o + i, a.y);
    }
  }
}

template <bool with_solids>
void advance(const Forces f, const double* velocity, double dt, const double* advection, double* star) {
  const TileShape<2>& shape = *f.tile.shape;
  for (int j = 0; j < shape.cells[1]; ++j) {
    const auto o = static_cast<std::ptrdiff_t>(shape.at(0, j));
    for (std::ptrdiff_t i = o; i < o + shape.cells[0]; i += simd_width) {
      const Pair a = acceleration_at<false, with_solids>(f, i);
      store(star + i, load(velocity + i) + dt * (load(advection + i) + a.x));
      store(star + f.plane + i, load(velocity + f.plane + i) + dt * (load(advection + f.plane + i) + a.y));
    }
  }
}

}  // namespace

void fill_slopes(const TileShape<2>& shape, FlowSlopes kind, const double* velocity, double* slopes) {
  if (kind == FlowSlopes::central)
    slopes_of<FlowSlopes::central>(shape, velocity, slopes);
  else
    slopes_of<FlowSlopes::limited>(shape, velocity, slopes);
}

void fill_acceleration(const ForceTile& tile, double* acceleration) {
  if (tile.density)
    acceleration_of<true>(Forces(tile), acceleration);
  else
    acceleration_of<false>(Forces(tile), acceleration);
}

void advance_momentum(const ForceTile& tile, const double* velocity, double dt, const double* advection, double* star) {
  if (tile.density)
    advance<true>(Forces(tile), velocity, dt, advection, star);
  else
    advance<false>(Forces(tile), velocity, dt, advection, star);
}

void fill_stress(const TileShape<2>& shape, const Point<2>& spacing, const double* velocity, const double* viscosity,
                 const double* given_x, const double* given_y, double* stress_x, double* stress_y) {
  const std::ptrdiff_t s = shape.stride;
  const std::size_t plane = shape.plane;
  const double ax = 1 / spacing[0], ay = 1 / spacing[1];
  for (int j = -1; j <= shape.cells[1] + 1; ++j) {
    const std::size_t first = shape.at(0, j);
    const bool has_west = j <= shape.cells[1];  // the row of cells above needs south edges only
    for (std::ptrdiff_t i = row_start; i < shape.cells[0] + 2; i += simd_width) {
      const std::size_t o = first + static_cast<std::size_t>(i);
      const double *const u = velocity + o, *const v = velocity + plane + o;
      if (has_west) {
        const Pack mu = load(viscosity + o);
        const Pack uy = (0.25 * ay) * ((load(u + s) - load(u - s)) + (load(u + s - 1) - load(u - s - 1)));
        const Pack ux = ax * (load(u) - load(u - 1)), vx = ax * (load(v) - load(v - 1));
        store(stress_x + o, load(given_x + o) + 2.0 * mu * ux);
        store(stress_x + plane + o, load(given_x + plane + o) + mu * (uy + vx));
      }
      const Pack mu = load(viscosity + plane + o);
      const Pack vx = (0.25 * ax) * ((load(v + 1) - load(v - 1)) + (load(v - s + 1) - load(v - s - 1)));
      const Pack uy = ay * (load(u) - load(u - s)), vy = ay * (load(v) - load(v - s));
      store(stress_y + o, load(given_y + o) + mu * (uy + vx));
      store(stress_y + plane + o, load(given_y + plane + o) + 2.0 * mu * vy);
    }
  }
}

void fill_advection(const TileShape<2>& shape, const Point<2>& spacing, const double* x_edges, const double* y_edges,
                    double* advection) {
  const std::ptrdiff_t s = shape.stride, plane = static_cast<std::ptrdiff_t>(shape.plane);
  const double ax = 1 / spacing[0], ay = 1 / spacing[1];
  for (int j = 0; j < shape.cells[1]; ++j) {
    const auto o = static_cast<std::ptrdiff_t>(shape.at(0, j));
    for (std::ptrdiff_t i = o; i < o + shape.cells[0]; i += simd_width) {
      const double *const W = x_edges + i, *const E = W + 1, *const S = y_edges + i, *const N = S + s;
      const Pack uW = load(W), uE = load(E), vS = load(S + plane), vN = load(N + plane);
      store(advection + i, ax * (uW * uW - uE * uE) + ay * (vS * load(S) - vN * load(N)));
      store(advection + plane + i, ax * (uW * load(W + plane) - uE * load(E + plane)) + ay * (vS * vS - vN * vN));
    }
  }
}

void add_rates(const TileShape<2>& shape, const double* velocity, double c, const double* a, const double* b,
               double* result) {
  for (std::size_t k = 0; k < 2; ++k)
    for (int j = 0; j < shape.cells[1]; ++j) {
      const std::size_t o = shape.at(0, j) + k * shape.plane;
      for (std::size_t i = o; i < o + static_cast<std::size_t>(shape.cells[0]); i += simd_width)
        store(result + i, load(velocity + i) + c * (load(a + i) + load(b + i)));
    }
}

}  // namespace mortise
