#include "mortise/coupler/interface_nodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace mortise {
namespace {

TEST(NodeVelocities, AreExactForLinearFieldsAndSmoothTheRest) {
  std::vector<Point<2>> faces;
  for (int i = 0; i < 6; ++i) faces.push_back({2 + 3 * (i + 0.5), -i - 0.5});
  const auto nodes = node_velocities(faces, false);
  ASSERT_EQ(nodes.size(), 7u);
  for (int i = 0; i < 7; ++i) EXPECT_LT((nodes[std::size_t(i)] - Point<2>(2 + 3 * i, -i)).norm(), 1e-14);

  std::vector<Point<2>> pulse(6, Point<2>::Zero());
  pulse[0] = {8, 0};
  const auto around = node_velocities(pulse, true);
  const std::vector<double> weights = {3, 3, 1, 0, 0, 1};
  ASSERT_EQ(around.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(around[i][0], weights[i]);
  EXPECT_EQ(node_velocities(std::vector<Point<2>>{{1, 2}}, false).back(), Point<2>(1, 2));
}

constexpr double strength = 0.25;

/// A polygon of n nodes on an ellipse.
InterfaceCurve ellipse(int n) {
  InterfaceCurve curve;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    curve.nodes.push_back({2 * std::cos(angle), std::sin(angle)});
  }
  return curve;
}

/// n faces of length 1 along x; periodic, or open with n + 1 nodes.
InterfaceCurve line(int n, bool periodic) {
  InterfaceCurve curve{{}, periodic, periodic ? Point<2>(n, 0) : Point<2>(0, 0)};
  for (int i = 0; i < n + (periodic ? 0 : 1); ++i) curve.nodes.push_back({double(i), 0});
  return curve;
}

std::vector<Point<2>> displaced(const InterfaceCurve& curve, const std::function<Point<2>(const Point<2>&)>& u) {
  std::vector<Point<2>> displacement;
  for (const Point<2>& X : curve.nodes) displacement.push_back(u(X));
  return displacement;
}

std::vector<Point<2>> unknown(const InterfaceCurve& curve) { return std::vector<Point<2>>(curve.faces(), Point<2>::Zero()); }
std::vector<Point<2>> undeformed(const InterfaceCurve& curve) { return std::vector<Point<2>>(curve.faces(), Point<2>(1, 0)); }

Point<2> two_face_wave(const Point<2>& X) { return {0, std::cos(std::numbers::pi * X[0])}; }

double largest(const std::vector<Point<2>>& change) {
  double size = 0;
  for (const Point<2>& c : change) size = std::max(size, c.norm());
  return size;
}

TEST(WrinkleCorrection, LeavesHomogeneousDeformationsAlone) {
  const InterfaceCurve curve = ellipse(24);
  Eigen::Matrix2d F;
  F << 0.3, -1.2, 0.9, 0.4;  // turned, stretched and sheared
  std::vector<Point<2>> tangents;
  for (std::size_t f = 0; f < curve.faces(); ++f)
    tangents.push_back(F * (curve.nodes[(f + 1) % curve.nodes.size()] - curve.nodes[f]).normalized());
  const auto u = displaced(curve, [&F](const Point<2>& X) { return Point<2>(F * X - X + Point<2>(5, -7)); });
  EXPECT_LT(largest(wrinkle_correction(curve, u, tangents, strength)), 1e-14);
}

TEST(WrinkleCorrection, TakesAllOfTheWaveOfTwoFaces) {
  for (const bool known : {true, false}) {
    const InterfaceCurve curve = line(8, true);
    auto u = displaced(curve, two_face_wave);
    const auto change = wrinkle_correction(curve, u, known ? undeformed(curve) : unknown(curve), strength);
    for (std::size_t k = 0; k < u.size(); ++k) EXPECT_LT((u[k] + change[k]).norm(), 1e-14) << known << " " << k;
  }
}

TEST(WrinkleCorrection, FollowsTheStructureWhereItHasTheWrinkle) {
  const InterfaceCurve curve = line(8, true);
  const auto u = displaced(curve, two_face_wave);
  std::vector<Point<2>> tangents;
  for (std::size_t f = 0; f < 8; ++f) tangents.push_back(Point<2>(1, 0) + u[(f + 1) % 8] - u[f]);
  EXPECT_LT(largest(wrinkle_correction(curve, u, tangents, strength)), 1e-14);
}

TEST(WrinkleCorrection, OpenEndsStay) {
  const InterfaceCurve curve = line(8, false);
  const auto u = displaced(curve, two_face_wave);
  const auto tied = wrinkle_correction(curve, u, undeformed(curve), strength), filtered = wrinkle_correction(curve, u, unknown(curve), strength);
  for (const auto& change : {tied, filtered}) EXPECT_EQ(change.front().norm() + change.back().norm(), 0.0);
  EXPECT_NEAR(tied[1].norm(), 1, 1e-14);
  EXPECT_EQ(filtered[1].norm(), 0.0);
  EXPECT_NEAR(filtered[2].norm(), 1, 1e-14);
}

TEST(WrinkleCorrection, CubicsAreSmoothWhereDeformationIsUnknown) {
  const InterfaceCurve curve = line(8, false);
  const auto u = displaced(curve, [](const Point<2>& X) { return Point<2>(X[0] * X[0] * X[0], 1 - X[0] * X[0]); });
  EXPECT_LT(largest(wrinkle_correction(curve, u, unknown(curve), strength)), 1e-12);
}

}  // namespace
}  // namespace mortise
