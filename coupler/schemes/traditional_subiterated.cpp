// Traditional, sub-iterated: v_w → P(v_w) → v_I, repeated with v_w ← v_w + ω (v_I − v_w) until v_I = v_w, with Aitken's
// relaxation for the whole interface, r = v_I − v_w of all faces:
//   ω' = −ω r·(r' − r)/|r' − r|².
// The fixed point is the projection's answer where faces match (elsewhere it couples neighbouring faces, the projection
// averages them). Source: Küttler & Wall, Comput. Mech. 43 (2008) 61, section 3.2.

#include "mortise/coupler/schemes/common.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/core/error.hpp"

namespace mortise::schemes {

namespace {

constexpr double first_relaxation = 0.1;

/// The structure's answer to a moving wall.
struct Answer {
  std::vector<double> pressure;
  std::vector<Point<2>> traction, velocity;
};

Answer answer(const InterfaceProblem& problem, const InterfaceOptions& options, const std::vector<FaceFluid>& fluid,
              std::span<const Point<2>> wall) {
  Answer to;
  const std::vector<double> normal = normal_at_fluid_faces(problem, wall);
  for (const FaceFluid& face : fluid) to.pressure.push_back(face(normal[face.face()]).pressure);
  to.traction = tractions(problem, to.pressure, options);
  to.velocity = structure_velocity(problem, to.traction);
  return to;
}

std::vector<Point<2>> difference(const std::vector<Point<2>>& a, const std::vector<Point<2>>& b) {
  std::vector<Point<2>> d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}

double dot(const std::vector<Point<2>>& a, const std::vector<Point<2>>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

double aitken(double relaxation, const std::vector<Point<2>>& before, const std::vector<Point<2>>& now) {
  const std::vector<Point<2>> change = difference(now, before);
  const double square = dot(change, change);
  return square > 0 ? -relaxation * dot(before, change) / square : relaxation;
}

/// Largest change of a velocity that the residual still asks for, over the fastest wave: r/(1 + z_f/z_e)/c.
double largest_change(const InterfaceProblem& problem, const std::vector<FaceFluid>& fluid,
                      const std::vector<FaceStructure>& structure, std::span<const Point<2>> residual) {
  const std::vector<double> normal = normal_at_fluid_faces(problem, residual);
  double largest = 0, fastest = 0;
  for (const FaceFluid& face : fluid) {
    const std::size_t b = face.face();
    const double change = std::abs(normal[b]) / (1 + structure[b].admittance * face.impedance());
    if (!std::isfinite(change)) return change;
    largest = std::max(largest, change);
    fastest = std::max(fastest, face.sound_speed());
  }
  return largest / fastest;
}

}  // namespace

InterfaceSolution traditional_subiterated(const InterfaceProblem& problem, const InterfaceHistory& history,
                                          const InterfaceOptions& options) {
  std::vector<FaceFluid> fluid;
  for (std::size_t b = 0; b < problem.fluid.size(); ++b) fluid.emplace_back(problem, options, b);
  const std::vector<FaceStructure> structure = structure_at_fluid_faces(problem, options);

  std::vector<Point<2>> wall;
  if (history.wall_velocity.empty())
    for (const StructureTrace& trace : problem.structure) wall.push_back(trace.velocity);
  else
    wall = predicted(history.wall_velocity, options.lagged);

  double relaxation = first_relaxation, change = 0;
  std::vector<Point<2>> before;
  for (int iteration = 1; iteration <= options.most_iterations; ++iteration) {
    Answer now = answer(problem, options, fluid, wall);
    const std::vector<Point<2>> residual = difference(now.velocity, wall);
    change = largest_change(problem, fluid, structure, residual);
    if (change <= options.tolerance)
      return {now.pressure, now.pressure, std::move(now.traction), wall, wall, iteration};
    if (!std::isfinite(change)) break;
    if (!before.empty()) relaxation = aitken(relaxation, before, residual);
    for (std::size_t i = 0; i < wall.size(); ++i) wall[i] += relaxation * residual[i];
    before = residual;
  }
  throw NumericalError("sub-iterations at the interface did not converge in " +
                       std::to_string(options.most_iterations) + " iterations: change of velocity over sound speed " +
                       std::to_string(change));
}

}  // namespace mortise::schemes
