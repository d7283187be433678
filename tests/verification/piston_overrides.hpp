// Variants of the case rigid_piston.
#pragma once

#include "verification/case_runner.hpp"

namespace mortise::testing {

/// A slab in gas (1, 0, 1) on both sides, pushed by 0.5 sin⁴(πt): everything stays smooth up to t = 0.8.
inline Overrides pushed_slab(double mass) {
  return {"bodies.0.shape=slab",     "bodies.0.width=0.2",    "bodies.0.force.x=t < 1 ? 0.5*sin(pi*t)^4 : 0",
          "initial.left=[1,0,1]",    "initial.right=[1,0,1]", "time.end=0.8",
          set("bodies.0.mass", mass)};
}

/// A slab of mass 1 between (1, 0, 1) and (0.125, 0, 0.1), released at t = 0.
inline Overrides slab_between_two_gases() {
  return {"bodies.0.shape=slab",  "bodies.0.width=0.2",          "bodies.0.mass=1",
          "initial.left=[1,0,1]", "initial.right=[0.125,0,0.1]", "time.end=0.8"};
}

/// h = 1/(10 factor).
inline Overrides factor(double value) { return {set("grid.factor", value)}; }

}  // namespace mortise::testing
