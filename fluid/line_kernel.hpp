// MUSCL-Hancock step on a line of uniform cells that move together with velocity w, second order:
//   U' = U − Δt/h (F_{i+½} − F_{i−½}),   F the flux through faces that move with w.
#pragma once

#include "mortise/fluid/face.hpp"
#include "mortise/fluid/rows.hpp"
#include "mortise/fluid/wall_slope.hpp"

namespace mortise {

/// Half-step terms of a cell; courant = Δt/h.
template <class T>
MORTISE_INLINE HalfStepTerms<1, T> line_terms(const Primitive<1, T>& W, const HalfSlopes<1, T>& h, double velocity,
                                              double courant) {
  HalfStepTerms<1, T> terms;
  terms.speed[0] = courant * (W.velocity[0] - velocity);
  terms.divergence = courant * h[0].velocity[0];
  terms.force[0] = courant * h[0].pressure;
  return terms;
}

template <class Solver, Limiter limiter>
class LineKernel {
 public:
  LineKernel(const MovingLineTile& tile, double dt, const StepOptions& options)
      : tile_(tile),
        nx_(tile.line.shape->cells[0]),
        plane_(tile.line.shape->plane),
        gamma_(options.gamma),
        courant_(dt / tile.line.spacing[0]),
        floor_(rows::limiter_floor<1>(options)),
        work_(nx_, row_count),
        stride_(work_.stride()) {
    const std::uint8_t* active = tile.line.active;
    rows::fill_weights(work_.row(weights), nx_, active ? active + tile.line.shape->at(0) : nullptr);
  }

  StepResult run() const {
    make_primitive();
    reconstruct();
    solve_riemann_problems();
    if (tile_.left.present) set_wall_flux(0, *tile_.left.pressure);
    if (tile_.right.present) set_wall_flux(nx_, *tile_.right.pressure);
    return update();
  }

 private:
  using State = Primitive<1, Pack>;
  enum Row { primitive = 0, west = 4, east = 7, flux = 10, weights = 13, row_count = 14 };

  void make_primitive() const {
    const double* U = tile_.line.now + tile_.line.shape->at(0);
    double* const W = work_.row(primitive);
    const int end = tile_.right.present ? nx_ : nx_ + 2;  // what lies behind a wall is not read
    for (int i = row_start; i < nx_ + 2; i += simd_width) {
      Conserved<1, Pack> cells = rows::load_conserved<1>(U + i, plane_);
      if (tile_.left.present && i < 0) cells = rows::select<1>(lanes_below(-row_start), rows::valid_state<1>(), cells);
      rows::make_primitive(W + i, stride_, cells, end - i, gamma_);
    }
    if (tile_.left.present) set_ghost(W - 1, 1);
    if (tile_.right.present) set_ghost(W + nx_, -1);
  }
  /// Sets the ghost next to a wall; step: ±1, from it into the gas. Not inlined: both ends must round alike.
  [[gnu::noinline]] void set_ghost(double* ghost, int step) const {
    const auto cell = [&](int k) {
      const double* const w = ghost + k * step;
      return Primitive<1>{w[0], {w[stride_]}, w[2 * stride_]};
    };
    const Primitive<1> W = beyond_wall<limiter>(cell(1), cell(2), cell(3));
    ghost[0] = W.density;
    ghost[stride_] = W.velocity[0];
    ghost[2 * stride_] = W.pressure;
  }
  void reconstruct() const {
    const double* const row = work_.row(primitive);
    double *const wests = work_.row(west), *const easts = work_.row(east);
    for (int i = row_start; i < nx_ + 2; i += simd_width) {
      const State W = rows::load_primitive<1>(row + i, stride_);
      HalfSlopes<1, Pack> h = {{limited_half_slopes<limiter>(rows::load_primitive<1>(row + i - 1, stride_), W,
                                                             rows::load_primitive<1>(row + i + 1, stride_), floor_)}};
      State half = half_step(W, load(row + i + 3 * stride_), h, line_terms(W, h, tile_.velocity, courant_), gamma_);
      ensure_positive_faces(W, half, h);
      rows::store_primitive<1>(wests + i, stride_, half - h[0]);
      rows::store_primitive<1>(easts + i, stride_, half + h[0]);
    }
    if (tile_.left.present) replace_ghost(-1);
    if (tile_.right.present) replace_ghost(nx_);
  }
  /// The ghost cell of a wall made a slope and need not be a valid state: a valid one in its place.
  void replace_ghost(int i) const {
    for (std::size_t c = 0; c < 3; ++c) work_.row(west)[c * stride_ + static_cast<std::size_t>(i)] = 1;
    for (std::size_t c = 0; c < 3; ++c) work_.row(east)[c * stride_ + static_cast<std::size_t>(i)] = 1;
  }
  void solve_riemann_problems() const {
    double *const wests = work_.row(west), *const easts = work_.row(east), *const F = work_.row(flux);
    const SlidingFace face(tile_.velocity);
    for (int i = row_start; i < nx_ + 2; i += simd_width)
      rows::store_conserved<1>(F + i, stride_,
                               Solver::flux(rows::load_primitive<1>(easts + i - 1, stride_),
                                            rows::load_primitive<1>(wests + i, stride_), face, gamma_));
  }
  void set_wall_flux(int i, double pressure) const {
    const Conserved<1> F = wall_flux<1>(pressure, SlidingFace(tile_.velocity));
    double* const row = work_.row(flux) + i;
    row[0] = F.density;
    row[stride_] = F.momentum[0];
    row[2 * stride_] = F.energy;
  }
  StepResult update() const {
    const double *const F = work_.row(flux), *const weight = work_.row(weights);
    const double* const now = tile_.line.now + tile_.line.shape->at(0);
    double* const next = tile_.line.next + tile_.line.shape->at(0);
    Pack rate{};
    for (int i = row_start; i < nx_ + 2; i += simd_width) {
      const auto dF =
          rows::difference<1>(rows::load_conserved<1>(F + i + 1, stride_), rows::load_conserved<1>(F + i, stride_));
      const auto U = rows::load_conserved<1>(now + i, plane_);
      const auto V = rows::combine<1>(U, dF, [&](Pack u, Pack f) { return u - courant_ * f; });
      const PackMask counts = load(weight + i) > 0;
      rows::store_conserved<1>(next + i, plane_, rows::select<1>(counts, V, U));
      rate = max(rate, rows::line_rate(V, tile_.velocity, 1 / tile_.line.spacing[0], gamma_, counts));
    }
    return rows::result_of(rate);
  }

  MovingLineTile tile_;
  int nx_;
  std::size_t plane_;
  double gamma_, courant_;  // courant: Δt/h
  Primitive<1> floor_;      // ε² of Limiter::van_albada
  RowWorkspace work_;
  std::size_t stride_;
};

}  // namespace mortise
