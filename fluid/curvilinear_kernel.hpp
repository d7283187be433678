// MUSCL-Hancock step on a plane tile of quadrilaterals with moving nodes (plane_metrics.hpp), second order:
//   V' = V + Δt v,  U' = U − Δt/V' (U v + F_{i+½} − F_{i−½} + G_{j+½} − G_{j−½}),  v = Σ_outward w·S,
// which is U'V' = UV − Δt Σ F written so that a grid at rest does not lose digits. Row by row in one sweep over memory,
// in the same loops as cartesian_kernel.hpp; metrics are made in the first of them and live for one row.
#pragma once

#include "mortise/fluid/node_rows.hpp"
#include "mortise/fluid/rows.hpp"
#include "mortise/fluid/wall_slope.hpp"

namespace mortise {

template <class Solver, Limiter limiter>
class CurvilinearKernel {
 public:
  CurvilinearKernel(const CurvilinearTile& tile, double dt, const StepOptions& options)
      : tile_(tile),
        nx_(tile.shape->cells[0]),
        ny_(tile.shape->cells[1]),
        plane_(tile.shape->plane),
        gamma_(options.gamma),
        dt_(dt),
        floor_(rows::limiter_floor<2>(options)),
        work_(nx_, row_count),
        stride_(work_.stride()),
        nodes_(tile, work_.row(zeros)) {
    std::fill_n(work_.row(zeros) + row_start, nx_ + 2 - row_start + simd_width, 0.0);
    rows::fill_weights(work_.row(weights), nx_, nullptr);
  }

  StepResult run() {
    tile_.south.present ? start_at_wall() : start_at_ghosts();
    Pack rate{};
    for (int r = tile_.south.present ? 0 : -1; r <= ny_; ++r) {
      reconstruct(*this, r);
      if (r == 0 && tile_.south.present)
        wall_fluxes(*this);
      else if (r == ny_ && tile_.north_mirror)
        mirror_fluxes(*this);
      else if (r >= 0)
        south_fluxes(*this, r);
      if (r >= 1) {
        if (tile_.active) rows::fill_weights(work_.row(weights), nx_, tile_.active + tile_.shape->at(0, r - 1));
        rate = update(*this, r - 1, rate);
      }
      if (r >= 0 && r < ny_) west_fluxes(*this, r);
    }
    return rows::result_of(rate);
  }

 private:
  using State = Primitive<2, Pack>;
  using Flux = Conserved<2, Pack>;
  using Edge = MovingEdge<Pack>;
  // Rows of the workspace. What comes in pairs is indexed by the parity of the tile's row. Behind an edge is its
  // length.
  enum Row {
    primitive = 0,
    north = 10,
    y_flux = 18,
    south_edge = 26,
    west_edge = 34,
    area = 42,
    south = 44,
    west = 48,
    east = 52,
    x_flux = 56,
    weights = 60,
    zeros = 61,
    row_count = 62
  };
  double* pair(Row first, int rows_each, int r) const { return work_.row(first + rows_each * (r & 1)); }
  double* primitive_row(int r) const { return pair(primitive, 5, r); }

  void start_at_ghosts() const {
    make_primitive(-2);
    make_primitive(-1);
  }
  /// The ghost row of a wall makes the slopes along its normal (wall_slope.hpp).
  void start_at_wall() const {
    make_primitive(0);
    make_primitive(1);
    const double* const far = tile_.now + tile_.shape->at(0, 2);
    double *const wall = primitive_row(0), *const ghost = primitive_row(-1);  // ghost: row 1 until here
    for (int i = row_start; i < nx_ + 2; i += simd_width) {
      const State W = rows::load_primitive<2>(wall + i, stride_), inner = rows::load_primitive<2>(ghost + i, stride_);
      const Flux U = rows::valid_beyond<2>(nx_ + 2 - i, rows::load_conserved<2>(far + i, plane_));
      rows::store_primitive<2>(ghost + i, stride_, beyond_wall<limiter>(W, inner, to_primitive(U, gamma_)));
    }
  }
  void make_primitive(int r) const {
    const double* U = tile_.now + tile_.shape->at(0, r);
    for (int i = row_start; i < nx_ + 2; i += simd_width)
      rows::make_primitive(primitive_row(r) + i, stride_, rows::load_conserved<2>(U + i, plane_), nx_ + 2 - i, gamma_);
  }

  // The loops take a copy of the kernel, so that the stores to the rows cannot change it in the compiler's eyes.

  static void reconstruct(const CurvilinearKernel k, int r) {
    const std::size_t s = k.stride_;
    double *const here = k.primitive_row(r), *const other = k.primitive_row(r + 1);  // other: r − 1, becomes r + 1
    double *const souths = k.work_.row(south), *const norths = k.pair(north, 4, r);
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east);
    const double* const above = k.tile_.now + k.tile_.shape->at(0, r + 1);
    const std::ptrdiff_t ahead = 2 * k.tile_.shape->stride;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      for (std::size_t c = 0; c < 4; ++c) prefetch_read(above + c * k.plane_ + i + ahead);
      k.nodes_.prefetch(i, r + 3);
      const State below = rows::load_primitive<2>(other + i, s);
      const State next =
          rows::make_primitive(other + i, s, rows::load_conserved<2>(above + i, k.plane_), k.nx_ + 2 - i, k.gamma_);
      const State W = rows::load_primitive<2>(here + i, s);
      HalfSlopes<2, Pack> h = {{limited_half_slopes<limiter>(rows::load_primitive<2>(here + i - 1, s), W,
                                                             rows::load_primitive<2>(here + i + 1, s), k.floor_),
                                limited_half_slopes<limiter>(below, W, next, k.floor_)}};
      State half = half_step(W, load(here + i + 4 * s), h, k.terms(W, h, i, r), k.gamma_);
      ensure_positive_faces(W, half, h);
      rows::store_primitive<2>(wests + i, s, half - h[0]);
      rows::store_primitive<2>(easts + i, s, half + h[0]);
      rows::store_primitive<2>(souths + i, s, half - h[1]);
      rows::store_primitive<2>(norths + i, s, half + h[1]);
    }
  }

  /// Makes and keeps the metrics of a vector of cells; the half-step terms from them.
  MORTISE_INLINE HalfStepTerms<2, Pack> terms(const State& W, const HalfSlopes<2, Pack>& h, int i, int r) const {
    const MovingCell<Pack> cell = nodes_.cell(i, r);
    Edge west_face = cell.west(), east_face = cell.east(), south_face = cell.south(), north_face = cell.north();
    Pack volume = cell.area(-0.5 * dt_);
    if (i + simd_width > nx_ + 2) {
      const PackMask cells = lanes_below(nx_ + 2 - i);
      valid_beyond(cells, west_face), valid_beyond(cells, south_face);
      volume = select(cells, volume, broadcast(1.0));
    }
    store_edge(pair(west_edge, 4, r) + i, west_face);
    store_edge(pair(south_edge, 4, r) + i, south_face);
    store(pair(area, 1, r) + i, volume);
    return curvilinear_terms(W, h, west_face + east_face, south_face + north_face, (0.5 * dt_) / volume);
  }
  MORTISE_INLINE static void valid_beyond(PackMask cells, Edge& edge) {
    edge.sx = select(cells, edge.sx, broadcast(1.0));
  }
  MORTISE_INLINE void store_edge(double* p, const Edge& edge) const {
    store(p, edge.sx);
    store(p + stride_, edge.sy);
    store(p + 2 * stride_, edge.swept);
  }
  MORTISE_INLINE Edge load_edge(const double* p) const { return {load(p), load(p + stride_), load(p + 2 * stride_)}; }
  /// The face of an edge; keeps its length.
  MORTISE_INLINE PlaneFace<Pack> face(double* edge) const {
    const Edge e = load_edge(edge);
    const PlaneFace<Pack> plane(e.sx, e.sy, e.swept);
    store(edge + 3 * stride_, plane.area);
    return plane;
  }

  static void west_fluxes(const CurvilinearKernel k, int r) {
    const std::size_t s = k.stride_;
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east), *const F = k.work_.row(x_flux);
    double* const edges = k.pair(west_edge, 4, r);
    if (k.tile_.west_mirror) mirror_state(wests, easts - 1, edges, s);
    if (k.tile_.east_mirror) mirror_state(easts + k.nx_ - 1, wests + k.nx_, edges + k.nx_, s);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width)
      rows::store_conserved<2>(F + i, s,
                               Solver::flux(rows::load_primitive<2>(easts + i - 1, s),
                                            rows::load_primitive<2>(wests + i, s), k.face(edges + i), k.gamma_));
  }
  /// The state on the far side of one face as the mirror image of that on the near side; all in rows of stride s.
  static void mirror_state(const double* near, double* far, const double* edge, std::size_t s) {
    const Primitive<2> W{near[0], {near[s], near[2 * s]}, near[3 * s]};
    const Primitive<2> image = mirrored(W, PlaneFace<double>(edge[0], edge[s], edge[2 * s]));
    far[0] = image.density;
    far[s] = image.velocity[0];
    far[2 * s] = image.velocity[1];
    far[3 * s] = image.pressure;
  }
  static void south_fluxes(const CurvilinearKernel k, int r) {
    const std::size_t s = k.stride_;
    double *const below = k.pair(north, 4, r - 1), *const souths = k.work_.row(south), *const G = k.pair(y_flux, 4, r);
    double* const edges = k.pair(south_edge, 4, r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width)
      rows::store_conserved<2>(G + i, s,
                               Solver::flux(rows::load_primitive<2>(below + i, s),
                                            rows::load_primitive<2>(souths + i, s), k.face(edges + i), k.gamma_));
  }
  /// The north side as a wall: the pressure of the Riemann problem with the mirror image. Nothing passes, to the bit.
  static void mirror_fluxes(const CurvilinearKernel k) {
    double *const below = k.pair(north, 4, k.ny_ - 1), *const G = k.pair(y_flux, 4, k.ny_),
                  *const edges = k.pair(south_edge, 4, k.ny_);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const PlaneFace<Pack> face = k.face(edges + i);
      const State W = rows::load_primitive<2>(below + i, k.stride_);
      const Flux flux = Solver::flux(W, mirrored(W, face), face, k.gamma_);
      rows::store_conserved<2>(G + i, k.stride_, wall_flux<2>(face.over_area2(face.normal(flux.momentum)), face));
    }
  }
  /// The pressure is given per cell of the tile: it is copied to a row that may be read in whole vectors.
  static void wall_fluxes(const CurvilinearKernel k) {
    double *const pressure = k.work_.row(south), *const G = k.pair(y_flux, 4, 0),
                  *const edges = k.pair(south_edge, 4, 0);
    std::copy_n(k.tile_.south.pressure, k.nx_, pressure);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width)
      rows::store_conserved<2>(G + i, k.stride_, wall_flux<2>(load(pressure + i), k.face(edges + i)));
  }

  /// Finishes row r. Cells that do not count keep their value.
  static Pack update(const CurvilinearKernel k, int r, Pack rate) {
    const std::size_t s = k.stride_;
    const double *const F = k.work_.row(x_flux), *const G = k.pair(y_flux, 4, r),
                        *const above = k.pair(y_flux, 4, r + 1);
    const double *const wests = k.pair(west_edge, 4, r), *const souths = k.pair(south_edge, 4, r);
    const double *const norths = k.pair(south_edge, 4, r + 1), *const volumes = k.pair(area, 1, r);
    const double* const weight = k.work_.row(weights);
    const double* const now = k.tile_.now + k.tile_.shape->at(0, r);
    double* const next = k.tile_.next + k.tile_.shape->at(0, r);
    const std::ptrdiff_t ahead = 2 * k.tile_.shape->stride;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      for (std::size_t c = 0; c < 4; ++c) prefetch_write(next + c * k.plane_ + i + ahead);
      const Edge west_face = k.load_edge(wests + i), east_face = k.load_edge(wests + i + 1);
      const Edge south_face = k.load_edge(souths + i), north_face = k.load_edge(norths + i);
      const Pack growth = (east_face.swept - west_face.swept) + (north_face.swept - south_face.swept);
      const Pack inverse_volume = 1.0 / (load(volumes + i) + k.dt_ * growth);
      const Flux dF = rows::difference<2>(rows::load_conserved<2>(F + i + 1, s), rows::load_conserved<2>(F + i, s));
      const Flux dG = rows::difference<2>(rows::load_conserved<2>(above + i, s), rows::load_conserved<2>(G + i, s));
      const Flux outflow = rows::combine<2>(dF, dG, [](Pack f, Pack g) { return f + g; });
      const Flux U = rows::load_conserved<2>(now + i, k.plane_);
      const Pack factor = k.dt_ * inverse_volume;
      const Flux V = rows::combine<2>(U, outflow, [&](Pack u, Pack f) { return u - factor * (u * growth + f); });
      const PackMask counts = load(weight + i) > 0;
      rows::store_conserved<2>(next + i, k.plane_, rows::select<2>(counts, V, U));

      const Pack lengths = (load(wests + i + 3 * s) + load(wests + i + 1 + 3 * s)) +
                           (load(souths + i + 3 * s) + load(norths + i + 3 * s));
      rate = max(rate, rows::curvilinear_rate(V, west_face + east_face, south_face + north_face, lengths,
                                              inverse_volume, k.gamma_, counts));
    }
    return rate;
  }

  CurvilinearTile tile_;
  int nx_, ny_;
  std::size_t plane_;
  double gamma_, dt_;
  Primitive<2> floor_;  // ε² of Limiter::van_albada
  RowWorkspace work_;
  std::size_t stride_;
  rows::NodeRows nodes_;
};

}  // namespace mortise
