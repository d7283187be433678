// Which bodies face each other, and how far apart they are.
#pragma once

#include <utility>
#include <vector>

#include "mortise/grids/core/types.hpp"
#include "mortise/grids/geometry/outline.hpp"

namespace mortise {

/// Bodies whose Voronoi regions touch: outline_samples[b] are points on the outline of body b, in the common frame.
/// Two bodies are neighbours when an edge of the Delaunay triangulation of all samples joins them. Sorted pairs
/// (a, b), a < b, each once. Samples should be closer together than the gaps between bodies.
std::vector<std::pair<int, int>> neighboring_bodies(const std::vector<std::vector<Point<2>>>& outline_samples);

/// Smallest distance between two posed outlines (polygons), with the closest points in the common frame when
/// asked for. Where the bodies overlap: minus an estimate of the largest depth of a vertex of one inside the other
/// (every 16th vertex or so, then all around the deepest), with that vertex and the nearest point of the other's
/// outline. In both cases (on_b − on_a)/distance is the direction from a to b; 0 is returned where they just touch.
double outline_distance(const Outline& a, const Pose<2>& pose_a, const Outline& b, const Pose<2>& pose_b,
                        Point<2>* on_a = nullptr, Point<2>* on_b = nullptr);

}  // namespace mortise
