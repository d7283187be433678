// The fluid state of a case at t = 0 as a function of position.
#pragma once

#include <vector>

#include "mortise/cases/exact/exact_solution.hpp"
#include "mortise/cases/input/expression.hpp"

namespace mortise {

template <int Dim>
class InitialState {
 public:
  /// Throws InputError for an unknown initial.kind and for a faulty formula.
  explicit InitialState(const CaseDescription& description);

  /// (ρ, u, p), physical pressure. Throws InputError where no region contains x.
  Primitive<Dim> operator()(const Point<Dim>& x) const;

 private:
  struct Region {
    std::vector<Expression> where;  // empty: everywhere
    Expression density, velocity_x, velocity_y, pressure;
  };
  std::unique_ptr<ExactSolution<Dim>> flow_;  // uniform, shock, riemann, vortex: their flow at t = 0
  std::vector<Region> regions_;
};

}  // namespace mortise
