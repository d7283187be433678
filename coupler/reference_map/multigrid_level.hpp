// One grid of a multigrid cycle (multigrid.hpp): the matrix of the pressure there, smoothing, and what goes to and
// comes from its neighbours. In single precision.
#pragma once

#include <cstddef>
#include <vector>

#include "mortise/coupler/reference_map/variable_operator.hpp"

namespace mortise {

/// Bounds of the eigenvalues of D⁻¹A that a smoother is to damp.
struct Spectrum {
  float low, high;
};

/// One of the grids. Point (i, j) at first + j stride + i; one layer of ghosts around.
class MultigridLevel {
 public:
  MultigridLevel(PressurePlace place, const std::array<PressureEnd, 4>& ends, Index<2> cells, double aspect);

  Index<2> cells() const { return cells_; }
  std::ptrdiff_t at(int i, int j) const { return first_ + j * stride_ + i; }
  const Index<2>& points() const { return points_; }

  void set_finest(const VariableOperator& matrix);
  void average(const MultigridLevel& fine);

  /// x ≈ A⁻¹ b from x = 0 (or x as it is), in `steps` Chebyshev steps.
  void smooth(bool from_zero, int steps, Spectrum spectrum);
  /// b of this level from b − A x of a finer one.
  void restrict_from(MultigridLevel& fine);
  /// x of this level += x of a coarser one.
  void correct_from(MultigridLevel& coarse);

  Spectrum rough() const;  // what coarser grids do not see
  Spectrum all() const;    // everything but constants
  std::vector<float> b;
  std::vector<float> x;

 private:
  using Array = std::vector<float>;

  bool periodic(std::size_t d) const { return ends_[2 * d] == PressureEnd::periodic; }
  void finish_coefficients();
  void fill_ghosts(Array& q) const;
  template <class Point>
  void for_rows(Point point) const;
  template <PressurePlace place>
  void step(float alpha, float beta);
  template <PressurePlace place>
  void residual();

  PressurePlace place_;
  std::array<PressureEnd, 4> ends_;
  Index<2> cells_, points_;
  std::ptrdiff_t stride_, first_;
  std::size_t size_;
  float along_x_ = 0, along_y_ = 0, across_ = 0, own_ = 0;  // nodes: entries of a cell's matrix
  double aspect_;
  float largest_;           // bound of the eigenvalues of D⁻¹A
  Array west_, south_;      // cells: weights of edges; nodes: 1/ρ of cells (west_)
  Array inverse_diagonal_;  // 0 at Dirichlet nodes
  Array old_, r_;
};

}  // namespace mortise
