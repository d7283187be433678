// Approximate inverses of the matrices A of pressure_solver.hpp, for conjugate gradients on the whole grid.
#pragma once

#include "mortise/coupler/reference_map/variable_operator.hpp"

namespace mortise {

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;

  /// Once before apply(), and after the density has changed.
  virtual void set(const VariableOperator& matrix) = 0;
  /// z ≈ A⁻¹ r, symmetric and linear; rows of points[0] values. r and z differ.
  virtual void apply(const double* r, double* z) = 0;
  /// eᵀA e ≤ bound() rᵀz for the error e = A⁻¹ r.
  virtual double bound() const = 0;
  /// x + z has at most this part of the error of x, in the norm √(eᵀA e); 1: no more is known.
  virtual double contraction() const { return 1; }
};

}  // namespace mortise
