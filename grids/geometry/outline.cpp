// Measures by Green's theorem, with ω = x dy − y dx along the counter-clockwise curve:
//   A = ½∮ω,   ∫x dA = ⅓∮ x ω,   ∫|x|² dA = ¼∮ |x|² ω,
// by six-point Gauss quadrature on every cubic: exact.
#include "mortise/grids/geometry/frame.hpp"
#include "mortise/grids/geometry/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/arc_segment.hpp"
#include "mortise/grids/geometry/cgal_planar.hpp"

namespace mortise {

namespace {

constexpr std::array<double, 3> gauss_point{0.2386191860831969086, 0.6612093864662645137, 0.9324695142031520278};
constexpr std::array<double, 3> gauss_weight{0.4679139345726910474, 0.3607615730481386076, 0.1713244923791703450};

/// Sums of thousands of small terms, in extended precision.
struct Moments {
  long double area = 0, first_x = 0, first_y = 0, second = 0;

  void add(const ArcSegment& segment, double t, double weight) {
    const Point<2> x = segment.position(t);
    const double omega = weight * cross(x, segment.derivative(t));
    area += omega / 2;
    first_x += omega / 3 * x.x();
    first_y += omega / 3 * x.y();
    second += omega / 4 * x.squaredNorm();
  }
};

}  // namespace

Outline::Outline(Points vertices, Points tangents) : tangents_(std::move(tangents)) {
  for (std::size_t k = 0; k < vertices.size(); ++k)
    if (!vertices[k].allFinite() || !tangents_[k].allFinite())
      throw InputError("the outline has a point that is not finite");
  if (!is_simple_polygon(vertices)) throw InputError("the outline crosses or touches itself");
  if (!is_counter_clockwise(vertices)) {
    std::reverse(vertices.begin(), vertices.end());
    std::reverse(tangents_.begin(), tangents_.end());
    for (Point<2>& tangent : tangents_) tangent = -tangent;
  }
  for (const Point<2>& vertex : vertices) bounds_.include(vertex);
  measure(vertices);
  if (!(area_ > 1e-10 * (bounds_.high - bounds_.low).squaredNorm())) throw InputError("the outline encloses no area");
  start_on_axis(vertices);
  arc_.assign(1, 0.0);
  long double length = 0;
  for (std::size_t k = 0, n = vertices.size(); k < n; ++k) {
    const ArcSegment segment(vertices[k], tangents_[k], vertices[(k + 1) % n], tangents_[(k + 1) % n]);
    length += segment.length();
    arc_.push_back(static_cast<double>(length));
  }
  tree_ = StripTree(std::move(vertices));
}

void Outline::measure(const Points& vertices) {
  const std::size_t n = vertices.size();
  Point<2> origin = Point<2>::Zero();
  for (const Point<2>& vertex : vertices) origin += vertex / static_cast<double>(n);
  Moments sum;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const ArcSegment segment(vertices[k] - origin, tangents_[k], vertices[next] - origin, tangents_[next]);
    for (std::size_t g = 0; g < gauss_point.size(); ++g) {
      sum.add(segment, 0.5 * (1 - gauss_point[g]), 0.5 * gauss_weight[g]);
      sum.add(segment, 0.5 * (1 + gauss_point[g]), 0.5 * gauss_weight[g]);
    }
  }
  area_ = static_cast<double>(sum.area);
  const Point<2> centre = Point<2>(static_cast<double>(sum.first_x), static_cast<double>(sum.first_y)) / area_;
  centroid_ = origin + centre;
  second_moment_ = static_cast<double>(sum.second) - area_ * centre.squaredNorm();
}

// Rotates the vertices so that they start where the horizontal through the centroid leaves the outline at the largest
// x, adding a vertex there unless there is one. A centroid outside a bay may see no outline: then the largest x starts.
void Outline::start_on_axis(Points& vertices) {
  const std::size_t n = vertices.size();
  const double on_axis = 1e-12 * (bounds_.high - bounds_.low).norm();
  std::size_t start = 0;
  double largest = -1e300, start_parameter = 0;
  const auto offer = [&](std::size_t k, double parameter, double x) {
    if (x <= largest) return;
    largest = x;
    start = k;
    start_parameter = parameter;
  };
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const double below = vertices[k].y() - centroid_.y(), above = vertices[next].y() - centroid_.y();
    if (std::abs(below) <= on_axis && vertices[k].x() > centroid_.x()) offer(k, 0, vertices[k].x());
    if (std::abs(below) <= on_axis || std::abs(above) <= on_axis || below * above > 0) continue;
    const ArcSegment segment(vertices[k], tangents_[k], vertices[next], tangents_[next]);
    double t = below / (below - above);
    for (int iteration = 0; iteration < 4; ++iteration) {
      const double slope = segment.derivative(t).y();
      if (slope != 0) t = std::clamp(t - (segment.position(t).y() - centroid_.y()) / slope, 0.0, 1.0);
    }
    if (segment.position(t).x() > centroid_.x()) offer(k, t, segment.position(t).x());
  }
  if (largest == -1e300)
    for (std::size_t k = 0; k < n; ++k) offer(k, 0, vertices[k].x());
  if (start_parameter > 1 - 1e-6) start = (start + 1) % n;
  if (start_parameter > 1e-6 && start_parameter <= 1 - 1e-6) {
    const std::size_t next = (start + 1) % n;
    const ArcSegment segment(vertices[start], tangents_[start], vertices[next], tangents_[next]);
    const auto after = static_cast<std::ptrdiff_t>(++start);
    vertices.insert(vertices.begin() + after, segment.position(start_parameter));
    tangents_.insert(tangents_.begin() + after, segment.derivative(start_parameter).normalized());
  }
  std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(start), vertices.end());
  std::rotate(tangents_.begin(), tangents_.begin() + static_cast<std::ptrdiff_t>(start), tangents_.end());
}

double Outline::mean_radius() const { return std::sqrt(area_ / std::numbers::pi); }

Outline Outline::placed(const Pose<2>& pose) const {
  const Frame<2> frame(pose);
  Outline moved = *this;
  Points vertices = polygon();
  moved.bounds_ = {};
  for (Point<2>& vertex : vertices) moved.bounds_.include(vertex = frame.to_space(vertex));
  for (Point<2>& tangent : moved.tangents_) tangent = frame.turn(tangent);
  moved.tree_ = StripTree(std::move(vertices));
  moved.centroid_ = frame.to_space(centroid_);
  return moved;
}

Outline Outline::centered() const {
  Outline moved = *this;
  Points vertices = polygon();
  for (Point<2>& vertex : vertices) vertex -= centroid_;
  moved.tree_ = StripTree(std::move(vertices));
  moved.bounds_ = {bounds_.low - centroid_, bounds_.high - centroid_};
  moved.centroid_.setZero();
  return moved;
}

Point<2> Outline::at(double s) const {
  s -= std::floor(s / perimeter()) * perimeter();
  const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
  const auto k = static_cast<std::size_t>(after - arc_.begin()) - 1, next = (k + 1) % tangents_.size();
  const ArcSegment segment(polygon()[k], tangents_[k], polygon()[next], tangents_[next]);
  return segment.position(segment.parameter((s - arc_[k]) / segment.length()));
}

}  // namespace mortise
