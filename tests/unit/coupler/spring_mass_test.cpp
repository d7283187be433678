// A third solver coupled by the same schemes: a row of masses on springs, pushed by a gas. While the gas ahead is at
// rest and no shock has formed, the wave that the row sends is simple, and the motion obeys exactly
//   m v' = −k x − (P(v) − p_e),   P the isentropic wall relation of the undisturbed gas.

#include <gtest/gtest.h>

#include <limits>

#include "mortise/coupler/interface_nodes.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/godunov_step.hpp"
#include "unit/coupler/interface_scene.hpp"
#include "unit/coupler/wall_scene.hpp"

namespace mortise {
namespace {

constexpr double ratio_of_heats = 1.4, reference_pressure = 1;

struct MassOnSpring {
  double position = 0, velocity = 0;  // from rest, along x
};

/// Equal masses m on springs k per area side by side along y, free along x; implicit midpoint rule:
///   v̂ = v + (Δt/2m)(t − k x̂), x̂ = x + (Δt/2) v̂, so that v̂ = v_s + t Z⁻¹, Z⁻¹ = (Δt/2m)/(1 + k Δt²/4m).
class SpringMass : public Structure {
 public:
  SpringMass(int faces, double mass, double stiffness, const MassOnSpring& start)
      : mass_(mass), stiffness_(stiffness), now_(std::size_t(faces), start), next_(now_) {}

  std::vector<Point<2>> interface_nodes() const override {
    std::vector<Point<2>> nodes;
    for (std::size_t i = 0; i <= now_.size(); ++i) nodes.push_back({0, double(i) / double(now_.size())});
    return nodes;
  }
  bool periodic() const override { return false; }
  double rate() const override { return std::sqrt(stiffness_ / mass_); }
  std::vector<StructureTrace> traces(double dt, double theta) override {
    const double given = theta * dt / mass_, admittance = given / (1 + theta * dt * stiffness_ * given);
    std::vector<StructureTrace> traces(now_.size());
    for (std::size_t i = 0; i < now_.size(); ++i) {
      traces[i].velocity = {now_[i].velocity * admittance / given, 0};
      traces[i].traction = {stiffness_ * now_[i].position, 0};
      traces[i].admittance(0, 0) = admittance;
    }
    return traces;
  }
  bool step(std::span<const Point<2>> traction, std::span<const Point<2>> velocity, double dt) override {
    for (std::size_t i = 0; i < now_.size(); ++i) {
      const double middle = now_[i].position + 0.5 * dt * velocity[i][0];
      next_[i].position = now_[i].position + dt * velocity[i][0];
      next_[i].velocity = now_[i].velocity + dt / mass_ * (traction[i][0] - stiffness_ * middle);
    }
    return !first_bad();
  }
  void commit(double) override { now_ = next_; }
  std::string first_bad_cell() const override { return first_bad() ? "mass not finite" : ""; }
  const std::vector<MassOnSpring>& masses() const { return now_; }

 private:
  bool first_bad() const {
    for (const MassOnSpring& mass : next_)
      if (!std::isfinite(mass.velocity + mass.position)) return true;
    return false;
  }
  double mass_, stiffness_;
  std::vector<MassOnSpring> now_, next_;
};

/// Gas (1, 0, 1) on a line of cells that move with the wall at its left end.
class GasLine {
 public:
  GasLine(int cells, double length)
      : shape_({cells}), now_(shape_.plane, 3), next_(shape_.plane, 3), h_(length / cells) {
    options_.limiter = Limiter::none;
    for (int i = -2; i < cells + 2; ++i) put(now_, shape_.at(i), to_conserved(Primitive<1>{1, {0}, 1}, ratio_of_heats));
  }
  double spacing() const { return h_; }
  FluidTrace trace(double wall_velocity, double dt) const {
    const Primitive<1> half = wall_trace(tile(wall_velocity, nullptr), false, dt, options_).half;
    return {half.density, {half.velocity[0], 0}, half.pressure};
  }
  bool step(double wall_velocity, double pressure, double dt) {
    const bool admissible = godunov_step(tile(wall_velocity, &pressure), dt, options_).admissible;
    std::swap(now_, next_);
    return admissible;
  }

 private:
  MovingLineTile tile(double wall_velocity, const double* pressure) const {
    return {{&shape_, now_.component(0), next_.component(0), {h_}, nullptr}, wall_velocity, {true, pressure}, {}};
  }
  TileShape<1> shape_;
  TileBlock now_;
  mutable TileBlock next_;
  double h_;
  StepOptions options_;
};

MassOnSpring exact(double mass, double stiffness, MassOnSpring start, double time) {
  const auto slope = [&](const MassOnSpring& s) {
    const double p = isentropic_wall_response(1, 1, s.velocity, ratio_of_heats).pressure;
    return MassOnSpring{s.velocity, (-stiffness * s.position - (p - reference_pressure)) / mass};
  };
  const auto along = [](const MassOnSpring& s, const MassOnSpring& k, double dt) {
    return MassOnSpring{s.position + dt * k.position, s.velocity + dt * k.velocity};
  };
  const int steps = 20000;
  const double dt = time / steps;
  for (int n = 0; n < steps; ++n) {
    const MassOnSpring a = slope(start), b = slope(along(start, a, dt / 2)), c = slope(along(start, b, dt / 2)),
                       d = slope(along(start, c, dt));
    start = along(along(along(along(start, a, dt / 6), b, dt / 3), c, dt / 3), d, dt / 6);
  }
  return start;
}

struct Error {
  double position, velocity;
};

const Error failed{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// Three masses against two fluid faces.
Error error(const std::string& scheme, int cells, double mass) {
  const double stiffness = 2, time = 0.8;
  const MassOnSpring start{0.3, 0};
  SpringMass row(3, mass, stiffness, start);
  GasLine gas(cells, 1.5);
  const std::vector<Point<2>> nodes = row.interface_nodes();
  std::vector<double> s, f = {0, 0.5, 1};
  for (const Point<2>& node : nodes) s.push_back(node[1]);
  const Transfer transfer(s, f, row.periodic());
  const WallLaw law = testing::ideal_gas(ratio_of_heats);
  const std::vector<Point<2>> area(2, Point<2>(0.5, 0));
  const std::vector<double> length(3, 1.0 / 3);
  InterfaceHistory history;
  double w = 0;
  const int steps = int(std::ceil(time * 2 / gas.spacing()));
  for (int n = 0; n < steps; ++n) {
    const double dt = time / steps;
    const std::vector<StructureTrace> structure = row.traces(dt, 0.5);
    const std::vector<FluidTrace> fluid(2, gas.trace(w, dt));
    const InterfaceSolution solution = interface_schemes().at(scheme)(
        {structure, fluid, area, length, &transfer, &law}, history, {.reference_pressure = reference_pressure});
    history.remember(solution);
    w = node_velocities(solution.wall_velocity, row.periodic())[1][0];
    if (!row.step(solution.traction, solution.velocity, dt) || !gas.step(w, solution.pressure[0], dt)) return failed;
    row.commit((n + 1) * dt);
  }
  const MassOnSpring expected = exact(mass, stiffness, start, time), middle = row.masses()[1];
  EXPECT_NEAR(row.masses()[0].velocity, middle.velocity, 1e-12);
  EXPECT_NEAR(row.masses()[2].velocity, middle.velocity, 1e-12);
  EXPECT_LT(expected.velocity, -0.1);
  return {std::abs(middle.position - expected.position), std::abs(middle.velocity - expected.velocity)};
}

TEST(SpringMass, MovesWithTheGasToSecondOrder) {
  for (const char* scheme : {"projection", "traditional", "traditional-subiterated"})
    for (const double mass : {0.3, 3.0}) {
      const Error coarse = error(scheme, 80, mass), fine = error(scheme, 160, mass);
      SCOPED_TRACE(std::string(scheme) + ", mass " + std::to_string(mass));
      EXPECT_LT(fine.position, 1e-5);
      EXPECT_LT(fine.velocity, 1e-4);
      EXPECT_GT(std::log2(coarse.position / fine.position), 1.8);
      EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 1.8);
    }
}

TEST(SpringMass, LightMassesNeedTheProjection) {
  // The structure's impedance 2m/Δt is far below a third of the gas's: extrapolated velocities overshoot more every
  // step.
  EXPECT_LT(error("projection", 40, 1e-4).position, 1e-3);
  EXPECT_LT(error("traditional-subiterated", 40, 1e-4).position, 1e-3);
  EXPECT_GT(error("traditional", 40, 1e-4).position, 1);
}

}  // namespace
}  // namespace mortise
