// What passes through the interface of a noisy tube leaves one side as it enters the other.
#pragma once

#include "verification/elastic_noise.hpp"

namespace mortise::testing {

/// Drift of the gas's mass, of its energy less the work of the interface, and of the solid's momentum less the impulse
/// of the gas; relative to mass, energy and impulse of the pressure.
struct Defects {
  double mass = 0, energy = 0, momentum = 0;
};

/// Work of the interface on the gas per time: all depends on the distance from the wall only.
inline double power_on_gas(const InterfaceState& interface) {
  return interface.pressure[0] * interface.node_velocities[0].x() * interface.period.norm();
}

inline Defects defects_after(NoisyTube& tube, int steps) {
  const Simulation<2>& simulation = tube.simulation();
  const auto gas = totals(simulation);
  const Point<2> momentum = totals(*simulation.solids()[0]).momentum;
  double work = 0, impulse = 0, pushed = 0;
  for (int i = 0; i < steps; ++i) {
    const double dt = tube.step();
    const InterfaceState interface = tube.interface();
    work += dt * power_on_gas(interface);
    impulse += dt * interface.force.x();
    pushed += dt * interface.pressure[0] * interface.period.norm();
  }
  const auto after = totals(simulation);
  return {std::abs(after[0] - gas[0]) / gas[0], std::abs(after[3] - gas[3] - work) / gas[3],
          std::abs(totals(*simulation.solids()[0]).momentum.x() - momentum.x() - impulse) / pushed};
}

/// z_s/z_f = 10^-6 … 10^6, the wall as quiet as at the start.
inline void expect_conservation(int steps) {
  constexpr double amplitude = 1e-2;
  for (const double impedances : {1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}) {
    NoisyTube tube(impedances, amplitude);
    const Defects defects = defects_after(tube, steps);
    EXPECT_LE(defects.mass, 1e-12) << impedances;
    EXPECT_LE(defects.energy, 1e-12) << impedances;
    EXPECT_LE(defects.momentum, 1e-12) << impedances;
    EXPECT_LE(tube.wall_speed(), amplitude) << impedances;
  }
}

}  // namespace mortise::testing
