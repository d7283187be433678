// Both trees of edges are descended together; a pair of runs is skipped when their chords, less their deviations, are
// further apart than the closest edges found so far.
#include "mortise/grids/geometry/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/grids/geometry/cgal_planar.hpp"
#include "mortise/grids/geometry/frame.hpp"

namespace mortise {

namespace {

using Points = std::vector<Point<2>>;

bool segments_cross(const Point<2>& p, const Point<2>& q, const Point<2>& r, const Point<2>& s) {
  const Point<2> pq = q - p, rs = s - r;
  return cross(pq, r - p) * cross(pq, s - p) < 0 && cross(rs, p - r) * cross(rs, q - r) < 0;
}

double squared_gap(const Point<2>& p, const Point<2>& q, const Point<2>& r, const Point<2>& s) {
  if (segments_cross(p, q, r, s)) return 0;
  return std::min(
      {squared_distance(p, r, s), squared_distance(q, r, s), squared_distance(r, p, q), squared_distance(s, p, q)});
}

/// The closest pair of edges of two closed polygons, in the frame of the first.
class ClosestEdges {
 public:
  ClosestEdges(const StripTree& a, const StripTree& b, const Points& b_vertices)
      : a_(a), b_(b), b_vertices_(b_vertices) {
    descend(0, 0);
  }
  double distance() const { return distance_; }
  void points(Point<2>& on_a, Point<2>& on_b) const {
    double smallest = std::numeric_limits<double>::infinity();
    const Point<2>&p = a_.vertex(edge_a_), &q = a_.vertex(edge_a_ + 1), &r = b_vertex(edge_b_),
          &s = b_vertex(edge_b_ + 1);
    const auto offer = [&](const Point<2>& x, const Point<2>& y) {
      if ((x - y).squaredNorm() >= smallest) return;
      smallest = (x - y).squaredNorm();
      on_a = x;
      on_b = y;
    };
    offer(p, r + nearest_parameter(p, r, s) * (s - r));
    offer(q, r + nearest_parameter(q, r, s) * (s - r));
    offer(p + nearest_parameter(r, p, q) * (q - p), r);
    offer(p + nearest_parameter(s, p, q) * (q - p), s);
  }

 private:
  const Point<2>& b_vertex(int k) const { return b_vertices_[static_cast<std::size_t>(k == b_.edges() ? 0 : k)]; }
  const StripTree::Node& a_node(int k) const { return a_.nodes()[static_cast<std::size_t>(k)]; }
  const StripTree::Node& b_node(int k) const { return b_.nodes()[static_cast<std::size_t>(k)]; }

  double bound(int ka, int kb) const {
    const auto &a = a_node(ka), &b = b_node(kb);
    const double squared = squared_gap(a_.vertex(a.first), a_.vertex(a.last), b_vertex(b.first), b_vertex(b.last));
    return std::sqrt(squared) - a.deviation - b.deviation;
  }
  void descend(int ka, int kb) {
    const auto &a = a_node(ka), &b = b_node(kb);
    if (a.right == 0 && b.right == 0) return compare_edges(a, b);
    const bool split_a = b.right == 0 || (a.right != 0 && a.last - a.first >= b.last - b.first);
    const std::pair<int, int> left = split_a ? std::pair(ka + 1, kb) : std::pair(ka, kb + 1);
    const std::pair<int, int> right = split_a ? std::pair(a.right, kb) : std::pair(ka, b.right);
    const double left_bound = bound(left.first, left.second), right_bound = bound(right.first, right.second);
    const bool left_first = left_bound <= right_bound;
    const auto& [near, far] = left_first ? std::pair(left, right) : std::pair(right, left);
    if (std::min(left_bound, right_bound) < distance_) descend(near.first, near.second);
    if (std::max(left_bound, right_bound) < distance_) descend(far.first, far.second);
  }
  void compare_edges(const StripTree::Node& a, const StripTree::Node& b) {
    for (int i = a.first; i < a.last; ++i) {
      for (int j = b.first; j < b.last; ++j) {
        const double squared = squared_gap(a_.vertex(i), a_.vertex(i + 1), b_vertex(j), b_vertex(j + 1));
        if (squared >= distance_ * distance_) continue;
        distance_ = std::sqrt(squared);
        edge_a_ = i;
        edge_b_ = j;
      }
    }
  }

  const StripTree &a_, &b_;
  const Points& b_vertices_;
  double distance_ = std::numeric_limits<double>::infinity();
  int edge_a_ = 0, edge_b_ = 0;
};

/// The vertex of one polygon that lies deepest inside another, or nearest to it.
struct Deepest {
  double distance = std::numeric_limits<double>::infinity();        // signed
  Point<2> vertex = Point<2>::Zero(), on_other = Point<2>::Zero();  // in the frame of the other polygon

  /// Looks at every `stride`-th vertex, then at all around the best of these.
  Deepest(const Points& vertices, const StripTree& other) {
    const std::size_t n = vertices.size(), stride = std::max<std::size_t>(1, n / 128);
    std::size_t best = 0;
    for (std::size_t k = 0; k < n; k += stride)
      if (offer(vertices[k], other)) best = k;
    for (std::size_t k = 1; k < stride; ++k) {
      offer(vertices[(best + k) % n], other);
      offer(vertices[(best + n - k) % n], other);
    }
  }
  bool offer(const Point<2>& x, const StripTree& other) {
    const StripTree::Nearest found = other.nearest(x);
    if (found.distance >= distance) return false;
    distance = found.distance;
    vertex = x;
    on_other = found.point;
    return true;
  }
};

/// The points `from` of one body's own frame, seen from another body's.
Points seen_from(const Frame<2>& to, const Frame<2>& own, const Points& from) {
  Points seen;
  seen.reserve(from.size());
  for (const Point<2>& x : from) seen.push_back(to.to_body(own.to_space(x)));
  return seen;
}

}  // namespace

std::vector<std::pair<int, int>> neighboring_bodies(const std::vector<std::vector<Point<2>>>& outline_samples) {
  Points points;
  std::vector<int> body;
  for (std::size_t b = 0; b < outline_samples.size(); ++b) {
    points.insert(points.end(), outline_samples[b].begin(), outline_samples[b].end());
    body.resize(points.size(), static_cast<int>(b));
  }
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [p, q] : delaunay_edges(points)) {
    const auto [low, high] = std::minmax(body[static_cast<std::size_t>(p)], body[static_cast<std::size_t>(q)]);
    if (low != high) pairs.emplace_back(low, high);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

double outline_distance(const Outline& a, const Pose<2>& pose_a, const Outline& b, const Pose<2>& pose_b,
                        Point<2>* on_a, Point<2>* on_b) {
  const Frame<2> frame_a(pose_a), frame_b(pose_b);
  const Points b_seen = seen_from(frame_a, frame_b, b.polygon());
  const ClosestEdges closest(a.tree(), b.tree(), b_seen);
  Point<2> x = Point<2>::Zero(), y = Point<2>::Zero();
  closest.points(x, y);
  double distance = closest.distance();
  const bool apart = distance > 0 && a.tree().nearest(y).distance > 0 &&
                     b.tree().nearest(frame_b.to_body(frame_a.to_space(x))).distance > 0;
  x = frame_a.to_space(x);
  y = frame_a.to_space(y);
  if (!apart) {
    const Deepest b_in_a(b_seen, a.tree()), a_in_b(seen_from(frame_b, frame_a, a.polygon()), b.tree());
    distance = std::min({0.0, a_in_b.distance, b_in_a.distance});
    if (distance < 0) {
      const bool a_deeper = a_in_b.distance < b_in_a.distance;
      x = a_deeper ? frame_b.to_space(a_in_b.vertex) : frame_a.to_space(b_in_a.on_other);
      y = a_deeper ? frame_b.to_space(a_in_b.on_other) : frame_a.to_space(b_in_a.vertex);
    }
  }
  if (on_a) *on_a = x;
  if (on_b) *on_b = y;
  return distance;
}

}  // namespace mortise
