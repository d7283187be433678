#include "mortise/grids/geometry/strip_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mortise {

namespace {
constexpr int leaf_size = 4;  // edges
}

struct StripTree::Search {
  Point<2> x;
  double distance;  // of the nearest point so far, unsigned
  int edge = 0;     // that it lies on
};

StripTree::StripTree(std::vector<Point<2>> vertices) : vertices_(std::move(vertices)) { build(0, edges()); }

void StripTree::build(int first, int last) {
  double deviation2 = 0;
  for (int k = first + 1; k < last; ++k)
    deviation2 = std::max(deviation2, squared_distance(vertex(k), vertex(first), vertex(last)));
  const std::size_t self = nodes_.size();
  nodes_.push_back({first, last, 0, std::sqrt(deviation2)});
  if (last - first <= leaf_size) return;
  const int middle = (first + last) / 2;
  build(first, middle);
  nodes_[self].right = static_cast<int>(nodes_.size());
  build(middle, last);
}

void StripTree::visit(int index, Search& search) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  if (node.right == 0) {
    for (int edge = node.first; edge < node.last; ++edge) {
      const double squared = squared_distance(search.x, vertex(edge), vertex(edge + 1));
      if (squared > search.distance * search.distance) continue;
      search.distance = std::sqrt(squared);
      search.edge = edge;
    }
    return;
  }
  const auto bound = [&](int child) {
    const Node& run = nodes_[static_cast<std::size_t>(child)];
    return std::sqrt(squared_distance(search.x, vertex(run.first), vertex(run.last))) - run.deviation;
  };
  int near = index + 1, far = node.right;
  double near_bound = bound(near), far_bound = bound(far);
  if (far_bound < near_bound) {
    std::swap(near, far);
    std::swap(near_bound, far_bound);
  }
  if (near_bound <= search.distance) visit(near, search);
  if (far_bound <= search.distance) visit(far, search);
}

Point<2> StripTree::normal(int edge, double parameter) const {
  const int n = edges();
  const auto outward = [&](int k) {
    const Point<2> along = vertex((k + n) % n + 1) - vertex((k + n) % n);
    return Point<2>(Point<2>(along.y(), -along.x()) / along.norm());
  };
  if (parameter == 0) return outward(edge) + outward(edge - 1);
  if (parameter == 1) return outward(edge) + outward(edge + 1);
  return outward(edge);
}

StripTree::Nearest StripTree::nearest(const Point<2>& x, double bound) const {
  Search search{.x = x, .distance = bound * (1 + 1e-12)};
  visit(0, search);
  const Point<2>&a = vertex(search.edge), &b = vertex(search.edge + 1);
  const double parameter = nearest_parameter(x, a, b);
  const Point<2> point = a + parameter * (b - a);
  const bool inside = (x - point).dot(normal(search.edge, parameter)) < 0;
  return {inside ? -search.distance : search.distance, point};
}

}  // namespace mortise
