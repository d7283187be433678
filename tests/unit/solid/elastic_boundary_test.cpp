// Boundary solutions of an elastic solid: what is prescribed holds, and the outgoing wave carries the rest.
#include "mortise/solid/elastic_boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mortise {
namespace {

ElasticTrace some_trace() {
  ElasticTrace trace;
  trace.velocity = {0.3, -0.2};
  trace.traction = {1.1, 0.4};
  trace.admittance << 0.8, 0.1, 0.1, 0.5;
  return trace;
}

void expect_outgoing(const ElasticTrace& solid, const BoundarySolution& solution) {
  const Point<2> jump = solution.velocity - solid.velocity - solid.admittance * (solution.traction - solid.traction);
  EXPECT_LT(jump.norm(), 1e-15);
}

TEST(ElasticBoundary, NormalsPointOutOfTheSolid) {
  const Point<2> a(0, 0), right(2, 0), up(0, 2);
  EXPECT_EQ(boundary_face(a, right, Side::south).normal, Point<2>(0, -1));
  EXPECT_EQ(boundary_face(a, right, Side::north).normal, Point<2>(0, 1));
  EXPECT_EQ(boundary_face(a, up, Side::west).normal, Point<2>(-1, 0));
  EXPECT_EQ(boundary_face(a, up, Side::east).normal, Point<2>(1, 0));
  EXPECT_EQ(boundary_face(a, up, Side::east).center, Point<2>(0, 1));
}

TEST(ElasticBoundary, PrescribedValuesHold) {
  const ElasticTrace solid = some_trace();
  const BoundaryFace face{{0.5, 0.5}, {0.6, 0.8}};
  const BoundaryFunction value = [](const Point<2>& X, const Point<2>& N, double t) -> Point<2> { return t * X + N; };
  const Point<2> expected(1.6, 1.8);
  const BoundarySolution moved = boundary_solution({ElasticBoundary::displacement, value}, solid, face, 2);
  EXPECT_EQ(moved.velocity, expected);
  expect_outgoing(solid, moved);
  const BoundarySolution loaded = boundary_solution({ElasticBoundary::traction, value}, solid, face, 2);
  EXPECT_EQ(loaded.traction, expected);
  expect_outgoing(solid, loaded);
  EXPECT_EQ(boundary_solution({ElasticBoundary::traction, {}}, solid, face, 2).traction, (Point<2>(0, 0)));
}

TEST(ElasticBoundary, ASlippingFaceHasNeitherNormalVelocityNorShear) {
  const ElasticTrace solid = some_trace();
  const BoundaryFace face{{0.5, 0.5}, {0.6, 0.8}};
  const BoundarySolution solution = boundary_solution({ElasticBoundary::slip, {}}, solid, face, 0);
  EXPECT_LT(std::abs(solution.velocity.dot(face.normal)), 1e-16);
  EXPECT_LT(std::abs(solution.traction.dot(Point<2>(-0.8, 0.6))), 1e-15);
  expect_outgoing(solid, solution);
}

}  // namespace
}  // namespace mortise
