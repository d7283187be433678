// A binary tree over the consecutive edges of a closed polygon: each node bounds a run of edges by its chord and
// the largest deviation of the run from that chord (strip trees: Ballard, Communications of the ACM 24, 1981).
// The bound is second order in the length of the run, so that nearest points are found in O(log n).
#pragma once

#include <limits>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// The point of the segment [a, b] nearest to x is a + t (b − a), 0 ≤ t ≤ 1.
inline double nearest_parameter(const Point<2>& x, const Point<2>& a, const Point<2>& b) {
  const Point<2> ab = b - a;
  const double along = (x - a).dot(ab), length2 = ab.squaredNorm();
  return along <= 0 ? 0 : along >= length2 ? 1 : along / length2;
}
inline double squared_distance(const Point<2>& x, const Point<2>& a, const Point<2>& b) {
  return (a + nearest_parameter(x, a, b) * (b - a) - x).squaredNorm();
}
inline double cross(const Point<2>& a, const Point<2>& b) { return a.x() * b.y() - a.y() * b.x(); }

class StripTree {
 public:
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  struct Nearest {
    double distance = unbounded;  // signed: negative inside
    Point<2> point = Point<2>::Zero();
  };
  struct Node {
    int first, last;   // edges first … last − 1, that is the run of vertices first … last
    int right;         // index of the right child (the left one follows its parent); 0 for a leaf
    double deviation;  // of the run from its chord
  };

  StripTree() = default;
  /// `vertices`: a simple closed polygon, counter-clockwise, at least 3 vertices.
  explicit StripTree(std::vector<Point<2>> vertices);

  /// The point of the polygon nearest to x, with the signed distance (exact up to round-off; the sign is that of
  /// the outward normal, at a vertex of the mean of its two edges' normals). The search may be told that the
  /// distance does not exceed `bound`; the answer is wrong if it does.
  Nearest nearest(const Point<2>& x, double bound = unbounded) const;

  const std::vector<Point<2>>& vertices() const { return vertices_; }
  const Point<2>& vertex(int k) const { return vertices_[static_cast<std::size_t>(k == edges() ? 0 : k)]; }
  const std::vector<Node>& nodes() const { return nodes_; }
  int edges() const { return static_cast<int>(vertices_.size()); }

 private:
  struct Search;
  void build(int first, int last);
  void visit(int node, Search& search) const;
  Point<2> normal(int edge, double parameter) const;

  std::vector<Point<2>> vertices_;
  std::vector<Node> nodes_;
};

}  // namespace mortise
