// MUSCL-Hancock step on a plane Cartesian tile, row by row in one sweep over memory, second order:
//   U' = U − Δt/h_x (F_{i+½} − F_{i−½}) − Δt/h_y (G_{j+½} − G_{j−½}).
// Row r is made of three loops over short rows that stay in the first-level cache, each with a chain of operations
// short enough for the processor to work on several vectors at once:
//   1. make row r + 1 primitive, reconstruct row r and store its face states;
//   2. Riemann problems at the south faces of row r, then finish row r − 1;
//   3. Riemann problems at the west faces of row r.
#pragma once

#include "mortise/fluid/face.hpp"
#include "mortise/fluid/reconstruction.hpp"
#include "mortise/fluid/rows.hpp"

namespace mortise {

template <class Solver, Limiter limiter>
class CartesianKernel {
 public:
  CartesianKernel(const CartesianTile<2>& tile, double dt, const StepOptions& options)
      : tile_(tile),
        nx_(tile.shape->cells[0]),
        ny_(tile.shape->cells[1]),
        plane_(tile.shape->plane),
        gamma_(options.gamma),
        courant_{dt / tile.spacing[0], dt / tile.spacing[1]},
        inverse_spacing_{1 / tile.spacing[0], 1 / tile.spacing[1]},
        floor_(rows::limiter_floor<2>(options)),
        work_(nx_, row_count),
        stride_(work_.stride()) {
    rows::fill_weights(work_.row(weights), nx_, nullptr);
  }

  StepResult run() {
    make_primitive(-2);
    make_primitive(-1);
    Pack rate{};
    for (int r = -1; r <= ny_; ++r) {
      reconstruct(*this, r);
      if (r >= 0) south_fluxes(*this, r);
      if (r >= 1) {
        if (tile_.active) rows::fill_weights(work_.row(weights), nx_, tile_.active + tile_.shape->at(0, r - 1));
        rate = update(*this, r - 1, rate);
      }
      if (r >= 0 && r < ny_) west_fluxes(*this);
    }
    return rows::result_of(rate);
  }

 private:
  using State = Primitive<2, Pack>;
  using Flux = Conserved<2, Pack>;
  // Rows of the workspace: what comes in pairs is indexed by the parity of the tile's row.
  enum Row {
    primitive = 0,
    north = 10,
    south = 18,
    west = 22,
    east = 26,
    x_flux = 30,
    y_flux = 34,
    weights = 42,
    row_count = 43
  };
  double* pair(Row first, int rows_each, int r) const { return work_.row(first + rows_each * (r & 1)); }
  double* primitive_row(int r) const { return pair(primitive, 5, r); }

  void make_primitive(int r) const {
    const double* U = tile_.now + tile_.shape->at(0, r);
    for (int i = row_start; i < nx_ + 2; i += simd_width)
      rows::make_primitive(primitive_row(r) + i, stride_, rows::load_conserved<2>(U + i, plane_), nx_ + 2 - i, gamma_);
  }

  // The loops take a copy of the kernel, so that the stores to the rows cannot change it in the compiler's eyes.

  static void reconstruct(const CartesianKernel k, int r) {
    const std::size_t s = k.stride_;
    double *const here = k.primitive_row(r), *const other = k.primitive_row(r + 1);  // other: r − 1, becomes r + 1
    double *const souths = k.work_.row(south), *const norths = k.pair(north, 4, r);
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east);
    const double* const above = k.tile_.now + k.tile_.shape->at(0, r + 1);
    const std::ptrdiff_t ahead = 2 * k.tile_.shape->stride;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      for (std::size_t c = 0; c < 4; ++c) prefetch_read(above + c * k.plane_ + i + ahead);
      const State below = rows::load_primitive<2>(other + i, s);
      const State next =
          rows::make_primitive(other + i, s, rows::load_conserved<2>(above + i, k.plane_), k.nx_ + 2 - i, k.gamma_);
      const State W = rows::load_primitive<2>(here + i, s);
      HalfSlopes<2, Pack> h = {{limited_half_slopes<limiter>(rows::load_primitive<2>(here + i - 1, s), W,
                                                             rows::load_primitive<2>(here + i + 1, s), k.floor_),
                                limited_half_slopes<limiter>(below, W, next, k.floor_)}};
      State half = half_step(W, load(here + i + 4 * s), h, cartesian_terms(W, h, k.courant_.data()), k.gamma_);
      ensure_positive_faces(W, half, h);
      rows::store_primitive<2>(wests + i, s, half - h[0]);
      rows::store_primitive<2>(easts + i, s, half + h[0]);
      rows::store_primitive<2>(souths + i, s, half - h[1]);
      rows::store_primitive<2>(norths + i, s, half + h[1]);
    }
  }

  static void west_fluxes(const CartesianKernel k) {
    const std::size_t s = k.stride_;
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east), *const F = k.work_.row(x_flux);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width)
      rows::store_conserved<2>(F + i, s,
                               Solver::flux(rows::load_primitive<2>(easts + i - 1, s),
                                            rows::load_primitive<2>(wests + i, s), AxisFace<0>{}, k.gamma_));
  }
  static void south_fluxes(const CartesianKernel k, int r) {
    const std::size_t s = k.stride_;
    double *const below = k.pair(north, 4, r - 1), *const souths = k.work_.row(south), *const G = k.pair(y_flux, 4, r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width)
      rows::store_conserved<2>(G + i, s,
                               Solver::flux(rows::load_primitive<2>(below + i, s),
                                            rows::load_primitive<2>(souths + i, s), AxisFace<1>{}, k.gamma_));
  }

  /// Finishes row r. Cells that do not count keep their value.
  static Pack update(const CartesianKernel k, int r, Pack rate) {
    const std::size_t s = k.stride_;
    const double *const F = k.work_.row(x_flux), *const G = k.pair(y_flux, 4, r),
                        *const above = k.pair(y_flux, 4, r + 1);
    const double* const weight = k.work_.row(weights);
    const double* const now = k.tile_.now + k.tile_.shape->at(0, r);
    double* const next = k.tile_.next + k.tile_.shape->at(0, r);
    const std::ptrdiff_t ahead = 2 * k.tile_.shape->stride;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      for (std::size_t c = 0; c < 4; ++c) prefetch_write(next + c * k.plane_ + i + ahead);
      const PackMask counts = load(weight + i) > 0;
      const Flux dF = rows::difference<2>(rows::load_conserved<2>(F + i + 1, s), rows::load_conserved<2>(F + i, s));
      const Flux dG = rows::difference<2>(rows::load_conserved<2>(above + i, s), rows::load_conserved<2>(G + i, s));
      const Flux change =
          rows::combine<2>(dF, dG, [&](Pack f, Pack g) { return k.courant_[0] * f + k.courant_[1] * g; });
      const Flux U = rows::load_conserved<2>(now + i, k.plane_);
      const Flux V = rows::difference<2>(U, change);
      rows::store_conserved<2>(next + i, k.plane_, rows::select<2>(counts, V, U));
      rate = max(rate, rows::cartesian_rate(V, k.inverse_spacing_, k.gamma_, counts));
    }
    return rate;
  }

  CartesianTile<2> tile_;
  int nx_, ny_;
  std::size_t plane_;
  double gamma_;
  std::array<double, 2> courant_, inverse_spacing_;  // Δt/h_d, 1/h_d
  Primitive<2> floor_;                               // ε² of Limiter::van_albada
  RowWorkspace work_;
  std::size_t stride_;
};

}  // namespace mortise
