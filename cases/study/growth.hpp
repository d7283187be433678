// How fast small disturbances of a scene grow, measured in the solvers themselves: the scene is run twice, once with
// noise added to its initial state, in lockstep, and the energy of the difference of the two is recorded step by step.
// The factor by which the difference grows per step, once the fastest growing disturbance has outgrown the others,
//   factor = exp(½ d(log energy)/d(step)),
// by least squares, is the spectral radius of the linearised step where the scene itself does not change. Below 1, or
// at 1, the scene forgets disturbances; a scene that flows may have physical instabilities, which count, too.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"

namespace mortise {

struct DisturbanceOptions {
  double amplitude = 1e-10;  // of the noise, over speeds of sound and γp̃; in (0, linear)
  double linear = 1e-5;      // the difference has left the linear regime where |δu|/c or |δp|/γp̃ is larger
  int steps = 400;           // at most; > 0
  unsigned seed = 1;         // of the noise
  // A scene on a line with an elastic solid is a strip four cells wide. false: its noise does not vary along the wall,
  // and nothing else does, to the bit, as long as the nodes' coordinates are exact (grid.factor = 0.8, 1.6, 3.2, …);
  // else waves along the wall grow out of round-off. true: they are part of the noise.
  bool along_wall = false;
};

struct Growth {
  // finished: all steps or time.end; grown: the difference left the linear regime, or damped: it fell to round-off;
  // unstable: a run failed in a NumericalError before. The last three end early.
  std::string status;
  std::string reason;                // in words, of any end
  double time = 0;                   // reached
  std::int64_t steps = 0;            // taken
  double factor = 0;                 // growth per step in the window; NaN: too few steps, or no difference
  double rate = 0;                   // growth per time: log factor/dt; NaN likewise
  double dt = 0;                     // mean step in the window
  std::int64_t first = 0, last = 0;  // the window: after these numbers of steps
  std::vector<double> energy;        // of the difference after every step, the initial one first
  std::vector<double> amplitude;     // and its largest relative amplitude
};

/// Runs the case twice, at most to time.end. Collective; the same on every rank. Throws InputError like build_scene().
Growth measure_growth(const CaseDescription& description, const DisturbanceOptions& options = {});

/// factor, rate, dt and window of what has been recorded, from the times of the steps (as many as energies).
void fit_growth(Growth& growth, const std::vector<double>& times);

}  // namespace mortise
