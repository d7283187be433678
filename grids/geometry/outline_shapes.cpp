#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <tuple>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/cgal_planar.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

namespace {

constexpr int vertex_count = 2048;       // at least, on a whole outline
constexpr int vertices_per_fillet = 48;  // at least

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

void require_positive(const char* what, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(sentence("the ", what, " must be positive and finite, not ", value));
}

int even_count(double length, double spacing) { return 2 * static_cast<int>(std::ceil(0.5 * length / spacing)); }

/// One corner of a polygon and the arc that replaces it.
struct Fillet {
  Point<2> corner, along_in, along_out;  // unit directions of the edges before and after
  double turn, cut;                      // signed turn; length cut from both edges
};

Fillet fillet_at(const Point<2>& before, const Point<2>& corner, const Point<2>& after, double radius) {
  const Point<2> in = corner - before, out = after - corner;
  if (in.norm() == 0 || out.norm() == 0)
    throw InputError(sentence("two corners of the polygon coincide at (", corner.x(), ", ", corner.y(), ")"));
  const double turn = std::atan2(cross(in, out), in.dot(out));
  if (std::abs(turn) > std::numbers::pi - 1e-6)
    throw InputError(sentence("the polygon turns back on itself at (", corner.x(), ", ", corner.y(), ")"));
  return {corner, in.normalized(), out.normalized(), turn, radius * std::tan(0.5 * std::abs(turn))};
}

struct Samples {
  std::vector<Point<2>> vertices, tangents;

  void add(const Point<2>& vertex, const Point<2>& tangent) {
    vertices.push_back(vertex);
    tangents.push_back(tangent);
  }
};

void add_arc(Samples& samples, const Fillet& fillet, double radius, double spacing) {
  if (fillet.turn == 0) return samples.add(fillet.corner, fillet.along_in);
  const int count = std::max(vertices_per_fillet, even_count(radius * std::abs(fillet.turn), spacing));
  const Point<2>&t = fillet.along_in, start = fillet.corner - fillet.cut * t;
  const Point<2> inward = std::copysign(1.0, fillet.turn) * Point<2>(-t.y(), t.x());
  for (int k = 0; k <= count; ++k) {
    const double angle = std::abs(fillet.turn) * k / count, c = std::cos(angle), s = std::sin(angle);
    samples.add(start + radius * (s * t + (1 - c) * inward), c * t + s * inward);
  }
}

void add_edge_interior(Samples& samples, const Point<2>& a, const Point<2>& b, const Point<2>& tangent,
                       double spacing) {
  const int count = even_count((b - a).norm(), spacing);
  for (int k = 1; k < count; ++k) samples.add(a + (b - a) * k / count, tangent);
}

}  // namespace

Outline Outline::circle(double radius) {
  require_positive("radius", radius);
  return ellipse(radius, radius);
}

Outline Outline::ellipse(double semi_axis_x, double semi_axis_y) {
  require_positive("first semi-axis", semi_axis_x);
  require_positive("second semi-axis", semi_axis_y);
  constexpr int quarter = vertex_count / 4;
  Samples samples;
  for (int k = 0; k < vertex_count; ++k) {
    const double angle = 0.5 * std::numbers::pi * (k % quarter) / quarter;
    double c = std::cos(angle), s = std::sin(angle);
    for (int turn = 0; turn < k / quarter; ++turn) std::tie(c, s) = std::pair(-s, c);
    samples.add({semi_axis_x * c, semi_axis_y * s}, Point<2>(-semi_axis_x * s, semi_axis_y * c).normalized());
  }
  return Outline(std::move(samples.vertices), std::move(samples.tangents));
}

Outline Outline::rounded_polygon(const std::vector<Point<2>>& corners, double fillet) {
  require_positive("fillet", fillet);
  if (corners.size() < 3) throw InputError(sentence("a polygon needs at least 3 corners, not ", corners.size()));
  if (!is_simple_polygon(corners)) throw InputError("the polygon crosses or touches itself");
  const std::size_t n = corners.size();
  std::vector<Fillet> fillets;
  double perimeter = 0;
  for (std::size_t k = 0; k < n; ++k) {
    fillets.push_back(fillet_at(corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n], fillet));
    perimeter += (corners[(k + 1) % n] - corners[k]).norm() + fillet * std::abs(fillets[k].turn) - 2 * fillets[k].cut;
  }
  const double spacing = perimeter / vertex_count;
  Samples samples;
  for (std::size_t k = 0; k < n; ++k) {
    const Fillet &here = fillets[k], &next = fillets[(k + 1) % n];
    const double edge = (next.corner - here.corner).norm(), left = edge - here.cut - next.cut;
    if (left < -1e-12 * edge)
      throw InputError(sentence("a fillet of ", fillet, " does not fit on the edge of length ", edge, " from (",
                                here.corner.x(), ", ", here.corner.y(), ") to (", next.corner.x(), ", ",
                                next.corner.y(), ")"));
    add_arc(samples, here, fillet, spacing);
    const Point<2> begin = here.corner + here.cut * here.along_out, end = next.corner - next.cut * here.along_out;
    if (left > 1e-9 * edge) {
      add_edge_interior(samples, begin, end, here.along_out, spacing);
    } else {
      samples.vertices.pop_back();
      samples.tangents.pop_back();
    }
  }
  return Outline(std::move(samples.vertices), std::move(samples.tangents));
}

Outline Outline::rounded_rectangle(double width, double height, double fillet) {
  require_positive("width", width);
  require_positive("height", height);
  const double x = 0.5 * width, y = 0.5 * height;
  return rounded_polygon({{x, -y}, {x, y}, {-x, y}, {-x, -y}}, fillet);
}

}  // namespace mortise
