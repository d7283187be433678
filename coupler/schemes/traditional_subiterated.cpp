// Traditional, sub-iterated: u → P(u) → v_I → n·v_I, u the wall's normal velocity that the fluid's faces see, repeated
// with u ← u + ω r, r = n·v_I − u, until r = 0; Aitken's relaxation for the whole interface:
//   ω' = −ω r·(r' − r)/|r' − r|², kept within [0.01 ω, 4 ω].
// Without these limits a light structure and a strong wave may throw the iterates from vacuum to shock and back for
// ever. The fixed point is the projection's answer where faces match; elsewhere it couples neighbouring fluid faces
// through the structure's faces they share, which the projection averages. Source: Küttler & Wall, Comput. Mech. 43
// (2008) 61, section 3.2.

#include <algorithm>
#include <cmath>

#include "mortise/coupler/schemes/common.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise::schemes {

namespace {

constexpr double first_relaxation = 0.1;
constexpr double least_growth = 0.01, most_growth = 4;  // of ω per iteration

using Values = std::vector<double>;  // per fluid face

Values pressures(const std::vector<FaceFluid>& fluid, const Values& wall) {
  Values pressure;
  for (const FaceFluid& face : fluid) pressure.push_back(face(wall[face.face()]).pressure);
  return pressure;
}

/// r: the structure's answer to the load of these pressures, less the wall's velocity.
Values residual_of(const InterfaceProblem& problem, const InterfaceOptions& options, const Values& pressure,
                   const Values& wall) {
  const std::vector<Point<2>> velocity = structure_velocity(problem, tractions(problem, pressure, options));
  Values residual = normal_at_fluid_faces(problem, velocity);
  for (std::size_t b = 0; b < wall.size(); ++b) residual[b] -= wall[b];
  return residual;
}

double aitken(double relaxation, const Values& before, const Values& now) {
  double product = 0, square = 0;
  for (std::size_t b = 0; b < now.size(); ++b) {
    const double change = now[b] - before[b];
    product += before[b] * change;
    square += change * change;
  }
  if (square == 0) return relaxation;
  return std::clamp(-relaxation * product / square, least_growth * relaxation, most_growth * relaxation);
}

/// Largest change of a velocity that the residual still asks for, r/(1 + z_f/z_e), over the fastest sound speed.
double largest_change(const std::vector<FaceFluid>& fluid, const std::vector<FaceStructure>& structure,
                      const Values& residual) {
  double largest = 0, fastest = 0;
  for (const FaceFluid& face : fluid) {
    const std::size_t b = face.face();
    const double change = std::abs(residual[b]) / (1 + structure[b].admittance * face.impedance());
    if (!std::isfinite(change)) return change;
    largest = std::max(largest, change);
    fastest = std::max(fastest, face.sound_speed());
  }
  return largest / fastest;
}

Values first_guess(const InterfaceProblem& problem, const InterfaceHistory& history, bool lagged) {
  if (!history.wall_velocity.empty()) return normal_at_fluid_faces(problem, predicted(history.wall_velocity, lagged));
  std::vector<Point<2>> velocity;
  for (const StructureTrace& trace : problem.structure) velocity.push_back(trace.velocity);
  return normal_at_fluid_faces(problem, velocity);
}

}  // namespace

InterfaceSolution traditional_subiterated(const InterfaceProblem& problem, const InterfaceHistory& history,
                                          const InterfaceOptions& options) {
  std::vector<FaceFluid> fluid;
  for (std::size_t b = 0; b < problem.fluid.size(); ++b) fluid.emplace_back(problem, options, b);
  const std::vector<FaceStructure> structure = structure_at_fluid_faces(problem, options);

  Values wall = first_guess(problem, history, options.lagged), before;
  double relaxation = first_relaxation, change = 0;
  for (int iteration = 1; iteration <= options.most_iterations; ++iteration) {
    Values pressure = pressures(fluid, wall);
    const Values residual = residual_of(problem, options, pressure, wall);
    change = largest_change(fluid, structure, residual);
    if (change <= options.tolerance) {
      InterfaceSolution solution = common_answer(problem, options, std::move(pressure), wall);
      solution.iterations = iteration;
      return solution;
    }
    if (!std::isfinite(change)) break;
    if (!before.empty()) relaxation = aitken(relaxation, before, residual);
    for (std::size_t b = 0; b < wall.size(); ++b) wall[b] += relaxation * residual[b];
    before = residual;
  }
  throw NumericalError("sub-iterations at the interface did not converge in " +
                       std::to_string(options.most_iterations) + " iterations: change of velocity over sound speed " +
                       std::to_string(change));
}

}  // namespace mortise::schemes
