// Wall faces of simple bodies in a gas, for tests of the body equations.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mortise/coupler/added_mass.hpp"
#include "mortise/fluid/wall_pressure.hpp"

namespace mortise::testing {

/// Fluid of constant impedance: P = p̃ + z d whatever the state.
inline WallLaw acoustic(double z) {
  return [z](double, double pressure, double d) { return WallPressure{pressure + z * d, z}; };
}

/// Ideal gas, shock or fan.
inline WallLaw ideal_gas(double gamma = 1.4) {
  return [gamma](double density, double pressure, double d) {
    const WallResponse wall = wall_response(density, pressure, d, gamma);
    return WallPressure{wall.pressure, wall.impedance};
  };
}

struct GasState {
  double density;
  Point<2> velocity;
  double pressure;
};
using GasField = std::function<GasState(const Point<2>& x)>;

/// Faces of a counter-clockwise polygon about the origin in a gas that does not change within the step.
inline std::vector<WallFace<2>> polygon_faces(const std::vector<Point<2>>& vertices, const GasField& gas) {
  std::vector<WallFace<2>> faces;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point<2> a = vertices[i], b = vertices[(i + 1) % vertices.size()], along = b - a;
    WallFace<2> face;
    face.measure = along.norm();
    face.normal = Point<2>(along[1], -along[0]) / face.measure;
    face.arm = 0.5 * (a + b);
    const GasState state = gas(face.arm);
    face.density0 = face.density_half = state.density;
    face.pressure0 = face.pressure_half = state.pressure;
    face.normal_velocity0 = face.normal_velocity_half = state.velocity.dot(face.normal);
    faces.push_back(face);
  }
  return faces;
}

inline GasField uniform(double density, const Point<2>& velocity, double pressure) {
  return [=](const Point<2>&) { return GasState{density, velocity, pressure}; };
}

/// n vertices on the ellipse with semi-axes a, b, turned by `angle`.
inline std::vector<Point<2>> ellipse(double a, double b, double angle, int n) {
  std::vector<Point<2>> vertices;
  for (int i = 0; i < n; ++i) {
    const double s = 2 * std::numbers::pi * i / n, x = a * std::cos(s), y = b * std::sin(s);
    vertices.emplace_back(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y);
  }
  return vertices;
}

/// Rectangle w × h, n equal faces on every side.
inline std::vector<Point<2>> rectangle(double w, double h, int n) {
  const std::array<Point<2>, 4> corners{Point<2>(-w / 2, -h / 2), {w / 2, -h / 2}, {w / 2, h / 2}, {-w / 2, h / 2}};
  std::vector<Point<2>> vertices;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < n; ++i) vertices.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * i / n);
  return vertices;
}

/// Straight part of half length l along x, caps of radius r, n faces on each of the four pieces.
inline std::vector<Point<2>> capsule(double l, double r, int n) {
  std::vector<Point<2>> vertices;
  for (const int side : {1, -1}) {
    for (int i = 0; i < n; ++i) {
      const double s = std::numbers::pi * (static_cast<double>(i) / n - 0.5);
      vertices.emplace_back(side * (l + r * std::cos(s)), side * r * std::sin(s));
    }
    for (int i = 0; i < n; ++i) vertices.emplace_back(side * (l - 2 * l * i / n), side * r);
  }
  return vertices;
}

/// One face of a body on a line: normal ±1, a gas that does not change within the step, u along +x.
inline WallFace<1> line_face(int normal, double density, double velocity, double pressure) {
  WallFace<1> face;
  face.normal[0] = normal;
  face.density0 = face.density_half = density;
  face.pressure0 = face.pressure_half = pressure;
  face.normal_velocity0 = face.normal_velocity_half = normal * velocity;
  return face;
}

template <int Dim>
BodyMotion<Dim> advance(const BodyStep<Dim>& step, const std::vector<WallFace<Dim>>& faces, const WallLaw& law) {
  return advance_added_mass<Dim>(step, faces, law);
}

}  // namespace mortise::testing
