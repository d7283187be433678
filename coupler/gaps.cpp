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

constexpr std::size_t vertex_step = 16;  // of an outline's vertices every so manieth is looked at for the ends of a flat side

constexpr double flat = 0.999;  // cosine between the normals at points of two flat sides that face each other

/// Of the points that are offered the first and the last along a tangent that are about as close as the closest: one
/// that is farther off by δ counts as if it were 4δ less far along, so that flat sides end where they turn by 1 in 4.
struct Ends {
  Point<2> tangent;
  ContactPoint<2> low, high;
  double closest;
  double from = 1e300, to = -1e300;

  void offer(const ContactPoint<2>& contact) {
    if (std::abs(contact.normal[0] * tangent[1] - contact.normal[1] * tangent[0]) < flat) return;  // round a corner
    const double s = contact.point.dot(tangent), late = 4 * std::max(0.0, contact.gap - closest);
    if (s + late < from) from = s + late, low = contact;
    if (s - late > to) to = s - late, high = contact;
  }
};

/// The closest points, and where flat sides face each other the ends of what is closer than `within`: one pair of
/// points would let them turn into each other.
void with_ends(const ContactPoint<2>& closest, const Ends& ends, double within, std::vector<ContactPoint<2>>& contacts) {
  contacts.push_back(closest);
  const double s = closest.point.dot(ends.tangent);
  if (s - ends.from > 0.25 * within) contacts.push_back(ends.low);
  if (ends.to - s > 0.25 * within) contacts.push_back(ends.high);
}

/// Points of the outline of `of` and the points of the other one that are nearest to them, if closer than `within`.
void offer_points(const GapBody<2>& of, const GapBody<2>& other, double within, double direction, Ends& ends) {
  const Frame<2> frame(of.pose), other_frame(other.pose);
  const std::vector<Point<2>>& vertices = of.outline->polygon();
  for (std::size_t k = 0; k < vertices.size(); k += vertex_step) {
    const Point<2> x = frame.to_space(vertices[k]);
    const StripTree::Nearest nearest = other.outline->tree().nearest(other_frame.to_body(x));
    if (!(nearest.distance > 0) || nearest.distance >= within) continue;
    const Point<2> y = other_frame.to_space(nearest.point);
    ContactPoint<2> contact;
    contact.normal = direction * (y - x) / nearest.distance;
    contact.point = 0.5 * (x + y);
    contact.gap = nearest.distance;
    ends.offer(contact);
  }
}

std::vector<ContactPoint<2>> contacts_between(const GapBody<2>& A, const GapBody<2>& B, double within) {
  const ContactPoint<2> closest = gap_between(A, B);
  std::vector<ContactPoint<2>> contacts;
  if (closest.gap >= within) return contacts;
  Ends ends{Point<2>(-closest.normal[1], closest.normal[0]), closest, closest, closest.gap};
  if (closest.gap > 0 && !is_round(*A.outline) && !is_round(*B.outline)) {
    offer_points(A, B, within, 1, ends);
    offer_points(B, A, within, -1, ends);
  }
  with_ends(closest, ends, within, contacts);
  return contacts;
}

/// The point of the body that is nearest to an edge of the domain, the plane n·x = `at` behind which there is nothing.
std::vector<ContactPoint<2>> contacts_with_edge(const GapBody<2>& body, const Point<2>& normal, double at, double within) {
  const Frame<2> frame(body.pose);
  const auto contact_at = [&](const Point<2>& X) {
    ContactPoint<2> contact;
    contact.normal = normal;
    contact.point = frame.to_space(X);
    contact.gap = at - contact.point.dot(normal);
    return contact;
  };
  const std::vector<Point<2>>& vertices = body.outline->polygon();
  ContactPoint<2> closest = contact_at(vertices.front());
  for (const Point<2>& X : vertices)
    if (const ContactPoint<2> contact = contact_at(X); contact.gap < closest.gap) closest = contact;
  std::vector<ContactPoint<2>> contacts;
  if (closest.gap >= within) return contacts;
  Ends ends{Point<2>(-normal[1], normal[0]), closest, closest, closest.gap};
  if (!is_round(*body.outline))
    for (std::size_t k = 0; k < vertices.size(); k += vertex_step)
      if (const ContactPoint<2> contact = contact_at(vertices[k]); contact.gap < within) ends.offer(contact);
  with_ends(closest, ends, within, contacts);
  return contacts;
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

std::vector<ContactPoint<1>> contacts_between(const GapBody<1>& A, const GapBody<1>& B, double within) {
  const ContactPoint<1> contact = gap_between(A, B);
  if (contact.gap >= within) return {};
  return {contact};
}

std::vector<ContactPoint<1>> contacts_with_edge(const GapBody<1>& body, const Point<1>& normal, double at, double within) {
  ContactPoint<1> contact;
  contact.normal = normal;
  contact.point[0] = face(body, normal[0]);
  contact.gap = at - contact.point.dot(normal);
  if (!std::isfinite(contact.gap) || contact.gap >= within) return {};
  return {contact};
}

/// Of body a with the images of body b.
template <int Dim>
void add_contacts(const std::vector<GapBody<Dim>>& bodies, int a, int b, const std::vector<Point<Dim>>& images, double within,
                  std::vector<ContactPoint<Dim>>& all) {
  for (const Point<Dim>& shift : images) {
    GapBody<Dim> image = bodies[static_cast<std::size_t>(b)];
    image.pose.position += shift;
    for (ContactPoint<Dim>& contact : contacts_between(bodies[static_cast<std::size_t>(a)], image, within)) {
      contact.a = a;
      contact.b = b;
      for (int d = 0; d < Dim; ++d) contact.shift[static_cast<std::size_t>(d)] = shift[d];
      all.push_back(contact);
    }
  }
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
    const Box<Dim> around = boxes[static_cast<std::size_t>(a)].grown(std::min(within, 0.5 * periods.shortest()));  // no images but the nearest
    for (int b = a + 1; b < n; ++b) add_contacts(bodies, a, b, periods.images(boxes[static_cast<std::size_t>(b)], around), within, gaps);
    for (int d = 0; d < Dim; ++d)
      for (const double sign : {-1.0, 1.0}) {
        if (periodic[static_cast<std::size_t>(d)]) continue;
        const double edge = sign < 0 ? domain.low[d] : domain.high[d];
        if (sign * (edge - (sign < 0 ? near.low[d] : near.high[d])) > 0) continue;
        Point<Dim> normal = Point<Dim>::Zero();
        normal[d] = sign;
        for (ContactPoint<Dim>& contact : contacts_with_edge(body, normal, sign * edge, within)) {
          contact.a = a;
          gaps.push_back(contact);
        }
      }
  }
  return gaps;
}

template std::vector<ContactPoint<1>> find_gaps<1>(const std::vector<GapBody<1>>&, const Box<1>&, const std::array<bool, 1>&, double);
template std::vector<ContactPoint<2>> find_gaps<2>(const std::vector<GapBody<2>>&, const Box<2>&, const std::array<bool, 2>&, double);

}  // namespace mortise
