#include "mortise/coupler/added_mass.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include "mortise/coupler/pseudo_inverse.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr double g = sdirk2_gamma;

/// Fluid next to one face at one instant.
struct WallState {
  double density, normal_velocity, pressure;
};

/// W0 + 2θ (W_half − W0) at t + θ Δt, or W_half if that has no positive density and pressure.
template <int Dim>
WallState at_stage(const WallFace<Dim>& face, double theta) {
  const auto line = [theta](double start, double half) { return start + 2 * theta * (half - start); };
  const WallState state{line(face.density0, face.density_half), line(face.normal_velocity0, face.normal_velocity_half),
                        line(face.pressure0, face.pressure_half)};
  if (state.density > 0 && state.pressure > 0) return state;
  return {face.density_half, face.normal_velocity_half, face.pressure_half};
}

template <int Dim>
std::vector<WallState> wall_states(std::span<const WallFace<Dim>> faces, double theta) {
  std::vector<WallState> states;
  states.reserve(faces.size());
  for (const WallFace<Dim>& face : faces) states.push_back(at_stage(face, theta));
  return states;
}

/// What the fluid does to the body at a velocity y.
template <int Dim>
struct WallLoad {
  BodyVector<Dim> force = BodyVector<Dim>::Zero();       // F = −Σ (P − p∞) e L
  BodyVector<Dim> magnitude = BodyVector<Dim>::Zero();   // Σ (p̃ + |P| + P'|u·n|) |e| L: bounds the round-off of F
  BodyMatrix<Dim> added_mass = BodyMatrix<Dim>::Zero();  // A = Σ P' e eᵀ L

  void add(const BodyVector<Dim>& e, double measure, const WallPressure& wall, double p_inf, const WallState& fluid) {
    force -= (wall.pressure - p_inf) * measure * e;
    const double terms = fluid.pressure + std::abs(wall.pressure) + wall.impedance * std::abs(fluid.normal_velocity);
    magnitude += terms * measure * e.cwiseAbs();
    added_mass += wall.impedance * measure * (e * e.transpose());
  }
};

/// F and A at the velocity y; fills `pressure` (per face).
template <int Dim>
WallLoad<Dim> wall_load(std::span<const WallFace<Dim>> faces, const std::vector<WallState>& states, const WallLaw& law,
                        double p_inf, const BodyVector<Dim>& y, std::vector<double>& pressure) {
  WallLoad<Dim> load;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const BodyVector<Dim> e = generalized_normal<Dim>(faces[i].normal, faces[i].arm);
    const WallPressure wall = law(states[i].density, states[i].pressure, e.dot(y) - states[i].normal_velocity);
    pressure[i] = wall.pressure;
    load.add(e, faces[i].measure, wall, p_inf, states[i]);
  }
  return load;
}

/// The same with the law linearised at d = 0: P = P(0) + P'(0) d.
template <int Dim>
WallLoad<Dim> linear_wall_load(std::span<const WallFace<Dim>> faces, const std::vector<WallState>& states,
                               const WallLaw& law, double p_inf, const BodyVector<Dim>& y) {
  WallLoad<Dim> load;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const BodyVector<Dim> e = generalized_normal<Dim>(faces[i].normal, faces[i].arm);
    WallPressure wall = law(states[i].density, states[i].pressure, 0);
    wall.pressure += wall.impedance * (e.dot(y) - states[i].normal_velocity);
    load.add(e, faces[i].measure, wall, p_inf, states[i]);
  }
  return load;
}

/// J = M + g Δt A.
template <int Dim>
BodyMatrix<Dim> jacobian(const BodyStep<Dim>& step, const BodyMatrix<Dim>& added_mass) {
  BodyMatrix<Dim> J = g * step.dt * added_mass;
  J.diagonal() += step.mass;
  return J;
}

/// Scales that make all free rows of J of order 1: 1/√(m + g Δt tr A11), and for rotations 1/√(I + g Δt ℓ² tr A11).
/// Zero for held degrees of freedom and where there is neither mass nor fluid.
template <int Dim>
BodyVector<Dim> row_scales(const BodyStep<Dim>& step, const BodyMatrix<Dim>& added_mass) {
  const double fluid = g * step.dt * added_mass.diagonal().template head<Dim>().sum();
  BodyVector<Dim> scale;
  for (int k = 0; k < scale.size(); ++k) {
    const double row = step.mass[k] + fluid * (k < Dim ? 1 : step.length * step.length);
    scale[k] = !step.held[static_cast<std::size_t>(k)] && row > 0 ? 1 / std::sqrt(row) : 0;
  }
  return scale;
}

/// One stage: find y with R(y) = M (y − y0) − momentum − g Δt (F(y) + F_ext) = 0.
template <int Dim>
class Stage {
 public:
  Stage(const BodyStep<Dim>& step, std::span<const WallFace<Dim>> faces, const WallLaw& law, int index,
        const BodyVector<Dim>& momentum)
      : step_(step),
        faces_(faces),
        law_(law),
        states_(wall_states(faces, index == 0 ? g : 1)),
        momentum_(momentum),
        external_(step.external[static_cast<std::size_t>(index)]),
        y(step.velocity),
        pressure(faces.size()) {}

  /// Newton's method from the solution of the linearised problem, to round-off.
  void solve() {
    const WallLoad<Dim> linear = linear_wall_load(faces_, states_, law_, step_.p_inf, y);
    scale_ = row_scales(step_, linear.added_mass);
    const BodyMatrix<Dim> J = jacobian(step_, linear.added_mass);
    y -= PseudoInverse(J, scale_) * residual(y, linear);
    const PseudoInverse movable(J, scale_, 1e-8);
    load = wall_load(faces_, states_, law_, step_.p_inf, y, pressure);
    while (!converged_) {
      if (++iterations > 100) fail("100 Newton iterations were not enough");
      iterate();
    }
    if (movable.norm(residual(y, load)) > acceptable * magnitude()) fail("it leaves the fluid behind");
  }

 private:
  static constexpr double round_off = 8 * std::numeric_limits<double>::epsilon();
  static constexpr double acceptable = 1e-11;  // if round-off stops the iteration short of `round_off`

  BodyVector<Dim> residual(const BodyVector<Dim>& at, const WallLoad<Dim>& wall) const {
    return step_.mass.cwiseProduct(at - step_.velocity) - momentum_ - g * step_.dt * (wall.force + external_);
  }

  /// |D ·| of the terms the residual is summed from.
  double magnitude() const {
    const BodyVector<Dim> terms = step_.mass.cwiseProduct(y.cwiseAbs() + step_.velocity.cwiseAbs()) +
                                  momentum_.cwiseAbs() + g * step_.dt * (load.magnitude + external_.cwiseAbs());
    return scale_.cwiseProduct(terms).norm();
  }

  /// One Newton step, halved while the residual grows.
  void iterate() {
    const BodyVector<Dim> R = residual(y, load);
    const PseudoInverse inverse(jacobian(step_, load.added_mass), scale_);
    const double before = inverse.norm(R), terms = magnitude();
    if (!std::isfinite(before)) fail("its wall data or forces are not finite");
    converged_ = before <= round_off * terms;
    if (converged_) return;
    const BodyVector<Dim> full_step = inverse * R;
    std::vector<double> trial_pressure(faces_.size());
    for (double fraction = 1; fraction > 1e-9; fraction /= 2) {
      const BodyVector<Dim> trial = y - fraction * full_step;
      const WallLoad<Dim> trial_load = wall_load(faces_, states_, law_, step_.p_inf, trial, trial_pressure);
      if (inverse.norm(residual(trial, trial_load)) < before) {
        y = trial;
        load = trial_load;
        pressure.swap(trial_pressure);
        return;
      }
    }
    if (before > acceptable * terms) fail("Newton's method cannot reduce the residual");
    converged_ = true;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    std::ostringstream message;
    message << "no velocity of body \"" << step_.name << "\" balances its forces: " << reason << " (mass "
            << step_.mass.transpose() << ", velocity " << step_.velocity.transpose() << ", external force "
            << external_.transpose() << ", " << faces_.size() << " wall faces)";
    throw NumericalError(message.str());
  }

  const BodyStep<Dim>& step_;
  std::span<const WallFace<Dim>> faces_;
  const WallLaw& law_;
  std::vector<WallState> states_;
  BodyVector<Dim> momentum_, external_, scale_;
  bool converged_ = false;

 public:
  BodyVector<Dim> y;             // the stage's velocity
  std::vector<double> pressure;  // per face, at y
  WallLoad<Dim> load;            // at y
  int iterations = 0;
};

template <int Dim>
BodyVector<Dim> pressure_force(std::span<const WallFace<Dim>> faces, const std::vector<double>& pressure,
                               double p_inf) {
  BodyVector<Dim> force = BodyVector<Dim>::Zero();
  for (std::size_t i = 0; i < faces.size(); ++i)
    force -= (pressure[i] - p_inf) * faces[i].measure * generalized_normal<Dim>(faces[i].normal, faces[i].arm);
  return force;
}

}  // namespace

template <int Dim>
BodyMotion<Dim> advance_added_mass(const BodyStep<Dim>& step, std::span<const WallFace<Dim>> faces,
                                   const WallLaw& law) {
  Stage<Dim> first(step, faces, law, 0, BodyVector<Dim>::Zero());
  first.solve();
  const BodyVector<Dim> momentum = (1 - g) / g * step.mass.cwiseProduct(first.y - step.velocity);  // Δt (1 − g) K
  Stage<Dim> second(step, faces, law, 1, momentum);
  second.solve();

  BodyMotion<Dim> motion;
  motion.velocity = second.y;
  motion.mean = (1 - g) * first.y + g * second.y;
  motion.pressure.resize(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    motion.pressure[i] = (1 - g) * first.pressure[i] + g * second.pressure[i];
  motion.force = pressure_force(faces, motion.pressure, step.p_inf);
  motion.added_mass = second.load.added_mass;
  motion.response = impulse_response(step, motion.added_mass);
  motion.iterations = first.iterations + second.iterations;
  return motion;
}

template <int Dim>
BodyMotion<Dim> advance_traditional(const BodyStep<Dim>& step, std::span<const WallFace<Dim>> faces,
                                    const WallLaw& law) {
  if (!traditional_possible(step))
    throw InputError(
        "the traditional scheme divides by mass and inertia, but body \"" + step.name +
        "\" has a free degree of freedom without any: give it mass and inertia > 0 or use the rigid scheme");
  BodyMotion<Dim> motion;
  motion.pressure.resize(faces.size());
  const WallLoad<Dim> load = wall_load(faces, wall_states(faces, 0.5), law, step.p_inf, step.velocity, motion.pressure);
  motion.force = load.force;
  motion.added_mass = load.added_mass;
  motion.response = BodyMatrix<Dim>::Zero();
  for (int k = 0; k < step.mass.size(); ++k)
    if (!step.held[static_cast<std::size_t>(k)]) motion.response(k, k) = 1 / step.mass[k];
  const BodyVector<Dim> external = (1 - g) * step.external[0] + g * step.external[1];
  motion.velocity = step.velocity + step.dt * (motion.response * (motion.force + external));
  motion.mean = step.velocity;
  return motion;
}

template <int Dim>
bool traditional_possible(const BodyStep<Dim>& step) {
  for (std::size_t k = 0; k < step.held.size(); ++k)
    if (!step.held[k] && !(step.mass[static_cast<int>(k)] > 0)) return false;
  return true;
}

template <int Dim>
BodyMatrix<Dim> added_mass_tensor(std::span<const WallFace<Dim>> faces, std::span<const double> impedance) {
  BodyMatrix<Dim> A = BodyMatrix<Dim>::Zero();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const BodyVector<Dim> e = generalized_normal<Dim>(faces[i].normal, faces[i].arm);
    A += impedance[i] * faces[i].measure * (e * e.transpose());
  }
  return A;
}

template <int Dim>
BodyMatrix<Dim> impulse_response(const BodyStep<Dim>& step, const BodyMatrix<Dim>& added_mass) {
  const BodyMatrix<Dim> inverse = PseudoInverse(jacobian(step, added_mass), row_scales(step, added_mass)).matrix();
  return (1 - g) * inverse * step.mass.asDiagonal() * inverse + g * inverse;
}

#define MORTISE_INSTANTIATE(Dim)                                                                            \
  template BodyMotion<Dim> advance_added_mass<Dim>(const BodyStep<Dim>&, std::span<const WallFace<Dim>>,    \
                                                   const WallLaw&);                                         \
  template BodyMotion<Dim> advance_traditional<Dim>(const BodyStep<Dim>&, std::span<const WallFace<Dim>>,   \
                                                    const WallLaw&);                                        \
  template bool traditional_possible<Dim>(const BodyStep<Dim>&);                                            \
  template BodyMatrix<Dim> added_mass_tensor<Dim>(std::span<const WallFace<Dim>>, std::span<const double>); \
  template BodyMatrix<Dim> impulse_response<Dim>(const BodyStep<Dim>&, const BodyMatrix<Dim>&);
MORTISE_INSTANTIATE(1)
MORTISE_INSTANTIATE(2)
#undef MORTISE_INSTANTIATE

}  // namespace mortise
