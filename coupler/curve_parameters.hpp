// Where the nodes of two divisions of one curve lie on it.
#pragma once

#include <array>
#include <vector>

#include "mortise/grids/core/types.hpp"

namespace mortise {

struct CurveParameters {
  /// A point of the curve on four of the structure's nodes, numbered along the curve: Lagrange weights of the cubic
  /// through them; a node is itself, exactly.
  struct Place {
    std::array<std::size_t, 4> node{};
    std::array<double, 4> weight{};
  };
  std::vector<double> structure, fluid;  // reference arc length at the nodes, one more than faces
  std::vector<double> lengths;           // of the structure's faces
  std::vector<Place> places;             // per fluid node
  double farthest = 0;                   // distance of a fluid node from the structure's polygon
};

/// Nodes of either side in the order of its faces; periodic: one per face, node n + faces being node n shifted by the
/// period. The fluid's faces run the other way along the curve. The fluid's side need not be periodic where the
/// structure's is: it then has one period of it, with both ends.
CurveParameters curve_parameters(const std::vector<Point<2>>& structure, bool periodic, const Point<2>& period, const std::vector<Point<2>>& fluid,
                                 bool fluid_periodic);

}  // namespace mortise
