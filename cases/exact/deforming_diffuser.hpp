// Steady supersonic flow along +x over an elastic strip (periodic in x, held at its bottom) whose stress-free top is
// the smooth wall Y = wall(X). The gas is a simple wave: on every characteristic of the family that leaves the wall,
// straight and at the Mach angle to the flow, the state is that of the wall, turned from the oncoming stream by the
// slope of the *deformed* wall (prandtl_meyer.hpp). The strip (elastic_strip.hpp) carries the load σN = −(p − p_e) a n
// of the deformed wall (load_law.hpp). The two are brought into equilibrium by iteration, a contraction for stiff
// strips.
#pragma once

#include <functional>
#include <vector>

#include "mortise/cases/exact/elastic_strip.hpp"
#include "mortise/cases/exact/load_law.hpp"

namespace mortise {

/// Non-dimensional.
struct DeformingDiffuserProblem {
  double gamma = 1.4;
  double density = 1.4, speed = 2, pressure = 1;  // of the oncoming stream, supersonic
  double reference_pressure = 1;                  // p_e
  Material material{StressLaw::linear, 10, 10, 10};
  double period = 1, height = 0.5;     // L, H
  std::function<double(double)> wall;  // Y(X) without load, periodic and smooth
  LoadLaw load = LoadLaw::reference_area;
};

/// Y = −amplitude (1 − cos 2πX/period).
std::function<double(double)> cosine_wall(double amplitude, double period);

class DeformingDiffuser : public ExactSolution<2> {
 public:
  /// Throws NumericalError if no equilibrium is found.
  explicit DeformingDiffuser(const DeformingDiffuserProblem& problem, int harmonics = 16);

  /// Above the height where characteristics cross the answer is not unique.
  Primitive<2> state(const Point<2>& x, double t) const override;
  bool smooth() const override { return true; }
  bool describes_solid() const override { return true; }
  ExactSolid solid(const Point<2>& X, double t) const override;
  std::optional<ExactInterface> interface_at(const Point<2>& X, double t) const override;

 private:
  struct Wall {
    Point<2> position, tangent;  // deformed; tangent = d position/dX
    double mach, angle;          // of the gas; angle of the flow
  };
  Wall deformed(double X, const Point<2>& displacement, const Point<2>& displacement_slope) const;
  Wall wall(double X) const;
  double pressure_at(double mach) const;
  double overshoot(double X, const Point<2>& x) const;
  void equilibrate();
  PeriodicSeries surface_displacement(int component) const;

  DeformingDiffuserProblem problem_;
  double mach_, angle_;  // of the oncoming stream: M, ν(M)
  ElasticStrip strip_;
  std::vector<PeriodicSeries> displacement_;  // u_X, u_Y of the top
};

}  // namespace mortise
