// What happens on a side of an elastic solid that is no interface: traction t* (on the outward reference normal N) and
// velocity v* of a face, from the solid's half-time state (t_s, v_s) and what is prescribed. The wave that runs from
// the solid into the boundary carries
//   v* − v_s = Z⁻¹ (t* − t_s),   Z = √(ρ0 Γ),
// and the boundary gives the other two equations.
#pragma once

#include <functional>

#include <Eigen/LU>

#include "mortise/solid/elastic_step.hpp"

namespace mortise {

/// What happens on a side that is no interface.
enum class ElasticBoundary {
  periodic,      // the ghost exchange fills it
  displacement,  // v* given (fixed: zero), traction from the solid
  traction,      // t* given (free: zero), velocity from the solid
  slip,          // v*·n = 0 and no shear traction; a plane of symmetry is the same
  exact,         // ghost cells hold the state of a given function
  interface      // (t*, v*) from the coupler; south of the fitted grid only
};

/// Prescribed boundary velocity or traction: a function of reference position, outward reference normal and time.
using BoundaryFunction = std::function<Point<2>(const Point<2>& X, const Point<2>& N, double t)>;

/// One side of a grid.
struct ElasticSide {
  ElasticBoundary kind = ElasticBoundary::traction;
  BoundaryFunction value;  // displacement: its velocity; traction: it. Empty: zero
};

/// A face of a boundary in the reference frame.
struct BoundaryFace {
  Point<2> center, normal;  // outward unit normal
};

/// The face between two nodes in the order in which the grid numbers them. South and east faces have the solid on the
/// left of this way, north and west faces on the right.
inline BoundaryFace boundary_face(const Point<2>& first, const Point<2>& second, Side side) {
  const Point<2> edge = second - first, right(edge.y(), -edge.x());
  const bool solid_on_left = side == Side::south || side == Side::east;
  return {0.5 * (first + second), (solid_on_left ? right : Point<2>(-right)).normalized()};
}

/// Solution at a boundary face.
struct BoundarySolution {
  Point<2> traction, velocity;
};

inline BoundarySolution prescribed_velocity(const ElasticTrace& solid, const Point<2>& velocity) {
  return {solid.traction + solid.admittance.inverse() * (velocity - solid.velocity), velocity};
}

inline BoundarySolution prescribed_traction(const ElasticTrace& solid, const Point<2>& traction) {
  return {traction, solid.velocity + solid.admittance * (traction - solid.traction)};
}

/// t* = τ N with the τ for which v*·N = 0.
inline BoundarySolution slipping(const ElasticTrace& solid, const Point<2>& N) {
  const double tau = N.dot(solid.admittance * solid.traction - solid.velocity) / N.dot(solid.admittance * N);
  BoundarySolution solution = prescribed_traction(solid, tau * N);
  solution.velocity -= N.dot(solution.velocity) * N;
  return solution;
}

/// Solution at a face of a side of kind displacement, traction or slip at time t.
inline BoundarySolution boundary_solution(const ElasticSide& side, const ElasticTrace& solid, const BoundaryFace& face,
                                          double t) {
  if (side.kind == ElasticBoundary::slip) return slipping(solid, face.normal);
  const Point<2> value = side.value ? side.value(face.center, face.normal, t) : Point<2>::Zero();
  return side.kind == ElasticBoundary::displacement ? prescribed_velocity(solid, value)
                                                    : prescribed_traction(solid, value);
}

}  // namespace mortise
