// A V-cycle of geometric multigrid for the matrices A of pressure_solver.hpp with variable density, on the whole grid:
// grids twice as coarse as long as the numbers of cells are even, coefficients averaged, bilinear interpolation and its
// transpose between them, two Chebyshev steps before and after, many on the coarsest grid. The cycle is symmetric, as
// conjugate gradients want it, and independent of any order of points. Single precision: a preconditioner needs no
// more, and twice as much of it fits into caches and registers. Sources: Trottenberg, Oosterlee & Schüller, Multigrid
// (2001); Adams, Brezina, Hu & Tuminaro, J. Comput. Phys. 188 (2003) 593 for the smoother.
#pragma once

#include <memory>

#include "mortise/coupler/reference_map/preconditioner.hpp"

namespace mortise {

/// Halving leads from this many cells to a grid that is small enough for the cycle to be worth it.
bool suits_multigrid(const Index<2>& cells);

std::unique_ptr<Preconditioner> make_multigrid(const PressureProblem& problem);

}  // namespace mortise
