// A uniform stream: constant (ρ, u, p) whatever the grids do.
#pragma once

#include "mortise/cases/exact/exact_solution.hpp"

namespace mortise {

template <int Dim>
class UniformFlow : public ExactSolution<Dim> {
 public:
  /// Reads initial.state.
  explicit UniformFlow(const CaseDescription& description) {
    const auto& [density, u, v, pressure] = description.initial.state;
    state_.density = density;
    state_.velocity[0] = u;
    if constexpr (Dim > 1) state_.velocity[1] = v;
    state_.pressure = pressure;
  }
  Primitive<Dim> state(const Point<Dim>&, double) const override { return state_; }

 private:
  Primitive<Dim> state_;
};

}  // namespace mortise
