#include "mortise/coupler/amplification.hpp"

#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "mortise/coupler/body_schemes.hpp"
#include "mortise/coupler/schemes.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Vector = Eigen::VectorXd;

void check_time_step(double dt) {
  if (!(dt > 0) || !std::isfinite(dt)) throw InputError("a time step > 0 is needed, not " + std::to_string(dt));
}

/// Cells of a side from or into a part of a state.
Eigen::Index load_cells(AcousticLine& line, const Vector& state, Eigen::Index at) {
  for (Wave& w : line.cells()) {
    w = {state[at], state[at + 1]};
    at += 2;
  }
  return at;
}
Eigen::Index store_cells(const AcousticLine& line, Vector& state, Eigen::Index at) {
  for (const Wave& w : line.cells()) {
    state[at++] = w[0];
    state[at++] = w[1];
  }
  return at;
}

/// The gas of the linear theory, whatever its state: P = p + z d.
WallLaw acoustic_law(double impedance) {
  return [impedance](double, double pressure, double d) { return WallPressure{pressure + impedance * d, impedance}; };
}

/// Column k is what a step makes of the k-th unit vector.
template <class Machine>
Eigen::MatrixXd matrix_of(Machine& machine) {
  const Eigen::Index size = machine.size();
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index k = 0; k < size; ++k) matrix.col(k) = machine.step(Vector::Unit(size, k));
  return matrix;
}

/// A step of solid and gas; the solid is on the left. Deforming interfaces do the same (deforming.cpp).
class ElasticMachine {
 public:
  explicit ElasticMachine(const ElasticLine& line)
      : line_(line),
        solid_(line.solid, line.order),
        gas_(line.gas, line.order),
        scheme_(interface_schemes().at(line.scheme)),
        law_(acoustic_law(line.gas.impedance)),
        transfer_(ends_, ends_, false),
        unit_(std::sqrt(std::sqrt(line.solid.impedance * line.gas.impedance))) {
    check_time_step(line.time_step);
    if (line.solid_substeps < 1)
      throw InputError("substeps: " + std::to_string(line.solid_substeps) + " is not possible");
    for (const double share : line.gas_shares)
      if (!(share > 0)) throw InputError("shares of a step must be > 0, not " + std::to_string(share));
    if (line.solid_substeps > 1 && !line.gas_shares.empty())
      throw InputError("only one side of an interface can have substeps");
    structure_.admittance(0, 0) = structure_.admittance(1, 1) = 1 / line.solid.impedance;
    options_.nonlinear = false;
    options_.lagged = line.lagged;
  }

  Eigen::Index size() const { return 2 * (line_.solid.cells + line_.gas.cells) + 4; }

  Vector step(const Vector& state) {
    load(state);
    const double dt = line_.time_step;
    if (line_.gas_shares.empty())
      gas_step(dt);
    else
      solid_step_over_several(dt);
    return store();
  }

 private:
  void load(const Vector& state) {
    Eigen::Index at = load_cells(gas_, state, load_cells(solid_, state, 0));
    history_ = {};
    for (int k = 0; k < 2; ++k, at += 2) {
      history_.wall_velocity.push_back({Point<2>(state[at] / unit_, 0)});
      history_.pressure.push_back({state[at + 1] * unit_});
    }
  }
  Vector store() const {
    Vector state(size());
    Eigen::Index at = store_cells(gas_, state, store_cells(solid_, state, 0));
    for (std::size_t k = 0; k < 2; ++k) {
      state[at++] = history_.wall_velocity[k][0][0] * unit_;
      state[at++] = history_.pressure[k][0] / unit_;
    }
    return state;
  }

  /// One step of the gas, the solid taking one or several within it.
  void gas_step(double dt) {
    const AcousticLine::Trace of_gas = gas_.trace(dt);
    const int substeps = line_.solid_substeps;
    const double share = 1.0 / substeps;
    Answer mean;
    for (int k = 0; k < substeps; ++k) {
      const Answer part = ask(solid_.trace(dt * share), 0.5, of_gas, (k + 0.5) * share);
      advance_solid(part, dt * share);
      mean.add(part, share);
    }
    gas_.step(line_.following * mean.wall_velocity, mean.pressure, dt);
    remember(mean);
  }
  /// One step of the solid, the gas taking several within it.
  void solid_step_over_several(double dt) {
    const AcousticLine::Trace of_solid = solid_.trace(dt);
    const double whole = std::accumulate(line_.gas_shares.begin(), line_.gas_shares.end(), 0.0);
    double begun = 0;
    Answer mean;
    for (const double weight : line_.gas_shares) {
      const double share = weight / whole;
      const Answer part = ask(of_solid, begun + 0.5 * share, gas_.trace(dt * share), 0.5);
      gas_.step(line_.following * part.wall_velocity, part.pressure, dt * share);
      remember(part);
      mean.add(part, share);
      begun += share;
    }
    advance_solid(mean, dt);
  }

  /// InterfaceSolution of one face.
  struct Answer {
    double pressure = 0, load = 0, traction = 0, velocity = 0, wall_velocity = 0;
    void add(const Answer& part, double weight) {
      pressure += weight * part.pressure;
      load += weight * part.load;
      traction += weight * part.traction;
      velocity += weight * part.velocity;
      wall_velocity += weight * part.wall_velocity;
    }
  };

  /// The scheme's answer to both sides at their own times θ of their own steps.
  Answer ask(const AcousticLine::Trace& of_solid, double theta_solid, const AcousticLine::Trace& of_gas,
             double theta_gas) {
    const auto at = [](double now, double half, double theta) { return now + 2 * theta * (half - now); };
    const auto velocity = [&](const AcousticLine::Trace& t, double theta) {
      return at(t.velocity_now, t.velocity, theta);
    };
    const auto stress = [&](const AcousticLine::Trace& t, double theta) { return at(t.stress_now, t.stress, theta); };
    structure_.velocity[0] = -velocity(of_solid, theta_solid);
    structure_.traction[0] = -stress(of_solid, theta_solid);
    fluid_.density = line_.gas.impedance / line_.gas.speed;
    fluid_.velocity[0] = velocity(of_gas, theta_gas);
    fluid_.pressure = stress(of_gas, theta_gas);
    const InterfaceProblem problem{{&structure_, 1}, {&fluid_, 1}, {&area_, 1}, {&length_, 1}, &transfer_, &law_};
    const InterfaceSolution all = scheme_(problem, history_, options_);
    return {all.pressure[0], all.load[0], all.traction[0][0], all.velocity[0][0], all.wall_velocity[0][0]};
  }
  void advance_solid(const Answer& answer, double dt) { solid_.step(-answer.velocity, -answer.traction, dt); }
  void remember(const Answer& answer) {
    InterfaceSolution solution;
    solution.velocity = {Point<2>(answer.velocity, 0)};
    solution.load = {answer.load};
    history_.remember(solution);
  }

  static constexpr std::array<double, 2> ends_ = {0, 1};  // of the one face
  ElasticLine line_;
  AcousticLine solid_, gas_;
  InterfaceScheme scheme_;
  WallLaw law_;
  Transfer transfer_;
  double unit_;  // makes velocities and loads in the history alike
  StructureTrace structure_;
  FluidTrace fluid_;
  Point<2> area_ = Point<2>::UnitX();
  double length_ = 1;
  InterfaceOptions options_;
  InterfaceHistory history_;
};

/// A step of a body and its gases, the first one on its right.
class RigidMachine {
 public:
  explicit RigidMachine(const RigidLine& line) : line_(line), scheme_(&body_schemes<1>().at(line.scheme)) {
    check_time_step(line.time_step);
    if (line.gases.empty() || line.gases.size() > 2)
      throw InputError("a body on a line has gas on one or two sides, not on " + std::to_string(line.gases.size()));
    if (!(line.mass >= 0)) throw InputError("a mass ≥ 0 is needed, not " + std::to_string(line.mass));
    double z = 0;
    for (const AcousticSide& side : line.gases) {
      gases_.emplace_back(side, line.order);
      z += side.impedance;
    }
    unit_ = std::sqrt(z);
    base_ = 64 * unit_;
  }

  Eigen::Index size() const {
    Eigen::Index cells = 0;
    for (const AcousticSide& side : line_.gases) cells += side.cells;
    return 2 * cells + 1;
  }

  Vector step(const Vector& state) {
    Eigen::Index at = 0;
    for (AcousticLine& gas : gases_) at = load_cells(gas, state, at);
    const BodyMotion<1> motion = move(state[at] / unit_);
    for (std::size_t k = 0; k < gases_.size(); ++k)
      gases_[k].step(side(k) * motion.mean[0], motion.pressure[k] - base_, line_.time_step);
    Vector next(size());
    at = 0;
    for (const AcousticLine& gas : gases_) at = store_cells(gas, next, at);
    next[at] = motion.velocity[0] * unit_;
    return next;
  }

 private:
  static double side(std::size_t gas) { return gas == 0 ? 1 : -1; }

  /// The scheme tells the two sides' laws apart by the density, which the faces carry unchanged.
  BodyMotion<1> move(double velocity) const {
    BodyStep<1> step;
    step.name = "body";
    step.mass[0] = line_.mass;
    step.velocity[0] = velocity;
    step.dt = line_.time_step;
    step.p_inf = base_;
    std::vector<WallFace<1>> faces(gases_.size());
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const AcousticLine::Trace trace = gases_[k].trace(line_.time_step);
      WallFace<1>& face = faces[k];
      face.normal[0] = side(k);
      face.density0 = face.density_half = line_.gases[k].impedance;
      face.normal_velocity0 = trace.velocity_now;
      face.normal_velocity_half = trace.velocity;
      face.pressure0 = base_ + trace.stress_now;
      face.pressure_half = base_ + trace.stress;
    }
    const WallLaw law = [](double impedance, double pressure, double d) {
      return WallPressure{pressure + impedance * d, impedance};
    };
    return scheme_->advance(step, faces, law);
  }

  RigidLine line_;
  const BodyScheme<1>* scheme_;
  std::vector<AcousticLine> gases_;
  double unit_ = 1;  // √z of both sides
  double base_ = 0;  // pressure at rest: all pressures must be > 0, which the linear law does not mind
};

}  // namespace

Eigen::MatrixXd amplification_matrix(const ElasticLine& line) {
  ElasticMachine machine(line);
  return matrix_of(machine);
}

Eigen::MatrixXd amplification_matrix(const RigidLine& line) {
  RigidMachine machine(line);
  return matrix_of(machine);
}

double spectral_radius(const Eigen::MatrixXd& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix, false);
  if (solver.info() != Eigen::Success) throw NumericalError("eigenvalues of an amplification matrix were not found");
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

double growth_factor(const ElasticLine& line) {
  const double steps = line.gas_shares.empty() ? 1 : static_cast<double>(line.gas_shares.size());
  return std::pow(spectral_radius(amplification_matrix(line)), 1 / steps);
}

double growth_factor(const RigidLine& line) { return spectral_radius(amplification_matrix(line)); }

}  // namespace mortise
