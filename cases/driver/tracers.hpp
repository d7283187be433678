// The probes of an incompressible flow: material points of solids, and points that move with the fluid.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mortise/cases/driver/mapped_bodies.hpp"
#include "mortise/cases/input/case_description.hpp"
#include "mortise/cases/summary/summary.hpp"

namespace mortise {

class Tracers {
 public:
  /// A probe is in the solid that holds it undeformed, for good; `flow` and the solids are not owned.
  Tracers(const std::vector<ProbeDescription>& probes, const std::vector<MappedSolid>& solids,
          const IncompressibleSolver& flow, bool keep_history);

  /// After a step of dt: points of the fluid by the midpoint rule with the velocities of its end, points of solids
  /// where the map has them. A point that has left the domain stays where it is. Collective.
  void move(double dt);
  /// Notes where they are now.
  void record();

  const std::vector<Point<2>>& positions() const { return positions_; }
  const std::string& name(std::size_t tracer) const { return probes_[tracer].name; }

  /// All that a continued run needs, and its inverse. restore() throws EnvironmentError when they are not these
  /// tracers'.
  std::vector<double> state() const;
  void restore(const std::vector<double>& state);

  /// x and y of every probe within the window; none when the history does not cover it.
  std::vector<OscillationSummary> oscillations(const std::array<double, 2>& window) const;

 private:
  void follow_solids();
  Point<2> velocity_at(Point<2> x) const;

  std::vector<ProbeDescription> probes_;
  const std::vector<MappedSolid>& solids_;
  const IncompressibleSolver& flow_;
  bool keep_history_;
  std::vector<int> solid_of_;  // −1: in the fluid
  std::vector<Point<2>> positions_;
  std::vector<double> times_;                                // of the history
  std::vector<std::array<std::vector<double>, 2>> history_;  // x and y of each tracer
};

}  // namespace mortise
