// summary.json: what a run was and how it ended.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mortise/cases/summary/oscillation.hpp"
#include "mortise/cases/summary/provenance.hpp"

namespace mortise {

/// Against the exact solution, over active cells; l1 and l2 are volume-weighted means. Non-dimensional.
struct ErrorNorms {
  double l1 = 0, l2 = 0, max = 0;
};

/// A rigid body at the end of the run.
struct BodySummary {
  std::string name;
  std::vector<double> position, velocity;  // one number per dimension
  double angle = 0;                        // radians
  double angular_velocity = 0;             // radians per time
};

/// An elastic solid at the end of the run. Vectors hold one number per dimension.
struct SolidSummary {
  std::string name, law;
  double mass = 0;
  std::vector<double> position, velocity;  // of the centre of mass
  std::vector<double> momentum;
  double angular_momentum = 0;  // about the centre of mass
  double kinetic_energy = 0, strain_energy = 0;
  double least_j = 1;        // smallest J in it
  double max_von_mises = 0;  // largest von Mises stress in it
};

/// A deforming interface at the end of the run.
struct InterfaceSummary {
  std::string name;
  std::vector<double> low, high;  // corners of the box around it
  double area = 0;                // enclosed; 0 for curves that are not closed
  double pressure = 0;            // mean over the last step and the interface, as velocity
  std::vector<double> velocity;
  std::vector<double> force;  // of the fluid on the structure
};

/// How a probe moved along one direction in the window that the case asks for.
struct OscillationSummary {
  std::string probe, component;  // component: x, y
  Oscillation oscillation;
};

/// Relative change over the run of what a closed scene (walls, periodic sides, free or resting sides of solids)
/// contains: gas, bodies and solids, less the work of the pressure at which solids are in equilibrium; overlapping
/// cells are shared out smoothly, so that interpolation between grids shows as a defect. NaN where it is not a
/// conserved quantity.
struct ConservationSummary {
  double mass = 0, momentum = 0, energy = 0;
};

struct OverlapSummary {
  std::int64_t orphans = 0, fringe = 0, holes = 0;  // cells, at the end of the run
  std::int64_t tight = 0;  // interpolated cells with a donor clamped to a wall row, summed over the steps
};

struct RunSummary {
  std::string case_name, scheme;
  std::string status = "finished";  // finished, unstable, failed
  std::string reason;               // one sentence when not finished
  double time = 0;                  // reached
  std::int64_t steps = 0;
  int ranks = 1;
  double wall_seconds = 0, cell_updates = 0;
  double skipped_fraction = 0;                              // of all cell updates
  std::map<std::string, double> phases;                     // seconds
  std::int64_t memory_bytes = 0;                            // largest resident size, sum over ranks
  std::vector<std::pair<std::string, std::int64_t>> cells;  // per grid
  std::vector<std::pair<std::string, ErrorNorms>> errors;   // "fluid.density", …; empty without an exact solution
  std::optional<ConservationSummary> conservation;
  std::vector<BodySummary> bodies;
  std::vector<SolidSummary> solids;
  std::vector<InterfaceSummary> interfaces;
  std::vector<OscillationSummary> oscillations;  // empty where none were asked for, or their window was not reached
  OverlapSummary overlap;
  std::int64_t contacts = 0;        // impulses between bodies, or bodies and walls
  std::int64_t repeated_steps = 0;  // with half the Δt, after an inadmissible state
  std::int64_t first_order_steps = 0;  // of the gas, where it would have lost its pressure otherwise
  Provenance provenance;
  std::string case_text;  // the case file with overrides appended
};

/// Writes summary.json atomically; numbers that are not finite become null. cell_updates_per_second is derived.
/// Throws EnvironmentError.
void write_summary(const RunSummary& summary, const std::string& path);

}  // namespace mortise
