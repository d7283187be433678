// What mortise asks of CGAL in the plane: is a polygon simple, and which points are Delaunay neighbours.
// All tests use exact predicates (Exact_predicates_inexact_constructions_kernel).
#pragma once

#include <utility>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

/// No two edges of the closed polygon meet except neighbours at their common vertex.
bool is_simple_polygon(const std::vector<Point<2>>& vertices);

/// Orientation of a simple polygon.
bool is_counter_clockwise(const std::vector<Point<2>>& vertices);

/// Pairs (a, b) of indices into `points` joined by an edge of the Delaunay triangulation; coincident points
/// are paired with one another. Unsorted, each pair once or more.
std::vector<std::pair<int, int>> delaunay_edges(const std::vector<Point<2>>& points);

}  // namespace mortise
