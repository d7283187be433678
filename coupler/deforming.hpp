// One deforming interface: a structure on one side, on the other a fluid grid whose layer 0 follows it.
//
// One step, t → t + Δt:
//   predict   the fluid's grid moves on as in the last step; half-time data of the fluid at its wall faces
//   solve     the scheme: pressures of the fluid's faces, tractions and velocities of the structure's
//   move      nodes x^{n+1} = x^n + Δt w of the interface; the fluid's grid grown anew from it, or stretched
//   load      tractions from the pressures on the mean area vectors of the step: action = reaction to round-off
// A structure that is faster than the fluid takes several steps within one of the fluid's (substeps), the fluid's data
// being linear in time; the fluid then gets the mean of the substeps' pressures and its wall the mean of their motion.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mortise/coupler/schemes.hpp"
#include "mortise/fluid/euler_solver.hpp"

namespace mortise {

/// How an interface is coupled and how the fluid's grid follows it.
struct InterfaceSetup {
  std::string name;                 // in output: that of the structure
  std::size_t body = 0;             // of EulerSetup::bodies: the grid whose layer 0 is the interface at t = 0 (undeformed)
  std::string scheme = "projection";  // key of interface_schemes()
  InterfaceOptions options;
  bool inward = false;              // the fluid's grid was grown into the outline
  std::vector<Point<2>> far;        // not empty: the fluid's last layer stays here, the grid is stretched (its row() nodes)
  bool substeps = true;             // let the structure take substeps where it is faster
  std::function<Point<2>(const Point<2>& X)> displacement;  // of the interface at t = 0; empty: none
  std::function<Point<2>(const Point<2>& X)> velocity;      // of the interface at t = 0; empty: at rest
};

/// The interface as it is now, for output. Nodes and faces in the structure's order.
struct InterfaceState {
  std::string name;
  bool periodic = true;
  std::vector<Point<2>> nodes, node_velocities;  // present positions; velocity of the last step (mean over it)
  std::vector<double> pressure;                  // p̃ per *fluid* face, mean over the last step
  std::vector<Point<2>> fluid_nodes;             // present positions of the fluid's layer 0, in its order
  Point<2> force = Point<2>::Zero();             // of the fluid on the structure, mean over the last step
  double half_time = 0;                          // node velocities and pressure are those of this time
};

}  // namespace mortise
