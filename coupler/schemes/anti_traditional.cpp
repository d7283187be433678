// Anti-traditional, the mirror image of traditional: the fluid gets the load of earlier steps, p_w, and answers with
// the velocity v at which P(v) = p_w; the structure gets that velocity and computes its load p_e + z_e (v_e − v), the
// next steps' p_w. Both move with the same velocity and feel different pressures, so momentum is not exchanged exactly.
// Linear theory: unstable iff z_f < z_s (lagged), z_f < 3 z_s (extrapolated).

#include "mortise/coupler/schemes/common.hpp"

#include <limits>

#include "mortise/grids/core/error.hpp"

namespace mortise::schemes {

InterfaceSolution anti_traditional(const InterfaceProblem& problem, const InterfaceHistory& history,
                                   const InterfaceOptions& options) {
  if (history.pressure.empty()) return projection(problem, history, options);
  const std::vector<double> pressure = predicted(history.pressure, options.lagged);
  const std::vector<FaceStructure> structure = structure_at_fluid_faces(problem, options);
  const FaceStructure weightless{std::numeric_limits<double>::infinity(), 0};
  std::vector<double> velocity(pressure.size()), load(pressure.size());
  for (std::size_t b = 0; b < pressure.size(); ++b) {
    if (!(structure[b].admittance > 0))
      throw NumericalError("anti-traditional coupling needs a structure that yields: admittance 0 at fluid face " +
                           std::to_string(b));
    velocity[b] = wall_velocity(FaceFluid(problem, options, b), weightless, pressure[b]);
    load[b] = options.reference_pressure + (structure[b].velocity - velocity[b]) / structure[b].admittance;
  }
  InterfaceSolution solution = common_answer(problem, options, std::move(load), velocity);
  solution.pressure = pressure;
  return solution;
}

}  // namespace mortise::schemes
