// A third solver beside the gas: a row of masses on springs, coupled by the same code as elastic solids. The gas answers
// with a simple wave until a shock forms, so the motion obeys m ẍ = −k x − (p(ẋ) − p₀), an ordinary differential equation.
#include <gtest/gtest.h>

#include <cmath>

#include "mortise/coupler/simulation.hpp"
#include "unit/fluid/gas_options.hpp"

namespace mortise {
namespace {

using testing::gamma_air;

constexpr double spring_mass = 0.3, stiffness = 2.0, p0 = 1 / gamma_air;

/// A row of independent masses on springs along y; the implicit midpoint rule gives each face its admittance Δt/(2m).
class SpringMasses : public Structure {
 public:
  SpringMasses(int faces, double spacing, double velocity) : spacing_(spacing), position_(static_cast<std::size_t>(faces), 0.0), velocity_(static_cast<std::size_t>(faces), velocity) {}

  std::vector<Point<2>> interface_nodes() const override {
    std::vector<Point<2>> nodes;
    for (std::size_t k = 0; k < position_.size(); ++k) nodes.emplace_back(spacing_ * static_cast<double>(position_.size() - k), 0.0);
    return nodes;
  }
  bool periodic() const override { return true; }
  Point<2> period() const override { return {-spacing_ * static_cast<double>(position_.size()), 0}; }
  double rate() const override { return 0; }
  std::vector<StructureTrace> traces(double dt, double theta) override {
    std::vector<StructureTrace> traces;
    for (std::size_t k = 0; k < position_.size(); ++k) {
      const double spring = stiffness * (position_[k] + theta * dt * velocity_[k]);
      Eigen::Matrix2d admittance = Eigen::Matrix2d::Zero();
      admittance(1, 1) = theta * dt / spring_mass;
      traces.push_back({Point<2>(0, velocity_[k]), Point<2>(0, spring), admittance});
    }
    return traces;
  }
  bool step(std::span<const Point<2>> traction, std::span<const Point<2>>, double dt) override {
    next_position_ = position_;
    next_velocity_ = velocity_;
    for (std::size_t k = 0; k < position_.size(); ++k) {
      const double spring = stiffness * (position_[k] + 0.5 * dt * velocity_[k]);
      next_velocity_[k] += dt * (traction[k][1] - spring) / spring_mass;
      next_position_[k] += 0.5 * dt * (velocity_[k] + next_velocity_[k]);
    }
    return true;
  }
  void commit(double) override {
    position_ = next_position_;
    velocity_ = next_velocity_;
  }
  std::string first_bad_cell() const override { return ""; }

  double position(std::size_t k) const { return position_[k]; }
  double velocity(std::size_t k) const { return velocity_[k]; }

 private:
  double spacing_;
  std::vector<double> position_, velocity_, next_position_, next_velocity_;
};

/// Position and velocity of the mass at time t: fourth-order Runge-Kutta with steps far below the flow's.
std::pair<double, double> exact_motion(double velocity, double t) {
  const auto acceleration = [](double x, double v) {
    return (-stiffness * x - p0 * (std::pow(1 + 0.5 * (gamma_air - 1) * v, 2 * gamma_air / (gamma_air - 1)) - 1)) /
           spring_mass;
  };
  double x = 0, v = velocity;
  const int steps = 4000;
  const double h = t / steps;
  for (int n = 0; n < steps; ++n) {
    const double k1 = acceleration(x, v), k2 = acceleration(x + 0.5 * h * v, v + 0.5 * h * k1);
    const double k3 = acceleration(x + 0.5 * h * v + 0.25 * h * h * k1, v + 0.5 * h * k2);
    const double k4 = acceleration(x + h * v + 0.5 * h * h * k2, v + h * k3);
    x += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {x, v};
}

struct SpringErrors {
  double position, velocity;
};

/// Gas above a row of `faces` masses (gas_faces on its own side) which all begin with the same velocity.
SpringErrors run(int layers, int faces, int gas_faces, double velocity, double end) {
  const double height = 2, h = height / layers, width = 4 * h;
  SimulationSetup<2> setup;
  setup.fluid.options.limiter = Limiter::none;
  setup.fluid.domain.low = Point<2>(0, 0);
  setup.fluid.domain.high = Point<2>(width, height);
  std::vector<Point<2>> near, far;
  for (int i = 0; i < gas_faces; ++i) {
    near.emplace_back(i * width / gas_faces, 0.0);
    far.emplace_back(i * width / gas_faces, height);
  }
  FittedBody<2> grid;
  grid.name = "gas";
  grid.mesh = std::make_shared<GrownGrid>(stretch_between(near, far, layers, h, true, Point<2>(width, 0)));
  grid.shape.spacing = h;
  grid.shape.layers = layers;
  setup.fluid.bodies.push_back(grid);
  // The simple wave of a wall that has just begun to move needs no jump.
  setup.initial = [velocity](const Point<2>& x, double) {
    const double u = velocity * std::exp(-8 * x[1] * x[1]), c = 1 + 0.5 * (gamma_air - 1) * u;
    return Primitive<2>{std::pow(c, 2 / (gamma_air - 1)), {0, u}, p0 * std::pow(c, 2 * gamma_air / (gamma_air - 1))};
  };
  InterfaceSetup interface;
  interface.name = "springs";
  interface.body = 0;
  interface.options.reference_pressure = p0;
  interface.far = far;
  SpringMasses* masses = nullptr;
  setup.structures.push_back({[&](const Communicator&) {
                                auto made = std::make_unique<SpringMasses>(faces, width / faces, velocity);
                                masses = made.get();
                                return made;
                              },
                              interface});
  Simulation<2> simulation(Communicator(), std::move(setup));
  simulation.initialize();
  while (simulation.time() < end) simulation.advance(end);
  const auto [x, v] = exact_motion(velocity, end);
  return {std::fabs(masses->position(1) - x), std::fabs(masses->velocity(1) - v)};
}

TEST(SpringMassStructure, SecondOrderAgainstThePistonRelation) {
  const SpringErrors coarse = run(80, 4, 4, -0.3, 0.8), fine = run(160, 4, 4, -0.3, 0.8);
  EXPECT_LT(fine.position, 1e-5);
  EXPECT_GT(std::log2(coarse.position / fine.position), 1.9);
  EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 1.9);
}

TEST(SpringMassStructure, FacesNeedNotMatch) {
  const SpringErrors matching = run(40, 4, 4, -0.3, 0.8), other = run(40, 7, 4, -0.3, 0.8);
  EXPECT_NEAR(other.position, matching.position, 1e-10);
  EXPECT_NEAR(other.velocity, matching.velocity, 1e-10);
}

}  // namespace
}  // namespace mortise
