// Closed outlines of bodies in the plane, in the body's own frame.
//
// An outline is a dense polygon with the curve's unit tangent at every vertex. Between two vertices the curve is
// the cubic with these tangents whose end derivatives have length 2 |chord|/(1 + cos ½θ), θ the turn of the
// tangent: sixth order on circular arcs, exact on straight lines. Area and moments are exact for that curve.
#pragma once

#include <string>
#include <vector>

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/geometry/strip_tree.hpp"

namespace mortise {

/// A closed curve without self-intersection, counter-clockwise. Lengths are non-dimensional.
/// Every factory throws InputError, in one sentence, for sizes that are not positive, for fillets that do not fit and
/// for curves that cross themselves or enclose no area.
class Outline {
 public:
  static Outline circle(double radius);
  static Outline ellipse(double semi_axis_x, double semi_axis_y);
  /// Polygon (either orientation, convex or not) with every corner rounded by an arc of radius `fillet` > 0.
  static Outline rounded_polygon(const std::vector<Point<2>>& corners, double fillet);
  /// width along x, height along y, centred at 0; fillet at most half the shorter side.
  static Outline rounded_rectangle(double width, double height, double fillet);
  /// Periodic cubic spline through points, parametrised by chord length (closed automatically; at least 4 points;
  /// a last point equal to the first is dropped).
  static Outline spline(const std::vector<Point<2>>& points);
  /// Reads "x y" or "x,y" lines (# comments, blank lines) and calls spline(). Throws InputError naming the file, and
  /// the line of a bad line; also when the outline is open: first and last point further apart than five times the
  /// largest other spacing.
  static Outline spline_from_file(const std::string& path);

  /// Dense counter-clockwise vertices on the curve (no repeated end point), at least 2000; the first one is at(0).
  const std::vector<Point<2>>& polygon() const { return tree_.vertices(); }
  /// The polygon again, arranged for nearest-point queries.
  const StripTree& tree() const { return tree_; }
  const Box<2>& bounds() const { return bounds_; }
  double perimeter() const { return arc_.back(); }
  double area() const { return area_; }
  const Point<2>& centroid() const { return centroid_; }
  double second_moment() const { return second_moment_; }  // ∫|x − centroid|² dA: inertia at density 1
  double mean_radius() const;                              // √(area/π)
  /// The same outline with its centroid moved to the origin (what bodies use as their frame).
  Outline centered() const;
  /// The same outline turned by the pose's angle about the origin and moved by its position.
  Outline placed(const Pose<2>& pose) const;
  /// Point at arc length s (taken modulo the perimeter), measured counter-clockwise from the point where the
  /// horizontal through the centroid leaves the outline on the side of larger x.
  Point<2> at(double s) const;

 private:
  using Points = std::vector<Point<2>>;

  Outline(Points vertices, Points tangents);  // orients, checks, measures; throws InputError
  void measure(const Points& vertices);
  void start_on_axis(Points& vertices);

  StripTree tree_;
  Points tangents_;          // unit, at each vertex
  std::vector<double> arc_;  // arc length at each vertex, then the perimeter
  Box<2> bounds_;
  double area_ = 0, second_moment_ = 0;
  Point<2> centroid_ = Point<2>::Zero();
};

}  // namespace mortise
