// Projection: one velocity and one pressure for both sides, P(v) − p_e + z_e (v − v_e) = 0 at every fluid face.
// Stable for any ratio of impedances.

#include "mortise/coupler/schemes/common.hpp"

namespace mortise::schemes {

InterfaceSolution projection(const InterfaceProblem& problem, const InterfaceHistory&,
                             const InterfaceOptions& options) {
  const std::vector<FaceStructure> structure = structure_at_fluid_faces(problem, options);
  std::vector<double> velocity(structure.size()), pressure(structure.size());
  for (std::size_t b = 0; b < structure.size(); ++b) {
    const FaceFluid fluid(problem, options, b);
    velocity[b] = wall_velocity(fluid, structure[b], options.reference_pressure);
    pressure[b] = fluid(velocity[b]).pressure;
  }
  return common_answer(problem, options, std::move(pressure), velocity);
}

}  // namespace mortise::schemes
