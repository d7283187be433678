// Pressure equations with variable density on the whole grid, which every rank solves alike: conjugate gradients with a
// preconditioner. Bitwise the same on any number of ranks.
#pragma once

#include <memory>
#include <vector>

#include "mortise/coupler/reference_map/preconditioner.hpp"
#include "mortise/coupler/reference_map/whole_grid.hpp"

namespace mortise {

class VariableSolver : public PressureSolver {
 public:
  /// Collective.
  VariableSolver(const PressureProblem& problem, std::unique_ptr<Preconditioner> preconditioner);

  /// See PressureSolver. density: nullptr is 1.
  int solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double energy) override;

 private:
  using Vector = std::vector<double>;

  void clear_fixed(Vector& v) const;
  void remove_mean(Vector& v) const;
  void turn(const Vector& v, double beta);
  double dot_direction(const Vector& v) const;
  void move(double alpha);
  int iterate(double energy);

  PressureProblem problem_;
  WholeGrid whole_, cells_;
  VariableOperator matrix_;
  std::unique_ptr<Preconditioner> preconditioner_;
  Vector density_, b_, x_, r_, z_, q_, d_;  // d_ in the layout of the matrix, the others without ghosts
};

}  // namespace mortise
