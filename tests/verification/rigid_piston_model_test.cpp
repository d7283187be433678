// The body equations without a flow solver: a piston of mass m (per area) in a gas that answers with its exact piston
// relation, m v' = p_L(v) − p_R(v) + f(t); acoustic: m v' + z v = f, z = z_L + z_R.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "unit/coupler/wall_scene.hpp"
#include "unit/reference_table.hpp"

namespace mortise {
namespace {

using testing::line_face;
using Vector1 = BodyVector<1>;
using Advance = BodyMotion<1> (*)(const BodyStep<1>&, std::span<const WallFace<1>>, const WallLaw&);

/// Linear gas of one impedance per side: the impedance is passed in the density of the face.
const WallLaw two_impedances = [](double density, double pressure, double d) {
  return WallPressure{pressure + density * d, density};
};

double amplification(Advance advance, double m, double dt, const std::vector<double>& impedances) {
  std::vector<WallFace<1>> faces;
  int normal = -1;
  for (const double z : impedances) faces.push_back(line_face(std::exchange(normal, 1), z, 0, 1));
  const BodyStep<1> step{.name = "piston",
                         .mass = Vector1(m),
                         .velocity = Vector1(1),
                         .dt = dt,
                         .p_inf = 1};  // p_inf = 1: no force at rest even with gas on one side
  return advance(step, faces, two_impedances).velocity[0];
}

TEST(RigidPistonModel, AddedMassIsStableForEveryMass) {
  const double g = sdirk2_gamma, z = 2, dt = 0.1;
  for (const double m : {0.0, 1e-300, 1e-8, 1e-3, 1e-1, 1.0, 1e3, 1e12}) {
    const double zeta = amplification(&advance_added_mass<1>, m, dt, {z});
    const double beta = z * dt / m;  // ζ = (1 − (1 − 2g) β)/(1 + g β)² of the Runge-Kutta method, 0 at m = 0
    const double expected = m == 0 ? 0 : (1 / beta - (1 - 2 * g)) / (1 / beta + 2 * g + g * g * beta);
    EXPECT_NEAR(zeta, expected, 2e-15) << "mass " << m;
    EXPECT_LT(std::abs(zeta), 1) << "mass " << m;
  }
}

double stability_threshold(const std::vector<double>& impedances, double dt) {
  double unstable = 1e-6, stable = 1e6;
  for (int i = 0; i < 100; ++i) {
    const double m = std::sqrt(unstable * stable);
    (std::abs(amplification(&advance_traditional<1>, m, dt, impedances)) > 1 ? unstable : stable) = m;
  }
  return stable;
}

TEST(RigidPistonModel, TraditionalIsUnstableBelowHalfTheAddedMass) {
  for (const double dt : {0.01, 0.5}) {
    EXPECT_NEAR(stability_threshold({3}, dt), 3 * dt / 2, 1e-12);
    EXPECT_NEAR(stability_threshold({3, 0.25}, dt), (3 + 0.25) * dt / 2, 1e-12);  // gas on both sides: z_L + z_R
  }
  for (const double m : {0.02, 0.5, 7.0})
    EXPECT_NEAR(amplification(&advance_traditional<1>, m, 0.1, {3}), 1 - 3 * 0.1 / m, 1e-13);  // ζ = 1 − β
}

struct ModelErrors {
  double velocity, position;
};

/// v = 1 + sin 3t between two moving gases; the external force makes up for what is missing.
ModelErrors manufactured_errors(double m, int steps) {
  const double end = 2, dt = end / steps, z[] = {0.7, 2.5};
  const auto v = [](double t) { return 1 + std::sin(3 * t); };
  const auto x = [](double t) { return t + (1 - std::cos(3 * t)) / 3; };
  const auto u = [](int side, double t) { return side == 0 ? std::cos(2 * t) : 0.5 * t; };
  const auto p = [](int side, double t) { return side == 0 ? 2 + std::cos(t) : 1.5 + std::sin(4 * t); };
  const auto pull = [&](double t) {
    return m * 3 * std::cos(3 * t) - (p(0, t) - z[0] * (v(t) - u(0, t))) + (p(1, t) + z[1] * (v(t) - u(1, t)));
  };
  Vector1 velocity(v(0));
  double position = 0, worst = 0, worst_position = 0;
  for (int n = 0; n < steps; ++n) {
    const double t = n * dt;
    BodyStep<1> step{.name = "piston", .mass = Vector1(m), .velocity = velocity, .dt = dt};
    step.external = {Vector1(pull(t + sdirk2_gamma * dt)), Vector1(pull(t + dt))};
    std::vector<WallFace<1>> faces;
    for (const int side : {0, 1}) {
      WallFace<1> face = line_face(side == 0 ? -1 : 1, z[side], u(side, t), p(side, t));
      face.pressure_half = p(side, t + dt / 2);
      face.normal_velocity_half = face.normal[0] * u(side, t + dt / 2);
      faces.push_back(face);
    }
    const BodyMotion<1> motion = advance_added_mass<1>(step, faces, two_impedances);
    velocity = motion.velocity;
    position += dt * motion.mean[0];
    worst = std::max(worst, std::abs(velocity[0] - v(t + dt)));
    worst_position = std::max(worst_position, std::abs(position - x(t + dt)));
  }
  return {worst, worst_position};
}

TEST(RigidPistonModel, AddedMassHasOrderTwoForEveryMass) {
  for (const double m : {0.0, 1e-8, 1e-3, 1.0, 1e3}) {
    const ModelErrors coarse = manufactured_errors(m, 200), fine = manufactured_errors(m, 400);
    EXPECT_LT(fine.velocity, 1e-3) << "mass " << m;
    EXPECT_LT(fine.position, 1e-3) << "mass " << m;
    EXPECT_GT(std::log2(coarse.velocity / fine.velocity), 1.9) << "mass " << m;
    EXPECT_GT(std::log2(coarse.position / fine.position), 1.9) << "mass " << m;
  }
}

/// The exact wall pressure while no shock has reached or left the wall.
const WallLaw simple_wave = [](double density, double pressure, double d) {
  const WallResponse wall = isentropic_wall_response(density, pressure, d, 1.4);
  return WallPressure{wall.pressure, wall.impedance};
};

/// Largest errors of v and x against a reference history with gas at rest on both sides; `per_row` steps a row.
ModelErrors reference_errors(const std::string& file, double m, const WallFace<1>& left, const WallFace<1>& right,
                             const std::function<double(double)>& pull, int per_row) {
  const auto rows = testing::reference_table(file);
  Vector1 velocity(0);
  double position = 0;
  ModelErrors worst{0, 0};
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const double start = testing::number(rows[row - 1], "t");
    const double dt = (testing::number(rows[row], "t") - start) / per_row;
    for (int n = 0; n < per_row; ++n) {
      BodyStep<1> step{.name = "piston", .mass = Vector1(m), .velocity = velocity, .dt = dt};
      step.external = {Vector1(pull(start + (n + sdirk2_gamma) * dt)), Vector1(pull(start + (n + 1) * dt))};
      const BodyMotion<1> motion = advance_added_mass<1>(step, std::vector<WallFace<1>>{left, right}, simple_wave);
      velocity = motion.velocity;
      position += dt * motion.mean[0];
    }
    worst.velocity = std::max(worst.velocity, std::abs(velocity[0] - testing::number(rows[row], "v_b")));
    worst.position = std::max(worst.position, std::abs(position - testing::number(rows[row], "x_b")));
  }
  return worst;
}

void expect_second_order(const std::function<ModelErrors(int)>& errors) {
  const ModelErrors coarse = errors(4), fine = errors(8);
  EXPECT_LT(fine.velocity, 1e-4);
  EXPECT_LT(fine.position, 1e-4);
  EXPECT_NEAR(std::log2(coarse.velocity / fine.velocity), 2, 0.15);
  EXPECT_NEAR(std::log2(coarse.position / fine.position), 2, 0.15);
}

TEST(RigidPistonModel, ReferencePistons) {
  using std::numbers::pi;
  expect_second_order([&](int per_row) {
    const auto pull = [&](double t) { return t < 1 ? 0.5 * std::pow(std::sin(pi * t), 4) : 0.0; };
    return reference_errors("rigid_piston_1_body.csv", 0.5, line_face(-1, 1, 0, 1), line_face(1, 1, 0, 1), pull,
                            per_row);
  });
  expect_second_order([](int per_row) {
    return reference_errors(
        "rigid_piston_4_body.csv", 1, line_face(-1, 1, 0, 1), line_face(1, 0.125, 0, 0.1), [](double) { return 0.0; },
        per_row);
  });
}

}  // namespace
}  // namespace mortise
