// MUSCL-Hancock step of a tile, row by row in one sweep over memory, second order (elastic_step.hpp). Row r is made of
// three loops over short rows that stay in the first-level cache, each with a chain of operations short enough for the
// processor to work on several vectors at once:
//   1. slopes and half step of row r, its face states are stored;
//   2. Riemann problems at the south faces of row r, then finish row r − 1;
//   3. Riemann problems at the west faces of row r.
#pragma once

#include "mortise/solid/geometry.hpp"
#include "mortise/solid/state_rows.hpp"
#include "mortise/solid/step_result.hpp"

namespace mortise::elastic {

template <class System, class Geometry, Limiter limiter>
class StepKernel {
 public:
  StepKernel(const ElasticTile& tile, double dt, const ElasticOptions& options)
      : tile_(tile),
        nx_(tile.shape->cells[0]),
        ny_(tile.shape->cells[1]),
        plane_(tile.shape->plane),
        dt_(dt),
        system_(options),
        work_(nx_, row_count + Geometry::rows),
        stride_(work_.stride()),
        geometry_(tile, dt, work_, row_count) {
    fill_weights(work_.row(weights), nx_, nullptr);
    rows::write(work_.row(east) + row_start - 1, stride_, System::template at_rest<double>());
    for (const int r : {0, 1}) rows::write(half_changes(r) + row_start - 1, stride_, Change<double>{});
  }

  ElasticStepResult run() {
    Findings<System> findings;
    for (int r = -1; r <= ny_; ++r) {
      reconstruct(*this, r);
      if (r >= 0) {
        south_fluxes(*this, r);
        if (r == 0) prescribe_row(r, Side::south, -1);
        if (r == ny_) prescribe_row(r, Side::north, 1);
      }
      if (r >= 1) {
        if (tile_.active) fill_weights(work_.row(weights), nx_, tile_.active + tile_.shape->at(0, r - 1));
        update(*this, r - 1, findings);
      }
      if (r >= 0 && r < ny_) {
        west_fluxes(*this, r);
        prescribe_west(0, r, Side::west, -1);
        prescribe_west(nx_, r, Side::east, 1);
      }
    }
    return findings.result();
  }

 private:
  using State = typename System::template StateOf<Pack>;
  using Flux = typename System::template FluxOf<Pack>;
  template <class T>
  using Change = typename System::template HalfChangeOf<T>;
  // Rows of the workspace: what comes in pairs is indexed by the parity of the tile's row.
  enum Row {
    south = 0,
    west = south + System::numbers,
    east = west + System::numbers,
    north = east + System::numbers,  // a pair
    x_flux = north + 2 * System::numbers,
    y_flux = x_flux + System::flux_numbers,             // a pair
    half_velocity = y_flux + 2 * System::flux_numbers,  // a pair
    half_change = half_velocity + 4,                    // a pair
    weights = half_change + 2 * System::half_change_numbers,
    row_count
  };
  double* pair(Row first, int rows_each, int r) const { return work_.row(first + rows_each * (r & 1)); }
  double* norths(int r) const { return pair(north, System::numbers, r); }
  double* y_fluxes(int r) const { return pair(y_flux, System::flux_numbers, r); }
  double* half_changes(int r) const { return pair(half_change, System::half_change_numbers, r); }
  /// Lanes that are cells −1 … nx.
  MORTISE_INLINE PackMask needed(int i) const { return lanes_below(nx_ + 1 - i) & ~lanes_below(-1 - i); }

  // The loops take a copy of the kernel, so that the stores to the rows cannot change it in the compiler's eyes.

  static void reconstruct(const StepKernel k, int r) {
    const double* const now = k.tile_.now + k.tile_.shape->at(0, r);
    const std::ptrdiff_t pitch = k.tile_.shape->stride;
    double *const souths = k.work_.row(south), *const norths = k.norths(r);
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east);
    double *const velocity = k.pair(half_velocity, 2, r), *const changes = k.half_changes(r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const double* const p = now + i;
      for (std::size_t c = 0; c < System::numbers; ++c) prefetch_read(p + c * k.plane_ + 3 * pitch);
      const auto cell = [&](std::ptrdiff_t offset) { return rows::read<State>(p + offset, k.plane_); };
      State W = cell(0);
      Slopes<State> h = {half_slopes<limiter>(cell(-1), W, cell(1)),
                         half_slopes<limiter>(cell(-pitch), W, cell(pitch))};
      PackMask valid = ~PackMask{};
      if (i < -1 || i + simd_width > k.nx_ + 1) {
        valid = k.needed(i);
        W = choose(valid, W, System::template at_rest<Pack>());
        h = {choose(valid, h.xi, State{}), choose(valid, h.eta, State{})};
      }
      State half = k.system_.half_step(W, h, k.geometry_.half_step_metrics(i, r, valid));
      k.system_.ensure_admissible_faces(W, half, h);
      rows::write(velocity + i, k.stride_, half.velocity);
      rows::write(changes + i, k.stride_, System::half_change(W, half));
      rows::write(wests + i, k.stride_, half - h.xi);
      rows::write(easts + i, k.stride_, half + h.xi);
      rows::write(souths + i, k.stride_, half - h.eta);
      rows::write(norths + i, k.stride_, half + h.eta);
    }
  }

  static void west_fluxes(const StepKernel k, int r) {
    double *const wests = k.work_.row(west), *const easts = k.work_.row(east), *const F = k.work_.row(x_flux);
    const double* const changes = k.half_changes(r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const auto face = k.geometry_.west(i, r);
      const auto change = [&](int at) { return rows::read<Change<Pack>>(changes + at, k.stride_); };
      const Flux flux = k.system_.face(rows::read<State>(easts + i - 1, k.stride_),
                                       rows::read<State>(wests + i, k.stride_), change(i) - change(i - 1), face.normal);
      rows::write(F + i, k.stride_, face.template through<System>(flux));
    }
  }
  static void south_fluxes(const StepKernel k, int r) {
    double *const below = k.norths(r - 1), *const souths = k.work_.row(south), *const G = k.y_fluxes(r);
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      const auto face = k.geometry_.south(i, r);
      const auto change = [&](int row) { return rows::read<Change<Pack>>(k.half_changes(row) + i, k.stride_); };
      const Flux flux =
          k.system_.face(rows::read<State>(below + i, k.stride_), rows::read<State>(souths + i, k.stride_),
                         change(r) - change(r - 1), face.normal);
      rows::write(G + i, k.stride_, face.template through<System>(flux));
    }
  }

  /// Flux of a face whose traction and velocity are given; sign: of the outward direction along increasing index.
  template <class Face>
  auto prescribed(const SideFlux& side, int cell, double sign, const Face& face) const {
    const Point<2>&t = side.traction[cell], &v = side.velocity[cell];
    return face.template through<System>(
        system_.prescribed(Vector<double>{sign * t[0], sign * t[1]}, Vector<double>{v[0], v[1]}, face.normal));
  }
  void prescribe_row(int r, Side which, double sign) const {
    const SideFlux& side = tile_.sides[static_cast<std::size_t>(which)];
    if (!side.present()) return;
    for (int i = 0; i < nx_; ++i)
      rows::write(y_fluxes(r) + i, stride_, prescribed(side, i, sign, geometry_.south_side(i, r)));
  }
  void prescribe_west(int i, int r, Side which, double sign) const {
    const SideFlux& side = tile_.sides[static_cast<std::size_t>(which)];
    if (side.present())
      rows::write(work_.row(x_flux) + i, stride_, prescribed(side, r, sign, geometry_.west_side(i, r)));
  }

  /// Finishes row r. Cells that do not count keep their value.
  static void update(const StepKernel k, int r, Findings<System>& findings) {
    const double *const F = k.work_.row(x_flux), *const G = k.y_fluxes(r), *const above = k.y_fluxes(r + 1);
    const double *const velocity = k.pair(half_velocity, 2, r), *const weight = k.work_.row(weights);
    const double* const now = k.tile_.now + k.tile_.shape->at(0, r);
    double* const next = k.tile_.next + k.tile_.shape->at(0, r);
    const std::size_t u = System::numbers * k.plane_;
    Findings<System> found = findings;
    const std::ptrdiff_t ahead = 2 * k.tile_.shape->stride;
    for (int i = row_start; i < k.nx_ + 2; i += simd_width) {
      for (std::size_t c = 0; c < System::numbers + 2; ++c) prefetch_write(next + c * k.plane_ + i + ahead);
      prefetch_read(now + u + i + ahead), prefetch_read(now + u + k.plane_ + i + ahead);
      const auto gain = k.geometry_.template gain<System>(
          rows::read<Flux>(F + i, k.stride_), rows::read<Flux>(F + i + 1, k.stride_),
          rows::read<Flux>(G + i, k.stride_), rows::read<Flux>(above + i, k.stride_), i, r);
      const PackMask counts = load(weight + i) > 0;
      const State W = rows::read<State>(now + i, k.plane_);
      const State V = k.system_.updated(W, gain);
      const Vector<Pack> before = rows::read<Vector<Pack>>(now + u + i, k.plane_);
      const Vector<Pack> after = before + k.dt_ * rows::read<Vector<Pack>>(velocity + i, k.stride_);
      rows::write(next + i, k.plane_, choose(counts, V, W));
      rows::write(next + u + i, k.plane_,
                  each(after, before, before, [counts](Pack a, Pack b, Pack) { return select(counts, a, b); }));
      found.add(k.system_, V, after, k.geometry_.rate_metrics(i, r), counts);
    }
    findings = found;
  }

  ElasticTile tile_;
  int nx_, ny_;
  std::size_t plane_;
  double dt_;
  System system_;
  RowWorkspace work_;
  std::size_t stride_;
  Geometry geometry_;
};

}  // namespace mortise::elastic
