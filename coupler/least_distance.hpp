// The nearest point of a convex polyhedron: min ½|x|² subject to g_jᵀ x ≥ h_j, by the dual active-set method of
// Goldfarb & Idnani, Math. Program. 27 (1983) 1, with an orthogonal factorisation of the active g_j. Exact in finitely
// many steps, whatever the condition of the g_jᵀ g_k: projected Gauss-Seidel needs of the order of M/m sweeps for a
// body of mass m between two of mass M.
#pragma once

#include <vector>

namespace mortise {

struct LeastDistance {
  std::vector<double> x;            // Σ λ_j g_j
  std::vector<double> multipliers;  // λ_j ≥ 0; 0 where the constraint is not needed
  std::vector<int> violated;        // constraints that contradict others and were left out, ascending
};

/// columns[j] = g_j, all of length `rows`; h as long as `columns`, known up to ± tolerance. Ties are broken by the
/// smaller index: the answer is a function of the input alone.
LeastDistance least_distance(std::size_t rows, const std::vector<std::vector<double>>& columns,
                             const std::vector<double>& h, double tolerance = 0);

}  // namespace mortise
