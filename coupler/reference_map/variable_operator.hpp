// The matrices A of pressure_solver.hpp for variable density on the whole grid, row by row in whole vectors.
#pragma once

#include <vector>

#include "mortise/coupler/reference_map/pressure_solver.hpp"

namespace mortise {

class VariableOperator {
 public:
  VariableOperator(const PressureProblem& problem, Index<2> points);

  /// density of the cells, rows of grid.cells[0] values.
  void set_density(const double* density);
  double largest_density() const { return largest_density_; }
  /// In the layout below. cells: weights of the west and south edges of cells; nodes: 1/ρ of cells (no south()), 0
  /// beyond sides.
  const double* west() const { return x_.data(); }
  const double* south() const { return y_.data(); }

  /// Points are laid out in rows of stride() doubles with a layer of ghosts around: point (i, j) at (j + 1) stride + i
  /// + 1.
  std::ptrdiff_t stride() const { return stride_; }
  std::ptrdiff_t first() const { return stride_ + 1; }  // offset of point (0, 0)
  std::size_t padded() const { return padded_; }        // doubles of such an array, read or written in whole vectors

  /// Ap = A p in rows without ghosts, points[0] doubles apart (and `slack` doubles to spare); sets the ghosts of p.
  /// Rows of Dirichlet nodes are 0.
  void apply(double* p, double* Ap) const;
  static constexpr std::size_t slack = 8;

 private:
  void set_edges(const double* density);
  void set_cells(const double* density);
  void fill_ghosts(double* p) const;
  void apply_cells(const double* p, double* Ap) const;
  void apply_nodes(const double* p, double* Ap) const;

  PressureProblem problem_;
  Index<2> points_;
  std::ptrdiff_t stride_;
  std::size_t padded_;
  double largest_density_ = 1;
  std::vector<double> x_, y_;  // cells: weights of west and south edges; nodes: 1/ρ of cells (y_ unused)
};

}  // namespace mortise
