// Small disturbances of the initial state of a scene: noise that is the same wherever and whenever it is asked for.
#pragma once

#include <array>
#include <vector>

#include "mortise/coupler/simulation.hpp"

namespace mortise {

/// A number and a vector of order 1 at every point: sums of plane waves of random directions and phases, two cells long
/// and longer. along_x: they run and point along x only.
template <int Dim>
class Noise {
 public:
  Noise(unsigned seed, double spacing, bool along_x);
  double scalar(const Point<Dim>& x) const { return sum(waves_[0], x); }
  Point<Dim> vector(const Point<Dim>& x) const;

 private:
  struct PlaneWave {
    Point<Dim> number = Point<Dim>::Zero();
    double phase = 0;
  };
  static double sum(const std::vector<PlaneWave>& waves, const Point<Dim>& x);

  bool along_x_;
  std::array<std::vector<PlaneWave>, 1 + Dim> waves_;  // of the number and of the components
};

/// Adds noise to the initial state of a scene with cells of size `spacing`: `amplitude` times the speed of sound to the
/// velocity of the gas, times γp̃ to its pressure, times c_p to the velocity of elastic solids.
template <int Dim>
void disturb(SimulationSetup<Dim>& setup, double spacing, bool along_x, double amplitude, unsigned seed);

}  // namespace mortise
