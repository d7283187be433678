// Runs a case in this process, writes no files, and keeps what tests look at.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mortise/cases/driver/errors.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/scene/scene.hpp"
#include "mortise/fluid/cell.hpp"
#include "mortise/grids/core/error.hpp"
#include "verification/words.hpp"

namespace mortise::testing {

using Overrides = Words;  // the later ones win

/// "key=value" with all digits of the number.
inline std::string set(const std::string& key, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "=%.17g", value);
  return key + text;
}

/// A body after a step (and at t = 0). Angles in radians.
template <int Dim>
struct BodySample {
  double time;
  Pose<Dim> pose;
  Velocity<Dim> velocity;
  BodyLoad<Dim> load;  // mean over the step
};

/// An active cell of any grid.
template <int Dim>
struct ActiveCell {
  int grid;
  Point<Dim> x;
  double volume;
  Primitive<Dim> W;  // with the physical pressure p = p̃ − p∞
};

/// One case between t = 0 and wherever it has been advanced to. One rank. Stays where it was made.
template <int Dim>
class CaseRun {
 public:
  /// Reads the case (a name, or a path) with overrides "key=value", builds it and sets the initial state. skip = false:
  /// also computes the tiles in which nothing happens. Throws InputError.
  explicit CaseRun(const std::string& name, const Overrides& overrides = {}, bool skip = true)
      : description(described(name, overrides, skip)),
        scene(build_scene<Dim>(description)),
        simulation(Communicator(), scene.setup) {
    simulation.initialize();
    histories.resize(simulation.bodies().size());
    record();
  }

  CaseRun(const CaseRun&) = delete;
  CaseRun& operator=(const CaseRun&) = delete;

  /// Steps up to time.end, or to `time`. A computation that fails ends early: see finished(), reason().
  CaseRun& run() { return run(description.time_end); }
  CaseRun& run(double time) {
    try {
      while (simulation.time() < time) step(time);
    } catch (const NumericalError& error) {
      reason_ = error.what();
    }
    return *this;
  }

  /// One step that does not pass `limit`. Throws NumericalError.
  void step(double limit) {
    simulation.advance(limit);
    tight += simulation.fluid().overlap_report().tight;
    record();
  }

  bool finished() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }

  /// Norms of the errors against the case's exact solution, by name ("fluid.density", …, "solid.stress", …).
  std::map<std::string, ErrorNorms> errors() const {
    std::map<std::string, ErrorNorms> all;
    if (description.has_gas && scene.exact->describes_fluid()) all = fluid_errors(simulation, *scene.exact);
    if (scene.exact->describes_solid()) all.merge(solid_errors(simulation, *scene.exact));
    return all;
  }

  /// Largest error over all steps and bodies of the velocity, and of the place, of the bodies.
  double worst_velocity() const {
    return worst([](const BodySample<Dim>& now, const ExactMotion<Dim>& exact) {
      return (now.velocity.template head<Dim>() - exact.velocity).norm();
    });
  }
  double worst_position() const {
    return worst([](const BodySample<Dim>& now, const ExactMotion<Dim>& exact) {
      return (now.pose.position - exact.pose.position).norm();
    });
  }

  /// All active cells, grid by grid.
  std::vector<ActiveCell<Dim>> cells() const {
    std::vector<ActiveCell<Dim>> all;
    const EulerSolver<Dim>& fluid = simulation.fluid();
    for (std::size_t g = 0; g < fluid.grids().size(); ++g) {
      const ComponentGrid<Dim>& grid = fluid.grids()[g];
      for (int t = 0; t < grid.forest.local_count(); ++t) {
        const TileMask& mask = grid.masks[static_cast<std::size_t>(t)];
        if (mask.hole) continue;
        for_each_cell<Dim>(grid.shape, 0, [&](const Index<Dim>& c) {
          const std::size_t k = grid.shape.at(c);
          if (mask.cut() && mask.state[k] != CellState::active) return;
          Primitive<Dim> W = to_primitive(get<Dim>(fluid.fields()[g].tile(t), k), description.gamma);
          W.pressure -= description.p_inf;
          const int number = static_cast<int>(g);
          all.push_back({number, fluid.cell_center(number, t, c), fluid.cell_volume(number, t, c), W});
        });
      }
    }
    return all;
  }

  CaseDescription description;
  Scene<Dim> scene;
  Simulation<Dim> simulation;
  std::vector<std::vector<BodySample<Dim>>> histories;  // per body
  std::int64_t tight = 0;                               // interpolated with clamped donors, summed over the steps

 private:
  static CaseDescription described(const std::string& name, const Overrides& overrides, bool skip) {
    CaseDescription found = read_case(name, overrides, MORTISE_SOURCE_DIR "/cases");
    found.skip = found.skip && skip;
    return found;
  }

  void record() {
    for (std::size_t b = 0; b < histories.size(); ++b) {
      const RigidBody<Dim>& body = simulation.bodies()[b];
      histories[b].push_back({simulation.time(), body.pose, body.y, simulation.loads()[b]});
    }
  }

  template <class Error>
  double worst(Error&& error) const {
    double largest = 0;
    for (std::size_t b = 0; b < histories.size(); ++b)
      for (const BodySample<Dim>& sample : histories[b])
        largest = std::max(largest, error(sample, (*scene.exact->bodies(sample.time))[b]));
    return largest;
  }

  std::string reason_;
};

/// log₂ of the ratio of two errors: the order, when the second is on a grid twice as fine.
inline double order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace mortise::testing
