// Numbers for properties that rapidcheck tries.
#pragma once

#include <rapidcheck.h>

namespace mortise::testing {

inline double number_in(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6; }

}  // namespace mortise::testing
