// Exact waves in elastic solids: second order in the max norm, whatever happens at the boundaries.
#include "verification/elastic_run.hpp"

namespace mortise {
namespace {

using namespace testing;

double error_on_a_square(const PlaneWave& wave, int n, ElasticBoundary kind) {
  ElasticSetup setup = square(wave.material, n, n / 2, kind);
  setup.exact = wave;
  ElasticRun run(setup, wave);
  run.advance_to(0.5);
  return run.largest_error(wave);
}

TEST(ElasticSolverWaves, SecondOrderOnAPeriodicSquare) {
  for (const bool shear : {false, true}) {
    const PlaneWave wave{unit_speed(StressLaw::linear), 2 * pi * Point<2>(1, 1), shear};
    expect_order(error_on_a_square(wave, 32, ElasticBoundary::periodic),
                 error_on_a_square(wave, 64, ElasticBoundary::periodic), 1.9);
  }
  const PlaneWave finite{unit_speed(StressLaw::neo_hookean), 2 * pi * Point<2>(1, 0), true, 0.05};
  expect_order(error_on_a_square(finite, 32, ElasticBoundary::periodic),
               error_on_a_square(finite, 64, ElasticBoundary::periodic), 1.9);
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean}) {
    const PlaneWave small{unit_speed(law), 2 * pi * Point<2>(1, 1), false, 1e-6};
    expect_order(error_on_a_square(small, 32, ElasticBoundary::periodic),
                 error_on_a_square(small, 64, ElasticBoundary::periodic), 1.9);
  }
}

TEST(ElasticSolverWaves, SecondOrderThroughExactSides) {
  for (const bool shear : {false, true}) {
    const PlaneWave wave{unit_speed(StressLaw::linear), Point<2>(5, 3), shear};
    expect_order(error_on_a_square(wave, 32, ElasticBoundary::exact),
                 error_on_a_square(wave, 64, ElasticBoundary::exact), 1.9);
  }
  const PlaneWave finite{unit_speed(StressLaw::neo_hookean), Point<2>(2.5, 1.5), true, 0.1};
  expect_order(error_on_a_square(finite, 32, ElasticBoundary::exact),
               error_on_a_square(finite, 64, ElasticBoundary::exact), 1.9);
}

struct PatchErrors {
  double largest = 0, mean = 0;
};

/// An open grid with curved lines; one side prescribes velocities, two tractions, one is exact.
PatchErrors errors_on_a_curved_patch(const PlaneWave& wave, int n) {
  ElasticSetup setup;
  setup.name = "patch";
  setup.options.material = wave.material;
  setup.fitted = placed_grid(n, n, 1.0 / n, false, [](double xi, double eta) {
    return Point<2>(xi + 0.05 * std::sin(pi * xi) * std::sin(2 * pi * eta + 1),
                    eta + 0.06 * std::sin(2 * pi * xi + eta));
  });
  setup.fitted_sides = {following(ElasticBoundary::displacement, wave.material, wave),
                        following(ElasticBoundary::traction, wave.material, wave),
                        following(ElasticBoundary::traction, wave.material, wave),
                        ElasticSide{ElasticBoundary::exact, {}}};
  setup.exact = wave;
  ElasticRun run(setup, wave);
  run.advance_to(0.5);
  return {run.largest_error(wave), run.mean_error(wave)};
}

/// Corners between two prescribed sides cost up to half an order in the max norm.
TEST(ElasticSolverWaves, SecondOrderOnACurvedPatchWithPrescribedVelocitiesAndTractions) {
  for (const PlaneWave& wave : {PlaneWave{unit_speed(StressLaw::linear), Point<2>(5, 3), false},
                                PlaneWave{unit_speed(StressLaw::linear), Point<2>(5, 3), true},
                                PlaneWave{unit_speed(StressLaw::neo_hookean), Point<2>(5, 3), true, 0.03}}) {
    const PatchErrors coarse = errors_on_a_curved_patch(wave, 32), fine = errors_on_a_curved_patch(wave, 64);
    expect_order(coarse.mean, fine.mean, 1.9);
    expect_order(coarse.largest, fine.largest, 1.5);
  }
}

/// The first radial mode of the ring ½ ≤ r ≤ 1, fixed on both circles: v_r = g(r) cos ω t.
struct RadialMode {
  Material material;
  double kappa = 6.39315676;  // ω/c_p

  double shape(double r) const {
    return std::cyl_bessel_j(1, kappa * r) * std::cyl_neumann(1, 0.5 * kappa) -
           std::cyl_neumann(1, kappa * r) * std::cyl_bessel_j(1, 0.5 * kappa);
  }
  double strain(double r) const {  // shape'
    const auto derivative = [](double zero, double one, double z) { return zero - one / z; };
    return kappa * (derivative(std::cyl_bessel_j(0, kappa * r), std::cyl_bessel_j(1, kappa * r), kappa * r) *
                        std::cyl_neumann(1, 0.5 * kappa) -
                    derivative(std::cyl_neumann(0, kappa * r), std::cyl_neumann(1, kappa * r), kappa * r) *
                        std::cyl_bessel_j(1, 0.5 * kappa));
  }
  ElasticState operator()(const Point<2>& X, double t) const {
    const double r = X.norm(), omega = kappa * material.pressure_wave_speed(), s = std::sin(omega * t) / omega;
    const Point<2> n = X / r;
    const Gradient radial = n * n.transpose(), hoop = Gradient::Identity() - radial;
    return elastic_state(material, shape(r) * std::cos(omega * t) * n, s * (strain(r) * radial + shape(r) / r * hoop),
                         s * shape(r) * n);
  }
};

TEST(ElasticSolverWaves, RadialModeOfAFixedRing) {
  const RadialMode mode{unit_speed(StressLaw::linear)};
  const auto error = [&](int across) {
    ElasticSetup setup;
    setup.name = "ring";
    setup.options.material = mode.material;
    setup.fitted = ring(0.5, 8 * across, across);
    setup.fitted_sides.fill({ElasticBoundary::displacement, {}});
    ElasticRun run(setup, mode);
    run.advance_to(2.2 * pi / mode.kappa);
    return run.largest_error(mode);
  };
  expect_order(error(16), error(32), 1.9);
}

/// A Rayleigh wave along y = 0 of the half plane y > 0; λ = μ.
struct RayleighWave {
  Material material;
  double k = 2 * pi, amplitude = 0.01;

  double speed() const { return 0.9194016867 * material.shear_wave_speed(); }
  ElasticState operator()(const Point<2>& X, double t) const {
    const double p = speed() / material.pressure_wave_speed(), s = speed() / material.shear_wave_speed();
    const double q_p = k * std::sqrt(1 - p * p), q_s = k * std::sqrt(1 - s * s);
    const double omega = k * speed(), weight = 2 * k * q_p / (q_s * q_s + k * k);
    const double e_p = amplitude * std::exp(-q_p * X.y()), e_s = amplitude * weight * std::exp(-q_s * X.y());
    const double a = e_p - q_s / k * e_s, b = -q_p / k * e_p + e_s;  // u = (a cos θ, b sin θ), θ = k x − ω t
    const double a_y = -q_p * e_p + q_s * q_s / k * e_s, b_y = q_p * q_p / k * e_p - q_s * e_s;
    const double c = std::cos(k * X.x() - omega * t), s_x = std::sin(k * X.x() - omega * t);
    Gradient grad;
    grad << -k * a * s_x, a_y * c, k * b * c, b_y * s_x;
    return elastic_state(material, {omega * a * s_x, -omega * b * c}, grad, {a * c, b * s_x});
  }
};

struct RayleighErrors {
  double field = 0, speed = 0;
};

RayleighErrors rayleigh_errors(const RayleighWave& wave, int n) {
  ElasticSetup setup = square(wave.material, n, n / 2, ElasticBoundary::periodic);
  setup.sides[static_cast<std::size_t>(Side::south)] = {ElasticBoundary::traction, {}};
  setup.sides[static_cast<std::size_t>(Side::north)] = {ElasticBoundary::exact, {}};
  setup.exact = wave;
  ElasticRun run(setup, wave);
  run.advance_to(1);
  double sine = 0, cosine = 0;  // of u_y in the row next to the surface
  run.for_each_active_cell([&](int, int, const Index<2>&, const Point<2>& X, const ElasticState& state) {
    if (X.y() > 1.0 / n) return;
    sine += state[6] * std::sin(wave.k * X.x());
    cosine += state[6] * std::cos(wave.k * X.x());
  });
  const double phase = std::atan2(-cosine, sine), exact = wave.k * wave.speed() * run.time();
  return {run.largest_error(wave), std::abs(std::remainder(phase - exact, 2 * pi)) / (wave.k * run.time())};
}

TEST(ElasticSolverWaves, RayleighWaveAlongAFreeSurface) {
  const RayleighWave wave{unit_speed(StressLaw::linear)};
  const RayleighErrors coarse = rayleigh_errors(wave, 32), fine = rayleigh_errors(wave, 64);
  expect_order(coarse.field, fine.field, 1.9);
  expect_order(coarse.speed, fine.speed, 1.9);
  EXPECT_LT(fine.speed, 1e-3 * wave.speed());
}

}  // namespace
}  // namespace mortise
