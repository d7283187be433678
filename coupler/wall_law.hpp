// What the coupler knows of a fluid: the pressure on a wall that moves relative to it.
#pragma once

#include <functional>

namespace mortise {

/// Pressure P on a wall and its slope P' = dP/dd ≥ 0.
struct WallPressure {
  double pressure = 0, impedance = 0;
};
/// (ρ, p̃, d) → (P, P'); P increases with d, the velocity of the wall into the fluid relative to the fluid.
using WallLaw = std::function<WallPressure(double density, double pressure, double velocity_difference)>;

}  // namespace mortise
