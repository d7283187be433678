// Points, indices and small constants shared by every room.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace mortise {

/// A point or vector in physical space, non-dimensional.
template <int Dim>
using Point = Eigen::Matrix<double, Dim, 1>;

/// A cell, node or tile index; entry d counts along direction d.
template <int Dim>
using Index = std::array<int, Dim>;

/// An axis-aligned box [low, high].
template <int Dim>
struct Box {
  Point<Dim> low = Point<Dim>::Constant(1e300);    // corner with the smallest coordinates
  Point<Dim> high = Point<Dim>::Constant(-1e300);  // corner with the largest coordinates

  bool contains(const Point<Dim>& x) const { return (x.array() >= low.array()).all() && (x.array() <= high.array()).all(); }
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  void include(const Point<Dim>& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  Box grown(double margin) const { return {low.array() - margin, high.array() + margin}; }
};

/// Rotation in the plane: one number; on a line: none.
template <int Dim>
inline constexpr int rotations = Dim == 2 ? 1 : 0;

/// Where a rigid body is: a point X of the body's own frame is at position + R(angle) X.
template <int Dim>
struct Pose {
  Point<Dim> position = Point<Dim>::Zero();  // of the body's centre of mass
  double angle = 0;                          // radians, counter-clockwise; unused for Dim = 1

  bool operator==(const Pose&) const = default;
};

}  // namespace mortise
