// A deforming interface in a few numbers.
#pragma once

#include "mortise/coupler/deforming.hpp"

namespace mortise {

/// Non-dimensional; means are weighted by present length.
struct InterfaceMeasures {
  Box<2> box;                            // of the nodes
  double area = 0;                       // enclosed; 0 for curves that are not closed
  double pressure = 0;                   // mean of the physical pressure; NaN where it is not known yet
  Point<2> velocity = Point<2>::Zero();  // mean over the last step
  Point<2> force = Point<2>::Zero();     // of the fluid on the structure
};

InterfaceMeasures measure(const InterfaceState& interface, double p_inf);

/// Area on the structure's side: what a closed curve encloses, positive around the structure and negative around the
/// fluid; otherwise between the curve and a fixed straight line along its period, or, without period, along x (right up
/// to a constant while its ends stay on lines across that).
double area_below(const InterfaceState& interface);

}  // namespace mortise
