// The kernels against waves, conservation and stability over many steps, on one periodic tile.
#include <gtest/gtest.h>

#include "unit/solid/elastic_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;

/// A plane wave along `direction` with phase 2π k·X, displacement a·sin(2π(k·X − ct)/…), of the linear theory.
struct TileWave {
  Point<2> k;          // integer wave vector: the tile is the unit square
  bool shear = false;  // S or P
  double amplitude = 1e-6;

  Numbers at(const ElasticOptions& o, const Point<2>& X, double t) const {
    const Material& m = o.material;
    const Point<2> n = k.normalized(), a = shear ? Point<2>(-n[1], n[0]) : n;
    const double c = shear ? m.shear_wave_speed() : m.pressure_wave_speed(), w = 2 * M_PI * k.norm();
    const double phase = w * (n.dot(X) - c * t);
    const Point<2> u = amplitude * std::sin(phase) * a, v = -amplitude * w * c * std::cos(phase) * a;
    const Gradient H = amplitude * w * std::cos(phase) * a * n.transpose();
    if (m.law != StressLaw::linear) return {v[0], v[1], 1 + H(0, 0), H(0, 1), H(1, 0), 1 + H(1, 1), u[0], u[1]};
    const Gradient s = m.lambda * H.trace() * Gradient::Identity() + m.mu * (H + H.transpose());
    return {v[0], v[1], s(0, 0), s(0, 1), s(1, 1), u[0], u[1], 0};
  }
};

/// Unit square of n × n cells, periodic; wavy nodes or Cartesian.
class PeriodicSquare {
 public:
  PeriodicSquare(const ElasticOptions& o, int n, bool wavy)
      : options_(o), n_(n), wavy_(wavy), tile_(o.material.law, {n, n}) {
    if (wavy) tile_.place([this](int i, int j) { return node(i, j); });
  }
  Point<2> node(int i, int j) const {
    return wavy_ ? Point<2>(wavy_node(i, j, n_, n_, 0.25) / n_) : Point<2>(Point<2>(i, j) / n_);
  }
  Point<2> center(int i, int j) const {
    return 0.25 * (node(i, j) + node(i + 1, j) + node(i, j + 1) + node(i + 1, j + 1));
  }
  void fill(const std::function<Numbers(const Point<2>&)>& state) {
    tile_.fill([&](int i, int j) { return state(center(i, j)); });
  }
  /// Steps to `time`; false when a state is not admissible.
  bool run(double time, double cfl, int most_steps = 1 << 30) {
    double rate = elastic_rate(tile(), options_).rate;
    for (double t = 0; t < time * (1 - 1e-12) && steps_ < most_steps; ++steps_) {
      const double dt = std::min(cfl / rate, time - t);
      tile_.copy_periodic_ghosts();
      const ElasticStepResult result = elastic_step(tile(), dt, options_);
      if (!result.admissible) return false;
      rate = result.rate;
      tile_.accept();
      t += dt;
    }
    return true;
  }
  ElasticTile tile() { return tile_.tile(1.0 / n_, 1.0 / n_); }
  Numbers state(int i, int j) const { return tile_.before(i, j); }
  /// Largest difference from a state given by position.
  double error(const std::function<Numbers(const Point<2>&)>& state) const {
    double largest = 0;
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i) largest = std::max(largest, distance(tile_.before(i, j), state(center(i, j))));
    return largest;
  }

 private:
  ElasticOptions options_;
  int n_, steps_ = 0;
  bool wavy_;
  SolidTile tile_;
};

TEST(ElasticWaves, PlaneWavesConvergeWithSecondOrderInTheMaximumNorm) {
  for (const StressLaw law : all_laws)
    for (const bool wavy : {false, true})
      for (const bool shear : {false, true}) {
        const ElasticOptions o = elastic_options(law);
        const TileWave wave{{1, 1}, shear};
        const double time = 0.3;
        std::array<double, 2> errors{};
        for (const int level : {0, 1}) {
          PeriodicSquare square(o, 24 << level, wavy);
          square.fill([&](const Point<2>& X) { return wave.at(o, X, 0); });
          ASSERT_TRUE(square.run(time, 0.9));
          errors[static_cast<std::size_t>(level)] =
              square.error([&](const Point<2>& X) { return wave.at(o, X, time); }) / wave.amplitude;
        }
        EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9)
            << "law " << int(law) << " wavy " << wavy << " shear " << shear;
        EXPECT_LT(errors[1], 0.1);
      }
}

/// A finite swirl and stretch, periodic; J stays well above 0.
Numbers swirl(const ElasticOptions& o, const Point<2>& X, double size) {
  Numbers W = testing::at_rest(o.material.law);
  W[0] = size * std::sin(2 * M_PI * X[1]) * std::cos(2 * M_PI * X[0]);
  W[1] = size * std::cos(2 * M_PI * (X[0] + X[1]));
  return W;
}

/// Means over 2 × 2 cells of a grid twice as fine.
Numbers coarsened(const PeriodicSquare& fine, int i, int j) {
  Numbers mean{};
  for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
    for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += 0.25 * fine.state(2 * i + a, 2 * j + b)[c];
  return mean;
}

TEST(ElasticWaves, FiniteDeformationConvergesWithSecondOrder) {
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean}) {
    const ElasticOptions o = elastic_options(law);
    std::vector<PeriodicSquare> squares;
    for (const int n : {64, 128, 256}) {
      squares.emplace_back(o, n, false);
      squares.back().fill([&](const Point<2>& X) { return swirl(o, X, 0.3); });
      ASSERT_TRUE(squares.back().run(0.1, 0.9));
    }
    std::array<double, 2> errors{};
    for (const std::size_t level : {0u, 1u})
      for (int j = 0; j < 64 << level; ++j)
        for (int i = 0; i < 64 << level; ++i)
          errors[level] =
              std::max(errors[level], distance(squares[level].state(i, j), coarsened(squares[level + 1], i, j)));
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9) << "law " << int(law);
  }
}

/// Largest difference of F_xx from its mean.
double sawtooth(const PeriodicSquare& square, int n) {
  double largest = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) largest = std::max(largest, std::fabs(square.state(i, j)[2] - 1));
  return largest;
}

TEST(ElasticWaves, SawtoothNullModesOfFDecayByTheirUpwindingOnly) {
  const int n = 16;
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean}) {
    std::array<double, 2> left{};
    for (const std::size_t upwinded : {0u, 1u}) {
      ElasticOptions o = elastic_options(law);
      if (upwinded == 0) o.null_mode_upwinding = 0;
      PeriodicSquare square(o, n, false);
      // F_xx alternating along y: no velocity and, on the y faces, no traction follows from it
      square.fill([n](const Point<2>& X) {
        return Numbers{0, 0, 1 + 0.001 * std::cos(M_PI * n * X[1] - 0.5 * M_PI), 0, 0, 1, 0, 0};
      });
      ASSERT_TRUE(square.run(1e9, 0.9, 400));
      left[upwinded] = sawtooth(square, n);
    }
    EXPECT_LT(left[1], 1e-12) << "law " << int(law);
    EXPECT_GT(left[0], 5e-4) << "law " << int(law);
  }
}

/// Largest speed after many steps of a solid in a uniform state with noise of a size.
double speed_left(const ElasticOptions& o, const Gradient& F, double noise, bool wavy, double cfl, int steps) {
  const int n = 8;
  PeriodicSquare square(o, n, wavy);
  square.fill([&](const Point<2>& X) {
    Numbers W = noisy_state(o.material.law, noise, static_cast<int>(X[0] * n * 7), static_cast<int>(X[1] * n * 5));
    if (o.material.law != StressLaw::linear)
      for (int c = 0; c < 4; ++c) W[static_cast<std::size_t>(2 + c)] += F(c / 2, c % 2) - (c % 3 == 0 ? 1 : 0);
    return W;
  });
  if (!square.run(1e9, cfl, steps)) return std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) fastest = std::max(fastest, std::hypot(square.state(i, j)[0], square.state(i, j)[1]));
  return fastest;
}

TEST(ElasticWaves, StableForManySteps) {
  for (const StressLaw law : all_laws)
    for (const bool wavy : {false, true})
      for (const double cfl : {0.9, 1.0})
        EXPECT_LT(speed_left(elastic_options(law), Gradient::Identity(), 0.01, wavy, cfl, 10000), 0.02)
            << "law " << int(law) << " wavy " << wavy << " CFL " << cfl;
}

TEST(ElasticWaves, StableForManyStepsUnderStressAndTurned) {
  Gradient stretched, turned;
  stretched << 1.3, 0.2, -0.1, 0.9;
  turned << 0, -1.2, 0.9, 0.3;
  for (const StressLaw law : {StressLaw::saint_venant_kirchhoff, StressLaw::neo_hookean})
    for (const Gradient& F : {stretched, turned})
      for (const bool wavy : {false, true})
        for (const double cfl : {0.9, 1.0})
          EXPECT_LT(speed_left(elastic_options(law), F, 1e-4, wavy, cfl, 3000), 2e-4)
              << "law " << int(law) << " F_xx " << F(0, 0) << " wavy " << wavy << " CFL " << cfl;
}

}  // namespace
}  // namespace mortise
