// Traditional (Gauss-Seidel in characteristic form): the fluid gets the structure's velocity of earlier steps, v_w, and
// answers with P(v_w); the structure gets that load and computes v_I = v_s + Z⁻¹(t_I − t_s), the next steps' v_w.
// Linear theory, matching faces, b = z_f/z_s: lagged v_w' = −b v_w, extrapolated ζ² + b (2ζ − 1) = 0: unstable iff
// z_s < z_f, z_s < 3 z_f, whatever Δt.

#include "mortise/coupler/schemes/common.hpp"

namespace mortise::schemes {

InterfaceSolution traditional(const InterfaceProblem& problem, const InterfaceHistory& history,
                              const InterfaceOptions& options) {
  if (history.wall_velocity.empty()) return projection(problem, history, options);
  InterfaceSolution solution;
  solution.wall_velocity = predicted(history.wall_velocity, options.lagged);
  const std::vector<double> normal = normal_at_fluid_faces(problem, solution.wall_velocity);
  for (std::size_t b = 0; b < normal.size(); ++b)
    solution.pressure.push_back(FaceFluid(problem, options, b)(normal[b]).pressure);
  solution.load = solution.pressure;
  solution.traction = tractions(problem, solution.load, options);
  solution.velocity = structure_velocity(problem, solution.traction);
  return solution;
}

}  // namespace mortise::schemes
