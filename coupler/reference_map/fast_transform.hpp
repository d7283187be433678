// Direct solution of the pressure equations for constant density on the whole grid: both matrices are sums of products
// of one-dimensional ones, which sines and cosines diagonalise at any combination of ends,
//   cells: A = (h_y/h_x) K ⊗ 1 + (h_x/h_y) 1 ⊗ K,              K → 2 − 2 cos θ;
//   nodes: A = (h_y/h_x) K ⊗ M + (h_x/h_y) M ⊗ K,  M of bilinear elements → (2 + cos θ)/3, relative to a weight ½ at
//   ends.
// O(N log N), no iteration. Plans are made without trial runs: results are the same from run to run and on every rank.
#pragma once

#include <array>
#include <memory>

#include "mortise/coupler/reference_map/pressure_solver.hpp"

namespace mortise {

class FastTransform {
 public:
  /// points: of the whole grid, see WholeGrid; Dirichlet nodes included.
  FastTransform(const PressureProblem& problem, Index<2> points);
  ~FastTransform();

  /// p = A⁻¹ b for density 1, rows of points[0] values; b and p may be the same. Without Dirichlet ends a constant part
  /// of b is dropped and p has mean zero (nodes at Neumann ends weigh ½). Values at Dirichlet nodes become 0.
  void solve(const double* b, double* p);

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace mortise
