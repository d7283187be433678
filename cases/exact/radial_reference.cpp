#include "mortise/cases/exact/radial_reference.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/cases/exact/linear_elasticity.hpp"
#include "mortise/cases/exact/polar.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr double cfl = 0.8;
constexpr double margin = 1.25;  // of the gas's grid beyond the front of the disturbance

double sound_speed(const RadialProblem& problem) {
  return std::sqrt(problem.gamma * (problem.pressure + problem.p_inf) / problem.density);
}

double wave_speed(const Material& material) { return std::sqrt(pressure_modulus(material) / material.density); }

void check(const RadialProblem& problem) {
  const double a = problem.interface_radius;
  if (!(a > 0) || problem.solid_end < 0 || problem.gas_end < 0 ||
      !((problem.solid_end - a) * (problem.gas_end - a) < 0))
    throw InputError("a radial reference solution needs gas and solid on either side of the interface radius " +
                     std::to_string(a) + ", seen the other radii " + std::to_string(problem.gas_end) + " and " +
                     std::to_string(problem.solid_end));
}

/// Where the grid of the gas ends: no farther out than what is disturbed at time_end.
double end_of_gas(const RadialProblem& problem) {
  if (problem.gas_end < problem.interface_radius) return problem.gas_end;
  return std::min(problem.gas_end, problem.interface_radius + margin * sound_speed(problem) * problem.time_end);
}

/// Weights of the cubic through the points 0, 1, 2, 3 at s, and of its derivative.
Eigen::Array4d cubic_weights(double s) {
  return {-(s - 1) * (s - 2) * (s - 3) / 6, s * (s - 2) * (s - 3) / 2, -s * (s - 1) * (s - 3) / 2,
          s * (s - 1) * (s - 2) / 6};
}
Eigen::Array4d cubic_slopes(double s) {
  return {-(3 * s * s - 12 * s + 11) / 6, (3 * s * s - 10 * s + 6) / 2, -(3 * s * s - 8 * s + 3) / 2,
          (3 * s * s - 6 * s + 2) / 6};
}

/// First of four neighbours of the position s among `count` points 0, 1, 2, …
Eigen::Index first_of_four(double s, Eigen::Index count) {
  return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(s)) - 1, 0, count - 4);
}

}  // namespace

Eigen::ArrayXd RadialReference::sample(const Profile& profile, double theta) {
  const double s = theta * static_cast<double>(profile.cols()) - 0.5;
  const Eigen::Index first = first_of_four(s, profile.cols());
  return (profile.middleCols(first, 4).matrix() * cubic_weights(s - static_cast<double>(first)).matrix()).array();
}

/// d/dθ.
Eigen::ArrayXd RadialReference::slope(const Profile& profile, double theta) {
  const double count = static_cast<double>(profile.cols()), s = theta * count - 0.5;
  const Eigen::Index first = first_of_four(s, profile.cols());
  const Eigen::Vector4d weights = count * cubic_slopes(s - static_cast<double>(first)).matrix();
  return (profile.middleCols(first, 4).matrix() * weights).array();
}

RadialReference::Snapshot RadialReference::snapshot_of(RadialCoupling& run) {
  Snapshot snapshot;
  const auto& gas = run.gas().cells();
  snapshot.gas.resize(3, static_cast<Eigen::Index>(gas.size()));
  for (std::size_t i = 0; i < gas.size(); ++i)
    snapshot.gas.col(static_cast<Eigen::Index>(i)) << gas[i].density, gas[i].velocity[0], gas[i].pressure;
  const auto& solid = run.solid().cells();
  snapshot.solid.resize(7, static_cast<Eigen::Index>(solid.size()));
  for (std::size_t i = 0; i < solid.size(); ++i) {
    const RadialElastic& W = solid[i];
    const Eigen::Vector2d& u = run.solid().displacement()[i];
    snapshot.solid.col(static_cast<Eigen::Index>(i)) << W.velocity[0], W.velocity[1], W.stress[0], W.stress[1], W.hoop,
        u[0], u[1];
  }
  const RadialInterface face = run.interface_now();
  snapshot.interface << face.position[0], face.position[1], face.velocity[0], face.velocity[1], face.traction[0],
      face.traction[1], face.pressure;
  return snapshot;
}

/// (4 fine − coarse)/3 at the cells of the coarse grid, which has half as many.
RadialReference::Snapshot RadialReference::extrapolated(const Snapshot& coarse, const Snapshot& fine) {
  const auto profile = [](const Profile& a, const Profile& b) {
    Profile answer(a.rows(), a.cols());
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
      const double theta = (static_cast<double>(i) + 0.5) / static_cast<double>(a.cols());
      answer.col(i) = (4 * sample(b, theta) - a.col(i)) / 3;
    }
    return answer;
  };
  return {profile(coarse.gas, fine.gas), profile(coarse.solid, fine.solid),
          (4 * fine.interface - coarse.interface) / 3};
}

RadialReference::RadialReference(const RadialProblem& problem, int cells, int snapshots)
    : problem_(problem), side_(problem.gas_end > problem.interface_radius ? 1 : -1), gas_end_(end_of_gas(problem)) {
  check(problem);
  const double a = problem.interface_radius, solid_width = std::abs(problem.solid_end - a);
  const double gas_width = std::abs(gas_end_ - a), c_gas = sound_speed(problem), c_solid = wave_speed(problem.material);
  const int gas_cells = std::max(8, static_cast<int>(std::lround(gas_width / solid_width * cells)));
  const double rate = std::max(cells * c_solid / solid_width, gas_cells * c_gas / gas_width);
  const int steps = static_cast<int>(std::ceil(problem.time_end / snapshots * rate / cfl));
  RadialCoupling coarse(problem, gas_end_, cells, gas_cells), fine(problem, gas_end_, 2 * cells, 2 * gas_cells);
  for (int k = 0; k <= snapshots; ++k) {
    if (k > 0) {
      const double t = problem.time_end * k / snapshots;
      coarse.advance_to(t, steps);
      fine.advance_to(t, 2 * steps);
    }
    snapshots_.push_back(extrapolated(snapshot_of(coarse), snapshot_of(fine)));
  }
}

template <class Function>
Eigen::ArrayXd RadialReference::at_time(double t, const Function& of) const {
  const auto count = static_cast<Eigen::Index>(snapshots_.size());
  const double s = std::clamp(t / problem_.time_end, 0.0, 1.0) * static_cast<double>(count - 1);
  const Eigen::Index nearest = std::lround(s);
  if (std::abs(s - static_cast<double>(nearest)) < 1e-9) return of(snapshots_[static_cast<std::size_t>(nearest)]);
  const Eigen::Index first = first_of_four(s, count);
  const Eigen::Array4d weights = cubic_weights(s - static_cast<double>(first));
  Eigen::ArrayXd sum = weights[0] * of(snapshots_[static_cast<std::size_t>(first)]);
  for (Eigen::Index k = 1; k < 4; ++k) sum += weights[k] * of(snapshots_[static_cast<std::size_t>(first + k)]);
  return sum;
}

Primitive<2> RadialReference::state(const Point<2>& x, double t) const {
  const PolarBasis basis(x);
  const double near = interface_now(t).position.norm();
  const double theta = std::max(0.0, (basis.radius - near) / (gas_end_ - near));
  if (theta > 1) return {problem_.density, {0, 0}, problem_.pressure};
  const Eigen::ArrayXd W = at_time(t, [theta](const Snapshot& s) { return sample(s.gas, theta); });
  return {W[0], {W[1] * basis.radial[0], W[1] * basis.radial[1]}, W[2] - problem_.p_inf};
}

ExactSolid RadialReference::solid(const Point<2>& X, double t) const {
  const PolarBasis basis(X);
  const double width = problem_.solid_end - problem_.interface_radius;
  const double theta = (basis.radius - problem_.interface_radius) / width;
  const Eigen::ArrayXd W = at_time(t, [theta](const Snapshot& s) { return sample(s.solid, theta); });
  const Eigen::ArrayXd D = at_time(t, [theta](const Snapshot& s) { return slope(s.solid, theta); }) / width;
  const double inverse = basis.radius > 0 ? 1 / basis.radius : 0;
  const double ur_over_r = basis.radius > 0 ? W[5] * inverse : D[5],
               ut_over_r = basis.radius > 0 ? W[6] * inverse : D[6];
  ExactSolid solid;
  solid.velocity = basis.vector(W[0], W[1]);
  solid.displacement = basis.vector(W[5], W[6]);
  solid.stress = basis.tensor(W[2], W[3], W[3], W[4]);
  solid.gradient = basis.tensor(D[5], -ut_over_r, D[6], ur_over_r);
  return solid;
}

RadialInterface RadialReference::interface_now(double t) const {
  const Eigen::ArrayXd q = at_time(t, [](const Snapshot& s) -> Eigen::ArrayXd { return s.interface; });
  return {{q[0], q[1]}, {q[2], q[3]}, {q[4], q[5]}, q[6]};
}

std::optional<ExactInterface> RadialReference::interface_at(const Point<2>& X, double t) const {
  const PolarBasis basis(X);
  const RadialInterface face = interface_now(t);
  return ExactInterface{basis.vector(face.position[0], face.position[1]),
                        basis.vector(face.velocity[0], face.velocity[1]), face.pressure - problem_.p_inf};
}

double RadialReference::valid_until() const {
  if (side_ < 0) return problem_.time_end;
  return std::min(problem_.time_end, (problem_.gas_end - problem_.interface_radius) / sound_speed(problem_));
}

}  // namespace mortise
