// What an incompressible flow is made of. Everything is non-dimensional.
#pragma once

#include <functional>
#include <string>

#include "mortise/coupler/reference_map/sides.hpp"
#include "mortise/coupler/reference_map/slopes.hpp"

namespace mortise {

struct IncompressibleSetup {
  Box<2> domain{Point<2>(0, 0), Point<2>(1, 1)};
  Index<2> cells{64, 64};
  Index<2> tile{64, 64};  // cells of a tile; even, divides `cells`
  FlowSides sides{};
  double density = 1;                   // of the fluid, > 0
  double viscosity = 0;                 // dynamic, of the fluid, ≥ 0
  Point<2> gravity = Point<2>::Zero();  // acceleration
  double cfl = 0.5;                     // fraction of the advective limit and of that of the solids, in (0, 1]
  double viscous_fraction = 0.9;        // fraction of the viscous limit, in (0, 1]
  FlowSlopes slopes = FlowSlopes::limited;
  std::string pressure_solver = "automatic";  // key, see pressure_solver_keys()
  /// Of iterative pressure solvers, see PressureProblem. The choice of the upwind side at stagnation lines turns any
  /// change of round-off size into one of the order of the cut-off error there: a density ratio of 3 on 128² cells
  /// gives velocities that differ by 2e-5 after 100 steps for every tolerance from 1e-4 to 1e-13. What a tolerance buys
  /// is ∇·v of the edges.
  double tolerance = 1e-8;
  std::function<Point<2>(const Point<2>& place)> velocity{};  // at t = 0; empty: at rest
};

/// Throws InputError in one sentence when a value is out of its range, sides do not match, or what flows in cannot
/// leave.
void check(const IncompressibleSetup& setup);

}  // namespace mortise
