#include "mortise/coupler/schemes/common.hpp"

#include <cmath>
#include <limits>

#include "mortise/grids/core/error.hpp"

namespace mortise::schemes {

namespace {

std::size_t number(int face) { return static_cast<std::size_t>(face); }

/// a per fluid face.
std::vector<double> area_ratio(const InterfaceProblem& problem, const InterfaceOptions& options) {
  std::vector<double> ratio(problem.fluid.size(), 1.0);
  if (options.reference_load) return ratio;
  std::vector<double> length(ratio.size(), 0.0);
  for (const Transfer::Piece& piece : problem.transfer->pieces())
    length[number(piece.fluid)] += piece.of_structure * problem.reference_length[number(piece.structure)];
  for (std::size_t b = 0; b < ratio.size(); ++b) ratio[b] = problem.area[b].norm() / length[b];
  return ratio;
}

[[noreturn]] void no_solution(const FaceFluid& fluid, const FaceStructure& structure, double balance) {
  throw NumericalError("no interface solution at fluid face " + std::to_string(fluid.face()) + ": fluid pressure " +
                       std::to_string(fluid.pressure()) + ", velocity " + std::to_string(fluid.velocity()) +
                       ", structure admittance " + std::to_string(structure.admittance) + ", velocity " +
                       std::to_string(structure.velocity) + ", pressure of balance " + std::to_string(balance));
}

/// g and g' at v.
struct Balance {
  double velocity, value, slope;
};

}  // namespace

std::vector<FaceStructure> structure_at_fluid_faces(const InterfaceProblem& problem, const InterfaceOptions& options) {
  const std::vector<double> ratio = area_ratio(problem, options);
  std::vector<FaceStructure> faces(problem.fluid.size());
  for (const Transfer::Piece& piece : problem.transfer->pieces()) {
    const std::size_t b = number(piece.fluid);
    const StructureTrace& trace = problem.structure[number(piece.structure)];
    const Point<2> n = unit(problem.area[b]), given = trace.admittance * n;
    faces[b].admittance += piece.of_fluid * ratio[b] * n.dot(given);
    faces[b].velocity += piece.of_fluid * (n.dot(trace.velocity) - n.dot(trace.admittance * trace.traction));
  }
  return faces;
}

FaceFluid::FaceFluid(const InterfaceProblem& problem, const InterfaceOptions& options, std::size_t face)
    : trace_(problem.fluid[face]), law_(*problem.law), nonlinear_(options.nonlinear), face_(face) {
  velocity_ = unit(problem.area[face]).dot(trace_.velocity);
  impedance_ = law_(trace_.density, trace_.pressure, 0).impedance;
  if (!(trace_.density > 0) || !(impedance_ > 0) || !std::isfinite(impedance_ + velocity_ + trace_.pressure))
    throw NumericalError("inadmissible gas at fluid face " + std::to_string(face) + " of the interface: density " +
                         std::to_string(trace_.density) + ", pressure " + std::to_string(trace_.pressure) +
                         ", normal velocity " + std::to_string(velocity_));
}

WallPressure FaceFluid::operator()(double velocity) const {
  const double d = velocity - velocity_;
  if (nonlinear_) return law_(trace_.density, trace_.pressure, d);
  return {trace_.pressure + impedance_ * d, impedance_};
}

double wall_velocity(const FaceFluid& fluid, const FaceStructure& structure, double balance) {
  const double z = fluid.impedance();
  const double y = structure.admittance, of_velocity = 1 / (1 + y * z);
  const double of_pressure = std::isinf(y) ? 1 / z : y * of_velocity;
  const auto g = [&](double v) {
    const WallPressure wall = fluid(v);
    return Balance{v, of_pressure * (wall.pressure - balance) + of_velocity * (v - structure.velocity),
                   of_pressure * wall.impedance + of_velocity};
  };
  Balance now = g(fluid.velocity() + of_pressure * (balance - fluid.pressure()) +
                  of_velocity * (structure.velocity - fluid.velocity()));
  const double round_off = std::numeric_limits<double>::epsilon() / 2 * fluid.sound_speed();
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (now.value == 0) return now.velocity;
    double step = -now.value / now.slope;
    if (!std::isfinite(step)) break;
    if (std::abs(step) <= round_off) return now.velocity + step;
    Balance next = g(now.velocity + step);
    while (!(std::abs(next.value) < std::abs(now.value))) {
      step /= 2;
      if (std::abs(step) <= round_off || now.velocity + step == now.velocity) return now.velocity;
      next = g(now.velocity + step);
    }
    now = next;
  }
  no_solution(fluid, structure, balance);
}

std::vector<double> normal_at_fluid_faces(const InterfaceProblem& problem, std::span<const Point<2>> of_structure) {
  std::vector<double> normal(problem.fluid.size(), 0.0);
  for (const Transfer::Piece& piece : problem.transfer->pieces())
    normal[number(piece.fluid)] +=
        piece.of_fluid * unit(problem.area[number(piece.fluid)]).dot(of_structure[number(piece.structure)]);
  return normal;
}

std::vector<Point<2>> structure_velocity(const InterfaceProblem& problem, std::span<const Point<2>> traction) {
  std::vector<Point<2>> velocity(traction.size());
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    const StructureTrace& trace = problem.structure[i];
    velocity[i] = trace.velocity + trace.admittance * (traction[i] - trace.traction);
  }
  return velocity;
}

InterfaceSolution common_answer(const InterfaceProblem& problem, const InterfaceOptions& options,
                                std::vector<double> pressure, std::span<const double> velocity) {
  InterfaceSolution solution;
  solution.traction = tractions(problem, pressure, options);
  solution.velocity = structure_velocity(problem, solution.traction);
  if (problem.transfer->matching())
    for (const Transfer::Piece& piece : problem.transfer->pieces()) {
      const Point<2> n = unit(problem.area[number(piece.fluid)]);
      const Point<2> given = problem.structure[number(piece.structure)].admittance * n;
      Point<2>& v = solution.velocity[number(piece.structure)];
      if (n.dot(given) > 0) v += given * ((velocity[number(piece.fluid)] - n.dot(v)) / n.dot(given));
    }
  solution.wall_velocity = solution.velocity;
  solution.load = pressure;
  solution.pressure = std::move(pressure);
  return solution;
}

}  // namespace mortise::schemes
