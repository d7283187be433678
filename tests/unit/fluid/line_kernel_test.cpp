#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "mortise/fluid/cell.hpp"
#include "mortise/fluid/exact_riemann.hpp"
#include "mortise/fluid/godunov_step.hpp"
#include "unit/fluid/gas_options.hpp"

namespace mortise {
namespace {

using testing::gamma_air, testing::gas_limiters, testing::gas_solvers;

struct LineTile {
  using StateOf = std::function<Primitive<1>(int)>;
  LineTile(int n, const StateOf& state) : shape({n}), now(shape.plane, 3), next(shape.plane, 3) {
    for (int i = -2; i < n + 2; ++i) put(now, shape.at(i), to_conserved(state(i), gamma_air));
  }
  CartesianTile<1> view(double h) { return {&shape, now.component(0), next.component(0), {h}, nullptr}; }
  Conserved<1> before(int i) const { return get<1>(now, shape.at(i)); }
  Conserved<1> after(int i) const { return get<1>(next, shape.at(i)); }
  TileShape<1> shape;
  TileBlock now, next;
};

[[gnu::noinline]] Primitive<1> wavy_line(int i) {
  return {1 + 0.4 * std::sin(1.3 * i), {0.6 * std::cos(0.8 * i)}, 1 + 0.5 * std::sin(2.1 * i + 1)};
}

TEST(LineKernel, UniformFlowStaysUniformToTheBitOnAMovingLine) {
  for (const RiemannSolver solver : gas_solvers) {
    StepOptions o;
    o.riemann = solver;
    LineTile line(20, [](int) { return Primitive<1>{1.3, {0.7}, 0.9}; });
    EXPECT_TRUE(godunov_step(MovingLineTile{line.view(0.1), 0.45, {}, {}}, 0.02, o).admissible);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(line.after(i).energy, line.before(i).energy);
  }
}

/// Mean error of the density of Sod's problem at t = 0.2 on [0, 1].
double sod_error(int n, const StepOptions& o, double* largest = nullptr) {
  const Primitive<1> L{1, {0}, 1}, R{0.125, {0}, 0.1};
  LineTile line(n, [&](int i) { return i < n / 2 ? L : R; });
  const double h = 1.0 / n;
  double t = 0, rate = wave_rate(line.view(h), o).rate;
  while (t < 0.2) {
    const double dt = std::min(0.9 / rate, 0.2 - t);
    const StepResult result = godunov_step(line.view(h), dt, o);
    EXPECT_TRUE(result.admissible);
    rate = result.rate, t += dt;
    for (int i = -2; i < 0; ++i) put(line.next, line.shape.at(i), line.before(i));
    for (int i = n; i < n + 2; ++i) put(line.next, line.shape.at(i), line.before(i));
    std::swap(line.now, line.next);
  }
  double error = 0;
  for (int i = 0; i < n; ++i) {
    const double difference =
        std::abs(line.before(i).density - sample(L, R, gamma_air, ((i + 0.5) * h - 0.5) / t).density);
    error += difference * h;
    if (largest) *largest = std::max(*largest, difference);
  }
  return error;
}

TEST(LineKernel, SodsProblemAgreesWithTheExactSolution) {
  for (const RiemannSolver solver : gas_solvers)
    for (const Limiter limiter : {Limiter::minmod, Limiter::mc, Limiter::van_albada}) {
      StepOptions o;
      o.riemann = solver, o.limiter = limiter;
      EXPECT_LT(sod_error(400, o), limiter == Limiter::minmod ? 2.6e-3 : 1.8e-3);
    }
}

TEST(LineKernel, MirroredFlowHasTheMirroredAnswerToTheBit) {
  const int n = 22;
  for (const Limiter limiter : gas_limiters) {
    StepOptions o;
    o.limiter = limiter;
    LineTile line(n, wavy_line), image(n, [](int i) {
      const Primitive<1> W = wavy_line(n - 1 - i);
      return Primitive<1>{W.density, {-W.velocity[0]}, W.pressure};
    });
    const double p = 1.7, q = 0.4;
    godunov_step(MovingLineTile{line.view(0.1), 0.25, {true, &p}, {true, &q}}, 0.01, o);
    godunov_step(MovingLineTile{image.view(0.1), -0.25, {true, &q}, {true, &p}}, 0.01, o);
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(line.after(i).density, image.after(n - 1 - i).density);
      EXPECT_EQ(line.after(i).momentum[0], -image.after(n - 1 - i).momentum[0]);
      EXPECT_EQ(line.after(i).energy, image.after(n - 1 - i).energy);
    }
  }
}

TEST(LineKernel, LineMovingWithTheFrameSeesTheSameFlow) {
  const double w = 0.9;
  LineTile rest(20, wavy_line), moving(20, [&](int i) {
    Primitive<1> W = wavy_line(i);
    W.velocity[0] += w;
    return W;
  });
  const StepResult a = godunov_step(rest.view(0.1), 0.01, {});
  const StepResult b = godunov_step(MovingLineTile{moving.view(0.1), w, {}, {}}, 0.01, {});
  EXPECT_NEAR(a.rate, b.rate, 1e-13 * a.rate);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(moving.after(i).density, rest.after(i).density, 1e-14);
    EXPECT_NEAR(moving.after(i).momentum[0], rest.after(i).momentum[0] + w * rest.after(i).density, 1e-14);
  }
}

TEST(LineKernel, WallsExchangeMomentumAndWorkOnlyAndTheirGhostsAreNotRead) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), left = 1.3, right = 0.6, w = 0.2, h = 0.1, dt = 0.01;
  LineTile line(16, wavy_line);
  for (const int ghost : {-2, -1, 16, 17}) line.now.component(0)[line.shape.at(ghost)] = nan;
  EXPECT_TRUE(godunov_step(MovingLineTile{line.view(h), w, {true, &left}, {true, &right}}, dt, {}).admissible);
  double mass = 0, momentum = 0, energy = 0;
  for (int i = 0; i < 16; ++i) {
    mass += line.after(i).density - line.before(i).density;
    momentum += line.after(i).momentum[0] - line.before(i).momentum[0];
    energy += line.after(i).energy - line.before(i).energy;
  }
  EXPECT_NEAR(mass, 0, 1e-14);
  EXPECT_NEAR(momentum, dt / h * (left - right), 1e-14);
  EXPECT_NEAR(energy, dt / h * (left - right) * w, 1e-14);
}

TEST(LineKernel, MaskAndNaN) {
  LineTile line(16, wavy_line);
  std::vector<std::uint8_t> active(line.shape.plane, 1);
  active[line.shape.at(7)] = 0;
  CartesianTile<1> view = line.view(0.1);
  view.active = active.data();
  EXPECT_TRUE(godunov_step(view, 0.01, {}).admissible);
  EXPECT_EQ(line.after(7).energy, line.before(7).energy);
  EXPECT_NE(line.after(8).energy, line.before(8).energy);
  line.now.component(2)[line.shape.at(12)] = -1;
  EXPECT_FALSE(godunov_step(view, 0.01, {}).admissible);
  EXPECT_FALSE(wave_rate(view, {}).admissible);
}

TEST(LineKernel, EveryEvenWidthGivesTheSameBits) {
  LineTile whole(64, wavy_line);
  godunov_step(whole.view(0.1), 0.01, {});
  for (int n = 2; n < 64; n += 2) {
    LineTile part(n, wavy_line);
    godunov_step(part.view(0.1), 0.01, {});
    for (int i = 0; i < n; ++i) EXPECT_EQ(part.after(i).energy, whole.after(i).energy);
  }
}

}  // namespace
}  // namespace mortise
