// The amplification matrix against closed forms, and the map of the projection.
#include "mortise/coupler/amplification.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "mortise/coupler/added_mass.hpp"
#include "mortise/grids/core/error.hpp"
#include "unit/coupler/acoustic_pair.hpp"

namespace mortise {
namespace {

using testing::even_line;

double lagged_root(double b) { return b; }
double extrapolated_root(double b) { return b + std::sqrt(b * b + b); }  // ζ² + b (2ζ − 1) = 0

/// Accuracy of the sides' own eigenvalue 1 − λ of first order, which six cells share: ε^(1/6).
constexpr double defective = 5e-3;

/// The smallest distance of an eigenvalue from ζ.
double distance(const Eigen::MatrixXd& matrix, double zeta) {
  return (Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().array() - zeta).abs().minCoeff();
}

TEST(Amplification, TraditionalRootsAreThoseOfTheoryForEitherOrderAndAnyStep) {
  for (const int order : {1, 2})
    for (const double courant : {0.1, 0.5, 1.0})
      for (const double b : {0.4, 1.25, 4.0}) {
        const auto factor = [&](const char* scheme, double ratio, bool lagged) {
          return growth_factor(even_line(ratio, courant, order, scheme, lagged, false));
        };
        const double lagged = lagged_root(b), extrapolated = extrapolated_root(b);
        if (b > 1) {
          EXPECT_NEAR(factor("traditional", 1 / b, true), lagged, 1e-10 * lagged) << order << courant << b;
          EXPECT_NEAR(factor("anti-traditional", b, true), lagged, 1e-10 * lagged) << order << courant << b;
        }
        EXPECT_NEAR(factor("traditional", 1 / b, false), extrapolated, 1e-10 * extrapolated) << order << courant << b;
        EXPECT_NEAR(factor("anti-traditional", b, false), extrapolated, 1e-10 * extrapolated) << order << courant << b;
      }
}

/// First order, nothing comes back: the only modes are those of the sides, 1 − λ, and those of the scheme.
TEST(Amplification, ModesOfFirstOrderUpwind) {
  for (const double courant : {0.3, 0.9})
    for (const double b : {0.25, 3.0}) {
      const Eigen::MatrixXd projection =
          amplification_matrix(even_line(1 / b, courant, 1, "projection", false, false, 3));
      EXPECT_NEAR(spectral_radius(projection), 1 - courant, defective) << b;
      const Eigen::MatrixXd lagged = amplification_matrix(even_line(1 / b, courant, 1, "traditional", true, false, 3));
      EXPECT_LT(distance(lagged, -b), 1e-10) << courant;
      const Eigen::MatrixXd second = amplification_matrix(even_line(1 / b, courant, 1, "traditional", false, false, 3));
      for (const double sign : {-1.0, 1.0})
        EXPECT_LT(distance(second, -b + sign * std::sqrt(b * b + b)), 1e-10) << courant << " " << b;
    }
}

/// ζ (ζ − 1 + λ) + b (ζ − 1 + αλ) = 0.
TEST(Amplification, WavesAlongTheWallOfAGasWhoseWallFollowsInPart) {
  for (const double courant : {0.3, 0.9})
    for (const double part : {0.0, 0.25, 1.0})
      for (const double b : {0.5, 1.0, 3.0}) {
        ElasticLine line = even_line(1 / b, courant, 1, "traditional", true, false, 3);
        line.following = part;
        const double half = 0.5 * (b - 1 + courant), rest = b * (part * courant - 1);
        const Eigen::MatrixXd matrix = amplification_matrix(line);
        for (const double sign : {-1.0, 1.0})
          EXPECT_LT(distance(matrix, -half + sign * std::sqrt(half * half - rest)), part == 1 ? defective : 1e-9)
              << courant << part << b;
        const double limit = (2 - part * courant) / (2 - courant);
        for (const double factor : {0.99, 1.01}) {
          line.solid.impedance = factor * limit;
          EXPECT_EQ(growth_factor(line) > 1, factor < 1) << courant << " " << part;
        }
        line.solid.impedance = 1 / b;
        line.scheme = "projection";
        line.order = 2;
        EXPECT_LE(growth_factor(line), 1 + 1e-12) << courant << " " << part;
      }
}

/// Gas as a spring, solid as a mass: a lagged velocity feeds their swing, however heavy the solid is.
TEST(Amplification, LaggedVelocitiesFeedTheSwingOfAFreeSolidOnGas) {
  for (const double ratio : {2.0, 10.0, 100.0}) {
    ElasticLine line = even_line(ratio, 0.5, 2, "traditional", true, true);
    line.solid.end = FarEnd::free;
    EXPECT_GT(growth_factor(line), 1 + 1e-4) << ratio;
    line.scheme = "projection";
    EXPECT_LT(growth_factor(line), 1) << ratio;
  }
}

TEST(Amplification, ProjectionIsStableForEveryRatioOfImpedancesAndEveryCourantNumber) {
  for (const bool reflect : {false, true})
    for (const char* scheme : {"projection", "traditional-subiterated"})
      for (double courant = 0.1; courant < 1.05; courant += 0.1)
        for (double ratio = 1e-6; ratio < 2e6; ratio *= scheme == std::string("projection") ? 10 : 1e3) {
          ElasticLine line = even_line(ratio, std::min(courant, 1.0), 2, scheme, false, reflect);
          EXPECT_LE(growth_factor(line), 1 + 1e-12) << scheme << " " << courant << " " << ratio << " " << reflect;
          line.solid.end = FarEnd::free;
          line.solid.spacing = 2.5;  // a slower Courant number in the solid
          EXPECT_LE(growth_factor(line), 1 + 1e-12) << scheme << " " << courant << " " << ratio << " " << reflect;
        }
}

TEST(Amplification, StepsOfTheFasterSideKeepTheProjectionStable) {
  for (const double ratio : {1e-4, 0.1, 1.0, 10.0, 1e4})
    for (const double courant : {0.5, 0.9, 1.0}) {
      ElasticLine stiff = even_line(ratio, courant, 2, "projection", false, true);
      stiff.solid.speed = 4;
      stiff.solid_substeps = 4;
      EXPECT_LE(growth_factor(stiff), 1 + 1e-12) << ratio << " " << courant;
      ElasticLine soft = even_line(ratio, 3 * courant, 2, "projection", false, true);
      soft.solid.speed = 1.0 / 3;
      soft.gas_shares = {1, 1, 1};
      EXPECT_LE(growth_factor(soft), 1 + 1e-12) << ratio << " " << courant;
    }
}

/// What a plane wave in one cell after the other does not change: a uniform state between open ends.
TEST(Amplification, UniformStatesStay) {
  ElasticLine line = even_line(4, 0.7, 2, "projection", false, false, 5);
  line.solid.end = line.gas.end = FarEnd::open;
  const Eigen::MatrixXd matrix = amplification_matrix(line);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(matrix.rows());
  const double v = 0.3, p = 0.2;  // √z v, p/√z: v points away from the interface on both sides
  for (int i = 0; i < 5; ++i) {
    state.segment<2>(2 * i) << -2 * v, p / 2;
    state.segment<2>(10 + 2 * i) << v, p;
  }
  EXPECT_LT((matrix * state - state).head(20).norm(), 1e-14);
}

TEST(Amplification, TravellingWaveMovesByTheCourantNumber) {
  ElasticLine line = even_line(1, 1, 2, "projection", false, false, 8);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(2 * 16 + 4);
  state.segment<2>(2 * 3) << 1, -1;  // in the solid, towards the interface
  const Eigen::MatrixXd matrix = amplification_matrix(line);
  for (int n = 0; n < 7; ++n) state = (matrix * state).eval();
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(32);
  expected.segment<2>(16 + 2 * 3) << -1, -1;  // through it, four cells into the gas
  EXPECT_LT((state.head(32) - expected).norm(), 1e-12) << state.head(32).transpose();
}

RigidLine rigid_line(double beta, const char* scheme, int sides, int order = 2) {
  RigidLine line;
  line.gases.resize(static_cast<std::size_t>(sides));
  for (AcousticSide& gas : line.gases) gas.end = FarEnd::rest;
  double z = line.gases[0].impedance = 2;
  if (sides == 2) z += line.gases[1].impedance = 0.5;
  line.time_step = 0.8;
  line.mass = z * line.time_step / beta;
  line.scheme = scheme;
  line.order = order;
  return line;
}

/// What the body makes of its own velocity in gas at rest: as nothing comes back, this is an eigenvalue.
double of_body(const Eigen::MatrixXd& matrix) { return matrix(matrix.rows() - 1, matrix.rows() - 1); }

TEST(Amplification, RigidBodies) {
  constexpr double g = sdirk2_gamma;
  for (const int sides : {1, 2})
    for (const int order : {1, 2})
      for (const double beta : {0.1, 1.0, 1.98, 2.02, 5.0, 100.0}) {
        const Eigen::MatrixXd foil = amplification_matrix(rigid_line(beta, "traditional", sides, order));
        EXPECT_NEAR(of_body(foil), 1 - beta, 1e-12 * std::max(1.0, beta)) << beta;
        if (beta > 2) {
          EXPECT_NEAR(spectral_radius(foil), beta - 1, 1e-10 * beta);
        }
        EXPECT_EQ(spectral_radius(foil) > 1, beta > 2) << beta;
        const Eigen::MatrixXd added_mass = amplification_matrix(rigid_line(beta, "rigid", sides, order));
        EXPECT_NEAR(of_body(added_mass), (1 - (1 - 2 * g) * beta) / ((1 + g * beta) * (1 + g * beta)), 1e-12) << beta;
        EXPECT_LE(spectral_radius(added_mass), 1) << beta;
      }
  RigidLine massless = rigid_line(1, "rigid", 2);
  massless.mass = 0;
  EXPECT_LE(growth_factor(massless), 1);
}

TEST(Amplification, RefusesWhatIsNoLine) {
  const ElasticLine good = even_line(1, 0.9, 2, "projection", false, false);
  const auto refused = [](ElasticLine line, auto change) {
    change(line);
    EXPECT_THROW(growth_factor(line), InputError);
  };
  refused(good, [](ElasticLine& line) { line.scheme = "projektion"; });
  refused(good, [](ElasticLine& line) { line.time_step = 0; });
  refused(good, [](ElasticLine& line) { line.gas.impedance = -1; });
  refused(good, [](ElasticLine& line) { line.solid.cells = 2; });
  refused(good, [](ElasticLine& line) { line.order = 3; });
  refused(good, [](ElasticLine& line) { line.solid_substeps = 0; });
  refused(good, [](ElasticLine& line) { line.solid_substeps = 2, line.gas_shares = {1, 1}; });
  EXPECT_THROW(growth_factor(RigidLine{}), InputError);
  RigidLine massless = rigid_line(1, "traditional", 2);
  massless.mass = 0;
  EXPECT_THROW(growth_factor(massless), InputError);
}

}  // namespace
}  // namespace mortise
