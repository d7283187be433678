// Loads, stores and sums of states in structure-of-arrays rows, shared by the row kernels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mortise/fluid/godunov_step.hpp"
#include "mortise/fluid/plane_metrics.hpp"
#include "mortise/grids/core/row_workspace.hpp"

namespace mortise::rows {

/// Vector at p of each component, `plane` doubles apart.
template <int Dim>
MORTISE_INLINE Conserved<Dim, Pack> load_conserved(const double* p, std::size_t plane) {
  Conserved<Dim, Pack> U;
  U.density = load(p);
  for (std::size_t d = 0; d < Dim; ++d) U.momentum[d] = load(p + (1 + d) * plane);
  U.energy = load(p + (Dim + 1) * plane);
  return U;
}
template <int Dim>
MORTISE_INLINE void store_conserved(double* p, std::size_t plane, const Conserved<Dim, Pack>& U) {
  store(p, U.density);
  for (std::size_t d = 0; d < Dim; ++d) store(p + (1 + d) * plane, U.momentum[d]);
  store(p + (Dim + 1) * plane, U.energy);
}
template <int Dim>
MORTISE_INLINE Primitive<Dim, Pack> load_primitive(const double* p, std::size_t plane) {
  Primitive<Dim, Pack> W;
  W.density = load(p);
  for (std::size_t d = 0; d < Dim; ++d) W.velocity[d] = load(p + (1 + d) * plane);
  W.pressure = load(p + (Dim + 1) * plane);
  return W;
}
template <int Dim>
MORTISE_INLINE void store_primitive(double* p, std::size_t plane, const Primitive<Dim, Pack>& W) {
  store(p, W.density);
  for (std::size_t d = 0; d < Dim; ++d) store(p + (1 + d) * plane, W.velocity[d]);
  store(p + (Dim + 1) * plane, W.pressure);
}

template <int Dim>
MORTISE_INLINE Conserved<Dim, Pack> select(PackMask m, const Conserved<Dim, Pack>& a, const Conserved<Dim, Pack>& b) {
  Conserved<Dim, Pack> U;
  U.density = mortise::select(m, a.density, b.density);
  for (std::size_t d = 0; d < Dim; ++d) U.momentum[d] = mortise::select(m, a.momentum[d], b.momentum[d]);
  U.energy = mortise::select(m, a.energy, b.energy);
  return U;
}
/// f(a, b) component by component.
template <int Dim, class F>
MORTISE_INLINE Conserved<Dim, Pack> combine(const Conserved<Dim, Pack>& a, const Conserved<Dim, Pack>& b, F f) {
  Conserved<Dim, Pack> U;
  U.density = f(a.density, b.density);
  for (std::size_t d = 0; d < Dim; ++d) U.momentum[d] = f(a.momentum[d], b.momentum[d]);
  U.energy = f(a.energy, b.energy);
  return U;
}
template <int Dim>
MORTISE_INLINE Conserved<Dim, Pack> difference(const Conserved<Dim, Pack>& a, const Conserved<Dim, Pack>& b) {
  return combine<Dim>(a, b, [](Pack f, Pack g) { return f - g; });
}

/// (ρ, ρu, Ẽ) = (1, 0, 1) in all lanes: for lanes that are no cells of the tile.
template <int Dim>
MORTISE_INLINE Conserved<Dim, Pack> valid_state() {
  return {broadcast(1.0), {}, broadcast(1.0)};
}
/// U in the first `count` lanes, a valid state beyond.
template <int Dim>
MORTISE_INLINE Conserved<Dim, Pack> valid_beyond(int count, const Conserved<Dim, Pack>& U) {
  return select<Dim>(lanes_below(count), U, valid_state<Dim>());
}

/// Stores the primitive state of U and, behind it, 1/ρ; of the lanes the first `count` are cells of the tile.
template <int Dim>
MORTISE_INLINE Primitive<Dim, Pack> make_primitive(double* p, std::size_t plane, Conserved<Dim, Pack> U, int count,
                                                   double gamma) {
  if (count < simd_width) U = valid_beyond<Dim>(count, U);
  const Pack inverse = 1.0 / U.density;
  Primitive<Dim, Pack> W;
  W.density = U.density;
  for (std::size_t d = 0; d < Dim; ++d) W.velocity[d] = U.momentum[d] * inverse;
  Pack twice_kinetic = U.momentum[0] * W.velocity[0];
  for (std::size_t d = 1; d < Dim; ++d) twice_kinetic = twice_kinetic + U.momentum[d] * W.velocity[d];
  W.pressure = (gamma - 1) * (U.energy - 0.5 * twice_kinetic);
  store_primitive<Dim>(p, plane, W);
  store(p + (Dim + 2) * plane, inverse);
  return W;
}

/// ε² of Limiter::van_albada by variable.
template <int Dim>
Primitive<Dim> limiter_floor(const StepOptions& options) {
  Primitive<Dim> floor;
  floor.density = options.van_albada_floor[0];
  for (std::size_t d = 0; d < Dim; ++d) floor.velocity[d] = options.van_albada_floor[1 + d];
  floor.pressure = options.van_albada_floor[3];
  return floor;
}

/// Fills row[i] with 1 for the cells i that count in the result and are updated, 0 elsewhere; active (indexed like the
/// row) may be null.
inline void fill_weights(double* row, int nx, const std::uint8_t* active) {
  std::fill(row + row_start, row + nx + simd_width, 0.0);
  for (int i = 0; i < nx; ++i) row[i] = !active || active[i] != 0 ? 1.0 : 0.0;
}

// Checked rates of vectors of cells, Σ_d (|u_d − w_d| + c)/h_d: 0 in the cells that do not count (they may hold
// anything), ∞ in those that count and are not admissible.

/// speed/ρ, checked; `speed` is NaN if p̃ is not positive.
MORTISE_INLINE Pack checked_rate(Pack speed, Pack density, PackMask counts) {
  const Pack safe_density = mortise::select(counts, density, broadcast(1.0));
  const Pack rate = mortise::select(counts, speed, Pack{}) / safe_density;
  const PackMask good = (safe_density > 0) & (rate <= std::numeric_limits<double>::max());
  return mortise::select(good, rate, broadcast(std::numeric_limits<double>::infinity()));
}

/// ρc = √(γp̃ρ) = √(γ(γ − 1)(Ẽρ − ½|ρu|²)); NaN for p̃ ≤ 0.
template <int Dim>
MORTISE_INLINE Pack momentum_of_sound(const Conserved<Dim, Pack>& U, double gamma, PackMask counts) {
  Pack momentum2 = U.momentum[0] * U.momentum[0];
  for (std::size_t d = 1; d < Dim; ++d) momentum2 = momentum2 + U.momentum[d] * U.momentum[d];
  const Pack square = (gamma * (gamma - 1)) * (U.energy * U.density - 0.5 * momentum2);
  const Pack x = mortise::select(counts, square, broadcast(1.0));
  return x * inverse_sqrt(x);
}

MORTISE_INLINE Pack line_rate(const Conserved<1, Pack>& U, double velocity, double inverse_spacing, double gamma,
                              PackMask counts) {
  const Pack speed = abs(U.momentum[0] - U.density * velocity) + momentum_of_sound<1>(U, gamma, counts);
  return checked_rate(speed * inverse_spacing, U.density, counts);
}
MORTISE_INLINE Pack cartesian_rate(const Conserved<2, Pack>& U, const std::array<double, 2>& inverse_spacing,
                                   double gamma, PackMask counts) {
  const Pack speed = (abs(U.momentum[0]) * inverse_spacing[0] + abs(U.momentum[1]) * inverse_spacing[1]) +
                     momentum_of_sound<2>(U, gamma, counts) * (inverse_spacing[0] + inverse_spacing[1]);
  return checked_rate(speed, U.density, counts);
}
/// xi, eta: sums over the opposite faces; lengths: sum of the four |S|, which bounds what the means of S would give.
MORTISE_INLINE Pack curvilinear_rate(const Conserved<2, Pack>& U, const MovingEdge<Pack>& xi,
                                     const MovingEdge<Pack>& eta, Pack lengths, Pack inverse_volume, double gamma,
                                     PackMask counts) {
  const Pack through_xi = abs((U.momentum[0] * xi.sx + U.momentum[1] * xi.sy) - U.density * xi.swept);
  const Pack through_eta = abs((U.momentum[0] * eta.sx + U.momentum[1] * eta.sy) - U.density * eta.swept);
  const Pack speed = (through_xi + through_eta) + momentum_of_sound<2>(U, gamma, counts) * lengths;
  return checked_rate((0.5 * inverse_volume) * speed, U.density, counts);
}

/// The result of a tile from the largest of its checked rates.
inline StepResult result_of(Pack rate) {
  const double fastest = horizontal_max(rate);
  return {fastest, std::isfinite(fastest)};
}

}  // namespace mortise::rows
