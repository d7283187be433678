#include "mortise/cases/scene/solid_grids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/input/expression.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/geometry/frame.hpp"

namespace mortise {
namespace {

using Curve = std::vector<Point<2>>;

Curve circle_nodes(const Point<2>& center, double radius, int faces, bool clockwise) {
  Curve nodes;
  for (int i = 0; i < faces; ++i) {
    const double angle = 2 * std::numbers::pi * i / faces;
    nodes.emplace_back(center.x() + radius * std::cos(angle),
                       center.y() + (clockwise ? -radius : radius) * std::sin(angle));
  }
  return nodes;
}

/// `faces` equal parts of an outline, in the direction in which grow() runs.
Curve outline_nodes(const Outline& outline, int faces, bool clockwise) {
  Curve nodes;
  for (int i = 0; i < faces; ++i)
    nodes.push_back(outline.at((clockwise ? faces - i : i) * outline.perimeter() / faces));
  return nodes;
}

}  // namespace

int even_cells(double length, double spacing) {
  return std::max(4, 2 * static_cast<int>(std::lround(0.5 * length / spacing)));
}

int faces_around(double length, double spacing) {
  return std::max(16, 4 * static_cast<int>(std::lround(0.25 * length / spacing)));
}

GrownGrid strip_grid(const SolidDescription& strip, const LayerDescription& frame, double height, int faces,
                     double spacing, bool periodic) {
  const double angle = frame.angle * std::numbers::pi / 180, length = frame.along_high - frame.along_low;
  const Point<2> normal(std::cos(angle), std::sin(angle)), along(normal.y(), -normal.x());
  const Expression wall(strip.wall.empty() ? "0" : strip.wall, {"x"});
  Curve near, far;
  for (int i = 0; i < faces + (periodic ? 0 : 1); ++i) {
    const double s = frame.along_low + length * (height > 0 ? i : faces - i) / faces;
    const double place[] = {s};
    near.push_back(s * along + wall(place) * normal);
    far.push_back(s * along + height * normal);
  }
  try {
    return stretch_between(near, far, even_cells(std::abs(height), spacing), spacing, periodic,
                           periodic ? Point<2>((height > 0 ? length : -length) * along) : Point<2>(0, 0));
  } catch (const NumericalError& error) {
    throw InputError(std::string("the grid behind or before its wall is folded at t = 0: ") + error.what());
  }
}

GrownGrid ring_grid(const Point<2>& center, double from_radius, double to_radius, int faces, double spacing) {
  const bool clockwise = to_radius > from_radius;
  return stretch_between(circle_nodes(center, from_radius, faces, clockwise),
                         circle_nodes(center, to_radius, faces, clockwise),
                         even_cells(std::abs(to_radius - from_radius), spacing), spacing, true);
}

GrownGrid outline_grid(const Outline& outline, const Pose<2>& pose, const GrowthOptions& options, int faces) {
  GrownGrid grid = grow(outline, options);
  if (faces > 0 && faces != grid.along) {
    const GrowthOptions same{options.spacing, options.layers, options.inward, grid.thickness};
    grid = grow_from(outline_nodes(outline, faces, !options.inward), same, grid.smoothing);
  }
  const Frame<2> frame(pose);
  for (Point<2>& node : grid.nodes) node = frame.to_space(node);
  return grid;
}

}  // namespace mortise
