// One cell of a conserved field.
#pragma once

#include "mortise/fluid/state.hpp"
#include "mortise/grids/forest/field.hpp"
#include "mortise/grids/geometry/cell_mean.hpp"

namespace mortise {

template <int Dim>
Conserved<Dim> get(const TileBlock& block, std::size_t cell) {
  Conserved<Dim> U;
  U.density = block.component(0)[cell];
  for (int d = 0; d < Dim; ++d) U.momentum[static_cast<std::size_t>(d)] = block.component(1 + d)[cell];
  U.energy = block.component(Dim + 1)[cell];
  return U;
}

template <int Dim>
void put(TileBlock& block, std::size_t cell, const Conserved<Dim>& U) {
  block.component(0)[cell] = U.density;
  for (int d = 0; d < Dim; ++d) block.component(1 + d)[cell] = U.momentum[static_cast<std::size_t>(d)];
  block.component(Dim + 1)[cell] = U.energy;
}

/// Mean over a cell of a smooth conserved state at(x).
template <int Dim, class Function>
Conserved<Dim> mean_state(const Corners<Dim>& corners, Function&& at) {
  const auto mean = cell_mean<Dim>(corners, [&](const Point<Dim>& x) {
    const Conserved<Dim> U = at(x);
    std::array<double, Dim + 2> numbers{U.density};
    for (std::size_t d = 0; d < Dim; ++d) numbers[1 + d] = U.momentum[d];
    numbers[Dim + 1] = U.energy;
    return numbers;
  });
  Conserved<Dim> U;
  U.density = mean[0];
  for (std::size_t d = 0; d < Dim; ++d) U.momentum[d] = mean[1 + d];
  U.energy = mean[Dim + 1];
  return U;
}

/// The components of a state in the order of the field, for interpolation: (ρ, u, p̃) and back.
template <int Dim>
inline void decode(const double* U, double* W, double gamma) {
  Conserved<Dim> c;
  c.density = U[0];
  for (std::size_t d = 0; d < Dim; ++d) c.momentum[d] = U[1 + d];
  c.energy = U[Dim + 1];
  const Primitive<Dim> p = to_primitive(c, gamma);
  W[0] = p.density;
  for (std::size_t d = 0; d < Dim; ++d) W[1 + d] = p.velocity[d];
  W[Dim + 1] = p.pressure;
}

template <int Dim>
inline void encode(const double* W, double* U, double gamma) {
  Primitive<Dim> p;
  p.density = W[0];
  for (std::size_t d = 0; d < Dim; ++d) p.velocity[d] = W[1 + d];
  p.pressure = W[Dim + 1];
  const Conserved<Dim> c = to_conserved(p, gamma);
  U[0] = c.density;
  for (std::size_t d = 0; d < Dim; ++d) U[1 + d] = c.momentum[d];
  U[Dim + 1] = c.energy;
}

}  // namespace mortise
