#include "mortise/coupler/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "mortise/grids/geometry/frame.hpp"
#include "mortise/grids/geometry/neighbors.hpp"
#include "mortise/grids/overlap/periods.hpp"

namespace mortise {
namespace {

Box<2> bounds(const GapBody<2>& body) { return Frame<2>(body.pose).to_space(body.outline->bounds()); }

ContactPoint<2> gap_between(const GapBody<2>& A, const GapBody<2>& B) {
  Point<2> on_a, on_b;
  const double gap = outline_distance(*A.outline, A.pose, *B.outline, B.pose, &on_a, &on_b);
  const Point<2> apart = gap != 0 ? Point<2>((on_b - on_a) / gap) : Point<2>(B.pose.position - A.pose.position);
  ContactPoint<2> contact;
  contact.normal = apart.normalized();
  contact.point = 0.5 * (on_a + on_b);
  contact.gap = gap;
  return contact;
}

/// The point of the body that is farthest along `direction`.
Point<2> support(const GapBody<2>& body, const Point<2>& direction) {
  const Frame<2> frame(body.pose);
  const Point<2> local(frame.to_body(body.pose.position + direction));
  const Point<2>* best = nullptr;
  for (const Point<2>& X : body.outline->polygon())
    if (!best || X.dot(local) > best->dot(local)) best = &X;
  return frame.to_space(*best);
}

double face(const GapBody<1>& body, double direction) {
  return body.pose.position[0] + (direction > 0 ? body.atlas->right() : body.atlas->left());
}

Box<1> bounds(const GapBody<1>& body) { return {Point<1>(face(body, -1)), Point<1>(face(body, 1))}; }

ContactPoint<1> gap_between(const GapBody<1>& A, const GapBody<1>& B) {
  const double direction = face(B, -1) + face(B, 1) > face(A, -1) + face(A, 1) ? 1 : -1;
  ContactPoint<1> contact;
  contact.normal[0] = direction;
  contact.point[0] = 0.5 * (face(B, -direction) + face(A, direction));
  contact.gap = direction * (face(B, -direction) - face(A, direction));
  return contact;
}

Point<1> support(const GapBody<1>& body, const Point<1>& direction) { return Point<1>(face(body, direction[0])); }

/// Closest points of body a and the images of body b.
template <int Dim>
std::vector<ContactPoint<Dim>> gaps_between(const std::vector<GapBody<Dim>>& bodies, int a, int b, const std::vector<Point<Dim>>& images) {
  std::vector<ContactPoint<Dim>> gaps;
  for (const Point<Dim>& shift : images) {
    GapBody<Dim> image = bodies[static_cast<std::size_t>(b)];
    image.pose.position += shift;
    ContactPoint<Dim> contact = gap_between(bodies[static_cast<std::size_t>(a)], image);
    contact.a = a;
    contact.b = b;
    contact.shift = shift;
    gaps.push_back(contact);
  }
  return gaps;
}

}  // namespace

bool is_round(const Outline& outline) {
  const double radius = outline.mean_radius();
  return std::ranges::all_of(outline.polygon(), [&](const Point<2>& vertex) {
    return std::abs((vertex - outline.centroid()).norm() - radius) <= 1e-8 * radius;
  });
}

template <int Dim>
std::vector<ContactPoint<Dim>> find_gaps(const std::vector<GapBody<Dim>>& bodies, const Box<Dim>& domain, const std::array<bool, Dim>& periodic,
                                         double within) {
  std::vector<ContactPoint<Dim>> gaps;
  std::vector<Box<Dim>> boxes;
  for (const GapBody<Dim>& body : bodies) boxes.push_back(bounds(body));
  const Periods<Dim> periods(domain, periodic);
  const int n = static_cast<int>(bodies.size());
  for (int a = 0; a < n; ++a) {
    const Box<Dim> near = boxes[static_cast<std::size_t>(a)].grown(within);
    const GapBody<Dim>& body = bodies[static_cast<std::size_t>(a)];
    for (int b = a + 1; b < n; ++b)
      for (const ContactPoint<Dim>& point : gaps_between(bodies, a, b, periods.images(boxes[static_cast<std::size_t>(b)], near)))
        if (point.gap < within) gaps.push_back(point);
    for (int d = 0; d < Dim; ++d)
      for (const double sign : {-1.0, 1.0}) {
        if (periodic[static_cast<std::size_t>(d)]) continue;
        const double edge = sign < 0 ? domain.low[d] : domain.high[d];
        if (sign * (edge - (sign < 0 ? near.low[d] : near.high[d])) > 0) continue;
        Point<Dim> normal = Point<Dim>::Zero();
        normal[d] = sign;
        const Point<Dim> tip = support(body, normal);
        ContactPoint<Dim> contact;
        contact.a = a;
        contact.normal = normal;
        contact.point = tip;
        contact.gap = sign * (edge - tip[d]);
        if (std::isfinite(contact.gap) && contact.gap < within) gaps.push_back(contact);
      }
  }
  return gaps;
}

template std::vector<ContactPoint<1>> find_gaps<1>(const std::vector<GapBody<1>>&, const Box<1>&, const std::array<bool, 1>&, double);
template std::vector<ContactPoint<2>> find_gaps<2>(const std::vector<GapBody<2>>&, const Box<2>&, const std::array<bool, 2>&, double);

}  // namespace mortise
