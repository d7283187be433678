// Sides of a tile: prescribed fluxes, traces and extrapolated ghosts.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "unit/solid/elastic_tiles.hpp"

namespace mortise {
namespace {

using namespace testing;

constexpr int cells_x = 12, cells_y = 8;

/// Traction and velocity on all four sides of a tile.
struct Sides {
  std::array<std::vector<Point<2>>, 4> traction, velocity;
  void set(std::size_t side, int cells) {
    for (int k = 0; k < cells; ++k) {
      const int s = static_cast<int>(side);
      traction[side].emplace_back(noise(k, s) - 0.5, noise(k, s, 1) - 0.5);
      velocity[side].emplace_back(noise(k, s, 2) - 0.5, noise(k, s, 3) - 0.5);
    }
  }
  SideFlux flux(std::size_t side) const { return {traction[side].data(), velocity[side].data()}; }
};
Sides all_sides() {
  Sides sides;
  for (const std::size_t side : {0u, 1u, 2u, 3u}) sides.set(side, side < 2 ? cells_y : cells_x);
  return sides;
}
SolidTile noisy_tile(StressLaw law, bool curvilinear, double size = 0.05) {
  SolidTile tile(law, {cells_x, cells_y}, [=](int i, int j) { return noisy_state(law, size, i, j); });
  if (curvilinear) tile.place([](int i, int j) { return wavy_node(i, j, cells_x, cells_y, 0.2); });
  return tile;
}
/// Lower left and upper right corner of a cell and the other two, in reference coordinates.
Point<2> node(const SolidTile& tile, int i, int j) {
  if (tile.x.empty()) return {i, j};
  return {tile.x[tile.nodes.at(i, j)], tile.y[tile.nodes.at(i, j)]};
}
double area(const SolidTile& tile, int i, int j) {
  const Point<2> a = node(tile, i + 1, j + 1) - node(tile, i, j), b = node(tile, i, j + 1) - node(tile, i + 1, j);
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}
/// Outward area vector of face k of a side.
Point<2> outward(const SolidTile& tile, Side side, int k) {
  const auto right_of = [](const Point<2>& a, const Point<2>& b) { return Point<2>(b[1] - a[1], a[0] - b[0]); };
  switch (side) {
    case Side::west:
      return right_of(node(tile, 0, k + 1), node(tile, 0, k));
    case Side::east:
      return right_of(node(tile, cells_x, k), node(tile, cells_x, k + 1));
    case Side::south:
      return right_of(node(tile, k, 0), node(tile, k + 1, 0));
    case Side::north:
      break;
  }
  return right_of(node(tile, k + 1, cells_y), node(tile, k, cells_y));
}

const std::array<Side, 4> every_side = {Side::west, Side::east, Side::south, Side::north};
int faces(Side side) { return side == Side::west || side == Side::east ? cells_y : cells_x; }

TEST(ElasticSides, PrescribedFluxesChangeMomentumAndDeformationByWhatTheySay) {
  const double dt = 0.1;
  const Sides sides = all_sides();
  for (const StressLaw law : all_laws)
    for (const bool curvilinear : {false, true}) {
      const ElasticOptions o = elastic_options(law);
      SolidTile tile = noisy_tile(law, curvilinear);
      ElasticTile step = tile.tile();
      Point<2> force(0, 0);
      Gradient growth = Gradient::Zero();
      for (const Side side : every_side) {
        const auto s = static_cast<std::size_t>(side);
        step.sides[s] = sides.flux(s);
        for (int k = 0; k < faces(side); ++k) {
          const Point<2> S = outward(tile, side, k);
          force += S.norm() * sides.traction[s][static_cast<std::size_t>(k)];
          growth += sides.velocity[s][static_cast<std::size_t>(k)] * S.transpose();
        }
      }
      elastic_step(step, dt, o);
      Point<2> momentum(0, 0);
      Numbers sum{};
      for (int j = 0; j < cells_y; ++j)
        for (int i = 0; i < cells_x; ++i)
          for (std::size_t c = 0; c < 8; ++c) sum[c] += area(tile, i, j) * (tile.after(i, j)[c] - tile.before(i, j)[c]);
      momentum = o.material.density * Point<2>(sum[0], sum[1]);
      EXPECT_LT((momentum - dt * force).norm(), 1e-13);
      if (law == StressLaw::linear) {
        const Gradient s =
            o.material.lambda * growth.trace() * Gradient::Identity() + o.material.mu * (growth + growth.transpose());
        EXPECT_LT(
            std::fabs(sum[2] - dt * s(0, 0)) + std::fabs(sum[3] - dt * s(0, 1)) + std::fabs(sum[4] - dt * s(1, 1)),
            1e-13);
      } else {
        const Gradient F = (Gradient() << sum[2], sum[3], sum[4], sum[5]).finished();
        EXPECT_LT((F - dt * growth).norm(), 1e-13);
      }
    }
}

TEST(ElasticSides, TracesOfUniformStatesAreTheState) {
  for (const StressLaw law : all_laws)
    for (const bool curvilinear : {false, true}) {
      const ElasticOptions o = elastic_options(law);
      const Gradient A = (Gradient() << 1.2, 0.1, 0.1, 0.9).finished();
      SolidTile tile(law, {cells_x, cells_y}, [&](int, int) {
        return law == StressLaw::linear ? Numbers{0.3, -0.2, 1.2, 0.1, 0.9, 0, 0, 0}
                                        : Numbers{0.3, -0.2, 1.2, 0.1, 0.1, 0.9, 0, 0};
      });
      if (curvilinear) tile.place([](int i, int j) { return wavy_node(i, j, cells_x, cells_y, 0.2); });
      for (const Side side : every_side) {
        std::vector<ElasticTrace> traces(static_cast<std::size_t>(faces(side)));
        elastic_traces(tile.tile(), side, 0.2, o, traces.data());
        for (int k = 0; k < faces(side); ++k) {
          const ElasticTrace& trace = traces[static_cast<std::size_t>(k)];
          const Point<2> N = outward(tile, side, k).normalized();
          const Point<2> t = (law == StressLaw::linear ? A : stress(o.material, A)) * N;
          EXPECT_LT((trace.velocity - Point<2>(0.3, -0.2)).norm() + (trace.velocity_now - trace.velocity).norm(),
                    1e-14);
          EXPECT_LT((trace.traction - t).norm() + (trace.traction_now - t).norm(), 1e-13);
          const Eigen::Matrix2d Z = impedance(o.material, law == StressLaw::linear ? Gradient::Identity() : A, N);
          EXPECT_LT((trace.admittance * Z - Eigen::Matrix2d::Identity()).norm(), 1e-13);
        }
      }
    }
}

TEST(ElasticSides, AFreeRiemannProblemOfTracesIsTheKernelsOwnFlux) {
  // Ghosts that mirror the tile make the flux of the symmetric Riemann problem known from the trace: on a plane of
  // symmetry the normal velocity and the shear traction vanish, so that prescribing them from the trace changes
  // nothing.
  for (const StressLaw law : all_laws)
    for (const ElasticLimiter limiter : all_limiters)
      for (const bool curvilinear : {false, true}) {
        const ElasticOptions o = elastic_options(law, limiter);
        SolidTile tile(law, {cells_x, cells_y}, [&](int i, int j) {
          const bool mirrored = j < 0;
          Numbers W = noisy_state(law, 0.02, i, mirrored ? -1 - j : j);
          if (mirrored) {
            W[1] = -W[1], W[3] = -W[3];
            if (law != StressLaw::linear) W[4] = -W[4];
          }
          return W;
        });
        if (curvilinear)
          tile.place([](int i, int j) {
            return Point<2>(i + 0.2 * std::sin(i) * std::cos(0.5 * j), j * (1 + 0.1 * std::sin(0.7 * i)));
          });
        const double dt = 0.1;
        std::vector<ElasticTrace> traces(cells_x);
        elastic_traces(tile.tile(), Side::south, dt, o, traces.data());
        elastic_step(tile.tile(), dt, o);
        const TileBlock& own = tile.next;
        std::vector<Numbers> expected;
        for (int i = 0; i < cells_x; ++i) expected.push_back(SolidTile::get(own, tile.shape, tile.components, i, 0));
        // v = v_s + Z⁻¹(t − t_s) with t_x = 0 and v_y = 0; t_y follows
        std::vector<Point<2>> traction, velocity;
        for (const ElasticTrace& s : traces) {
          const double y11 = s.admittance(1, 1), y10 = s.admittance(1, 0);
          const double ty = s.traction[1] - (s.velocity[1] + y10 * (0 - s.traction[0])) / y11;
          const Point<2> t(0, ty);
          traction.push_back(t);
          velocity.emplace_back(s.velocity + s.admittance * (t - s.traction));
          velocity.back()[1] = 0;
        }
        ElasticTile step = tile.tile();
        step.sides[2] = {traction.data(), velocity.data()};
        elastic_step(step, dt, o);
        // The impedances differ (mean of the mirrored sides here, one side there), for linear waves they do not.
        if (law == StressLaw::linear)
          for (int i = 0; i < cells_x; ++i)
            EXPECT_LT(distance(tile.after(i, 0), expected[static_cast<std::size_t>(i)]), 1e-13);
        else
          for (int i = 0; i < cells_x; ++i)
            for (const std::size_t c : {0u, 1u})
              EXPECT_NEAR(tile.after(i, 0)[c], expected[static_cast<std::size_t>(i)][c], 2e-4);
      }
}

TEST(ElasticSides, ExtrapolatedGhostsContinueParabolas) {
  const auto parabola = [](int i, int j) {
    Numbers W{};
    for (std::size_t c = 0; c < 8; ++c) W[c] = static_cast<double>(c) + 0.5 * i + 0.25 * j * (j + 40) + 0.125 * i * i;
    return W;
  };
  const StressLaw law = StressLaw::neo_hookean;
  for (const Side side : every_side) {
    SolidTile tile(law, {cells_x, cells_y}, parabola);
    const bool along_x = side == Side::south || side == Side::north;
    for (int c = 0; c < tile.components; ++c)
      for (int j = -2; j < cells_y + 2; ++j)
        for (int i = -2; i < cells_x + 2; ++i) {
          const bool inside = along_x ? j >= 0 && j < cells_y : i >= 0 && i < cells_x;
          if (!inside) tile.now.component(c)[tile.shape.at(i, j)] = -100;
        }
    const int other = along_x ? cells_x : cells_y;
    extrapolate_ghosts(tile.shape, tile.now, side, -2, other + 2, elastic_options(law));
    for (int k = -2; k < other + 2; ++k)
      for (const int depth : {1, 2}) {
        const int i = side == Side::west ? -depth : side == Side::east ? cells_x - 1 + depth : k;
        const int j = side == Side::south ? -depth : side == Side::north ? cells_y - 1 + depth : k;
        EXPECT_EQ(tile.before(i, j), parabola(i, j)) << i << " " << j;
      }
  }
}

TEST(ElasticSides, LimitedGhostsDoNotOvershootBesideJumps) {
  const ElasticOptions limited = elastic_options(StressLaw::linear, ElasticLimiter::mc);
  const auto ghosts = [&](double a0, double a1, double a2) {
    SolidTile tile(StressLaw::linear, {4, 4}, [&](int i, int) {
      Numbers W{};
      W[0] = i == 0 ? a0 : i == 1 ? a1 : a2;
      return W;
    });
    extrapolate_ghosts(tile.shape, tile.now, Side::west, 0, 4, limited);
    return std::pair(tile.before(-1, 0)[0], tile.before(-2, 3)[0]);
  };
  EXPECT_EQ(ghosts(1, 2, 3.5), std::pair(0.5, 0.0));  // smooth: the parabola, then on with its slope
  EXPECT_EQ(ghosts(-1, -2, -3.5), std::pair(-0.5, 0.0));
  EXPECT_EQ(ghosts(1, 5, 5), std::pair(1.0, 1.0));
  EXPECT_EQ(ghosts(1, 1, 5), std::pair(1.0, 1.0));
  EXPECT_EQ(ghosts(1, 5, 5.5), std::pair(0.0, -1.0));
  EXPECT_EQ(ghosts(1, 2, 1), std::pair(1.0, 1.0));  // an extremum
}

}  // namespace
}  // namespace mortise
