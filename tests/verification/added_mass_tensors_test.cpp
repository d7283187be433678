// Added-mass tensors A = Σ z e eᵀ L, e = (n, r × n), of the wall faces of grown grids against those of the curves
// (z = 1, about the centroid). The faces are chords: second order.
#include <gtest/gtest.h>

#include <numbers>

#include "mortise/coupler/added_mass.hpp"
#include "mortise/grids/geometry/body_grid.hpp"
#include "mortise/grids/geometry/frame.hpp"

namespace mortise {
namespace {

using std::numbers::pi;

struct Computed {
  BodyMatrix<2> tensor;
  int faces;
  double perimeter;  // of the faces
};

/// Of the wall of the grid that a case with this outline and spacing gets, turned by `angle`, for an impedance z.
Computed added_mass(const Outline& outline, double spacing, double angle, double z = 1) {
  const Outline body = outline.centered();
  const GrownGrid grid = grow(body, {spacing, 10});
  const Frame<2> frame(Pose<2>{.position = Point<2>::Zero(), .angle = angle});
  std::vector<WallFace<2>> faces;
  double perimeter = 0;
  for (int i = 0; i < grid.along; ++i) {
    const Point<2> from = frame.to_space(grid.node(i, 0)), to = frame.to_space(grid.node(i + 1, 0)), edge = to - from;
    WallFace<2> face;
    face.normal = Point<2>(-edge[1], edge[0]) / edge.norm();
    face.arm = 0.5 * (from + to);
    face.measure = edge.norm();
    perimeter += face.measure;
    faces.push_back(face);
  }
  const std::vector<double> impedance(faces.size(), z);
  return {added_mass_tensor<2>(faces, impedance), grid.along, perimeter};
}

/// Errors on three grids: the last one is small and the order is two.
void expect_second_order(const Outline& outline, double angle, const BodyMatrix<2>& exact, double final_error) {
  double before = 0;
  int faces_before = 0;
  for (const double spacing : {0.04, 0.02, 0.01}) {
    const Computed computed = added_mass(outline, spacing, angle);
    const double error = (computed.tensor - exact).cwiseAbs().maxCoeff();
    if (faces_before > 0) {
      const double order = std::log(before / error) / std::log(double(computed.faces) / faces_before);
      EXPECT_NEAR(order, 2, 0.1) << "spacing " << spacing;
    }
    before = error;
    faces_before = computed.faces;
  }
  EXPECT_LE(before, final_error);
}

TEST(AddedMassTensors, Circle) {
  const double a = 0.5;
  BodyMatrix<2> exact = BodyMatrix<2>::Zero();
  exact(0, 0) = exact(1, 1) = pi * a;
  expect_second_order(Outline::circle(a), 0.3, exact, 3e-4);
  EXPECT_LE(std::abs(added_mass(Outline::circle(a), 0.04, 0.3).tensor(2, 2)), 1e-25);  // the gas does not turn a circle
}

TEST(AddedMassTensors, EllipseAt45Degrees) {
  BodyMatrix<2> exact = BodyMatrix<2>::Zero();
  exact(0, 0) = exact(1, 1) = 1.695478;
  exact(0, 1) = exact(1, 0) = -0.813049;
  exact(2, 2) = 0.199197;
  expect_second_order(Outline::ellipse(0.7, 0.35), 0.25 * pi, exact, 3e-4);
}

TEST(AddedMassTensors, Capsule) {  // a stick whose fillet is half its width: half length l, radius r
  const double l = 0.2, r = 0.05;
  BodyMatrix<2> exact = BodyMatrix<2>::Zero();
  exact(0, 0) = pi * r + 4 * l;
  exact(1, 1) = pi * r;
  exact(2, 2) = 4 * l * l * l / 3 + pi * l * l * r;
  const BodyMatrix<2> computed = added_mass(Outline::rounded_rectangle(2 * r, 2 * (l + r), r), 0.0025, 0).tensor;
  EXPECT_LE((computed - exact).cwiseAbs().maxCoeff(), 2e-4);
}

TEST(AddedMassTensors, TraceIsImpedanceTimesPerimeter) {
  for (const Outline& outline :
       {Outline::circle(0.25), Outline::ellipse(0.7, 0.35), Outline::rounded_rectangle(0.1, 0.5, 0.038)}) {
    const Computed computed = added_mass(outline, 0.0125, 0.7, 3.5);
    EXPECT_NEAR(computed.tensor(0, 0) + computed.tensor(1, 1), 3.5 * computed.perimeter, 1e-12);
    EXPECT_NEAR(computed.perimeter, outline.perimeter(), 2e-3 * outline.perimeter());
  }
}

}  // namespace
}  // namespace mortise
