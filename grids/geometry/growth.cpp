// Hyperbolic grid growth, layer by layer, from a closed curve to its left: outward where it runs clockwise (after Chan & Steger, Applied
// Mathematics and Computation 51, 1992; here with an explicit step and implicit smoothing):
//   x* = x + h n,              n the normal of the circle through a node and its two neighbours;
//   y = (1 − ε δ²)⁻¹ x*,       but never backward; n is smoothed likewise, before;
//   Δs = (1 − α δ²)⁻¹ Δs(y),   x_next = y(s): spacings along the curve diffuse towards equal arc length.
// ε is α times the turn to the left per node, spread along the curve: zero outside convex curves. So circles give
// concentric circles, and outside convex outlines layers have thickness h, whatever the smoothing α.
#include <algorithm>
#include <cmath>
#include <string>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/arc_segment.hpp"
#include "mortise/grids/geometry/body_grid.hpp"
#include "mortise/grids/geometry/cgal_planar.hpp"
#include "mortise/grids/geometry/cyclic_tridiagonal.hpp"
#include "mortise/grids/geometry/grown_grid.hpp"

namespace mortise {

namespace {

using Curve = std::vector<Point<2>>;

constexpr double least_smoothing = 2;  // α, doubled until the grid is good
constexpr double most_smoothing = 64;  // and given up beyond
constexpr double good = 0.5;           // quality (below) that ends the search
constexpr double concavity_reach = 6;  // diffusion number that spreads the sensed turn along the curve
constexpr double deepest = 0.8;        // part of a thin body's half width that an inward grid may fill

std::size_t before(std::size_t i, std::size_t n) { return i == 0 ? n - 1 : i - 1; }
std::size_t after(std::size_t i, std::size_t n) { return i + 1 == n ? 0 : i + 1; }

/// Unit tangents at the points of a closed curve, of the circles through them and their neighbours.
Curve tangents_of(const Curve& x) {
  const std::size_t n = x.size();
  Curve tangent(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point<2> in = x[i] - x[before(i, n)], out = x[after(i, n)] - x[i];
    const double a = in.norm(), b = out.norm();
    tangent[i] = (b / a * in + a / b * out).normalized();
  }
  return tangent;
}

/// Radians by which the curve turns left at its points: positive where it is concave.
std::vector<double> turns_of(const Curve& x) {
  const std::size_t n = x.size();
  std::vector<double> turn(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point<2> in = x[i] - x[before(i, n)], out = x[after(i, n)] - x[i];
    turn[i] = std::atan2(cross(in, out), in.dot(out));
  }
  return turn;
}

Point<2> leftward(const Point<2>& tangent) { return {-tangent.y(), tangent.x()}; }

/// (1 − ε δ²) x = right: no drift along a straight stretch of equal spacings, whatever ε does.
template <class Value>
std::vector<Value> diffused(const std::vector<double>& epsilon, std::vector<Value> right) {
  const std::size_t n = right.size();
  CyclicTridiagonal matrix(n);
  for (std::size_t i = 0; i < n; ++i) {
    matrix.below[i] = matrix.above[i] = -epsilon[i];
    matrix.diagonal[i] = 1 + 2 * epsilon[i];
  }
  return solve(matrix, std::move(right));
}

/// ε of a curve: the turn to the left, spread over the neighbourhood; empty where the curve is convex throughout.
std::vector<double> sensed_concavity(const Curve& x, double smoothing) {
  const std::size_t n = x.size();
  std::vector<double> sensor = turns_of(x);
  for (double& turn : sensor) turn = smoothing * std::max(0.0, turn - 1e-6);
  if (std::all_of(sensor.begin(), sensor.end(), [](double s) { return s == 0; })) return {};
  return diffused(std::vector<double>(n, concavity_reach), std::move(sensor));
}

/// One step to the left along the normals, both smoothed where ε > 0.
Curve stepped(const Curve& x, double spacing, double smoothing) {
  const std::size_t n = x.size();
  const Curve tangent = tangents_of(x);
  Curve normal(n), next(n);
  for (std::size_t i = 0; i < n; ++i) normal[i] = leftward(tangent[i]);
  const std::vector<double> epsilon = sensed_concavity(x, smoothing);
  if (!epsilon.empty()) normal = diffused(epsilon, std::move(normal));
  for (std::size_t i = 0; i < n; ++i) next[i] = x[i] + spacing * normal[i].normalized();
  if (epsilon.empty()) return next;
  const Curve smoothed = diffused(epsilon, next);
  for (std::size_t i = 0; i < n; ++i) {
    const Point<2> shift = smoothed[i] - next[i], unsmoothed = leftward(tangent[i]);
    next[i] += shift - std::min(0.0, shift.dot(unsmoothed)) * unsmoothed;
  }
  return next;
}

/// Slides points along the curve so that neighbouring spacings become more nearly equal.
Curve redistributed(const Curve& x, double alpha) {
  const std::size_t n = x.size();
  const Curve tangent = tangents_of(x);
  std::vector<ArcSegment> segments;
  segments.reserve(n);
  std::vector<double> length(n);
  for (std::size_t i = 0; i < n; ++i) {
    segments.emplace_back(x[i], tangent[i], x[after(i, n)], tangent[after(i, n)]);
    length[i] = segments[i].length();
  }
  const std::vector<double> even = diffused(std::vector<double>(n, alpha), length);
  Curve moved(n);
  for (std::size_t i = 0; i < n; ++i) {
    double shift = alpha * (even[i] - even[before(i, n)]);
    std::size_t k = i;
    for (; shift < 0; shift += length[k]) k = before(k, n);
    for (; shift > length[k]; k = after(k, n)) shift -= length[k];
    moved[i] = segments[k].position(segments[k].parameter(shift / length[k]));
  }
  return moved;
}

/// Radius of the largest circle inside, to half a spacing.
double inner_radius(const Outline& outline, double spacing) {
  const Point<2> size = outline.bounds().high - outline.bounds().low;
  const int columns = static_cast<int>(std::ceil(size.x() / spacing)), rows = static_cast<int>(std::ceil(size.y() / spacing));
  double radius = 0;
  for (int j = 1; j < 2 * rows; ++j)
    for (int i = 1; i < 2 * columns; ++i) {
      const Point<2> part(0.5 * i / columns, 0.5 * j / rows);
      radius = std::max(radius, -outline.tree().nearest(outline.bounds().low + part.cwiseProduct(size)).distance);
    }
  return radius;
}

double layer_thickness(const Outline& outline, const GrowthOptions& options) {
  if (options.thickness > 0) return options.thickness;
  if (!options.inward) return options.spacing;
  return std::min(options.spacing, deepest * inner_radius(outline, options.spacing) / options.layers);
}

Curve first_layer(const Outline& outline, const GrowthOptions& options) {
  const int along = std::max(16, 4 * static_cast<int>(std::lround(outline.perimeter() / options.spacing / 4)));
  const double step = (options.inward ? 1 : -1) * outline.perimeter();
  Curve curve;
  for (int i = 0; i < along; ++i) curve.push_back(outline.at(step * i / along));
  return curve;
}

GrownGrid march(Curve layer, const GrowthOptions& options, double thickness, double smoothing) {
  GrownGrid grid{.along = static_cast<int>(layer.size()),
                 .layers = options.layers,
                 .spacing = options.spacing,
                 .nodes = layer,
                 .smoothing = smoothing,
                 .thickness = thickness};
  grid.nodes.reserve(layer.size() * static_cast<std::size_t>(options.layers + 1));
  for (int j = 1; j <= grid.layers; ++j) {
    layer = redistributed(stepped(layer, thickness, smoothing), smoothing);
    grid.nodes.insert(grid.nodes.end(), layer.begin(), layer.end());
  }
  return grid;
}

/// The worse of the worst corner ratio and the smallest cell size relative to `size`, the first layer's; ≤ 0: a cell is folded,
/// or the outermost layer meets itself across a bay.
double quality(const GrownGrid& grid, double size) {
  const GridQuality worst = check(grid);
  if (worst.min_corner_ratio > 0 && !is_simple_polygon(Curve(grid.nodes.end() - grid.along, grid.nodes.end())))
    return -1;
  return std::min(worst.min_corner_ratio, worst.min_size / size);
}

void require_sensible(const GrowthOptions& options) {
  if (!(options.spacing > 0) || !std::isfinite(options.spacing))
    throw InputError("the grid spacing must be positive, not " + std::to_string(options.spacing));
  if (options.layers < 3)
    throw InputError("a body grid needs at least 3 layers, not " + std::to_string(options.layers));
}

}  // namespace

GrownGrid grow(const Outline& outline, const GrowthOptions& options) {
  require_sensible(options);
  const double thickness = layer_thickness(outline, options);
  const Curve curve = first_layer(outline, options);
  const double size = std::min(thickness, outline.perimeter() / static_cast<double>(curve.size()));
  GrownGrid best;
  double best_quality = 0;
  for (double smoothing = least_smoothing; smoothing <= most_smoothing && best_quality < good; smoothing *= 2) {
    GrownGrid grid = march(curve, options, thickness, smoothing);
    const double grid_quality = quality(grid, size);
    if (!(grid_quality > best_quality)) continue;
    best = std::move(grid);
    best_quality = grid_quality;
  }
  if (best_quality <= 0)
    throw InputError(
        "a grid of " + std::to_string(options.layers) + " layers of thickness " + std::to_string(thickness) +
        " folds or meets itself on this outline: use fewer layers, a finer spacing or rounder inward corners");
  return best;
}

GrownGrid grow_from(const std::vector<Point<2>>& curve, const GrowthOptions& options, double smoothing) {
  require_sensible(options);
  GrownGrid grid = march(curve, options, options.thickness > 0 ? options.thickness : options.spacing, smoothing);
  require_unfolded(grid);
  return grid;
}

}  // namespace mortise
