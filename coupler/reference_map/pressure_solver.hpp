// Pressure equations −∇·(1/ρ ∇p) = f on a uniform grid, integrated over a cell's or a node's share of the domain, A p =
// b:
//   cells (MAC projection): (A p)_c = Σ_edges (length/distance) (1/ρ_e) (p_c − p_beyond), 1/ρ_e = 2/(ρ_c + ρ_beyond);
//   nodes (bilinear finite elements): (A p)_a = Σ_cells (1/ρ_c) ∫ ∇φ_a · ∇p.
// A is symmetric and not negative. Where no end is a Dirichlet one p is found up to a constant, and has mean zero.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "mortise/grids/overlap/component_grid.hpp"

namespace mortise {

enum class PressurePlace { cells, nodes };
enum class PressureEnd { periodic, neumann, dirichlet };  // dirichlet: p = 0 at the side itself

struct PressureProblem {
  const ComponentGrid<2>* grid = nullptr;
  PressurePlace place = PressurePlace::cells;
  std::array<PressureEnd, 4> ends{};  // west, east, south, north
  /// Iterations end when the error e of p is small in the norm of kinetic energy, √(eᵀA e) ≤ tolerance √max(pᵀA p,
  /// energy): the error of the velocity correction ∇p/ρ against the correction, or against the flow. Where a solver
  /// does not know √(eᵀA e) it takes ‖b − A p‖/‖b‖.
  double tolerance = 1e-10;

  bool singular() const;  // p is known up to a constant only
};

/// Data live on tiles with the cells' TileShape. Node (i, j) of a tile is the lower left corner of cell (i, j): nodes
/// 0 … nx by 0 … ny belong to a tile, those on common sides to both tiles.
class PressureSolver {
 public:
  virtual ~PressureSolver() = default;

  /// Solves A p = b. right: b. density: of the cells, with one ghost layer; nullptr: 1 everywhere. pressure: the first
  /// guess, becomes the answer, its ghosts filled wherever there are neighbours. energy: of the flow, ∫ρ|v|² for a
  /// correction ∇p/ρ of v; 0 where it is not known. Returns the number of iterations, 0 for direct solution. Throws
  /// NumericalError when the iteration fails. Collective.
  virtual int solve(const Field<2>& right, const Field<2>* density, Field<2>& pressure, double energy) = 0;
};

/// Keys of pressure solvers:
///   automatic  transform where there is no density field, or where the grid cannot be halved often enough; else
///              multigrid;
///   transform  fast sine and cosine transforms: direct for constant density, otherwise conjugate gradients with them
///              as preconditioner (contraction depends on the ratio of densities alone);
///   multigrid  conjugate gradients with a V-cycle of geometric multigrid as preconditioner;
///   hypre      hypre's structured multigrid, distributed over the ranks, for grids that one rank cannot hold.
/// With the first three every rank solves the whole grid alike: bitwise the same on any number of ranks.
std::vector<std::string> pressure_solver_keys();

/// Throws InputError with the nearest key when there is no such solver. The problem's grid has to outlive the solver.
std::unique_ptr<PressureSolver> make_pressure_solver(const std::string& key, const PressureProblem& problem);

}  // namespace mortise
