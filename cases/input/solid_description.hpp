// What a case file can say about elastic solids and the interfaces they share with the gas, as plain data.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace mortise {

/// A closed outline about its own origin.
struct ShapeDescription {
  std::string shape;  // bodies: circle, ellipse, stick, rectangle, polygon, spline (2D); slab, half_space (1D)
  double radius = 0;  // circle
  std::array<double, 2> semi_axes{};           // ellipse: along x and y at angle 0
  std::array<double, 2> size{};                // stick, rectangle: width (x) and height (y) at angle 0
  double fillet = 0;                           // stick, rectangle, polygon: corner radius
  std::vector<std::array<double, 2>> corners;  // polygon, about the body's own origin
  std::string points;  // spline: file of points; found beside the case file, here with its folder
};

/// Non-dimensional; [solid] scale is in it.
struct MaterialDescription {
  std::string law;  // linear, saint_venant_kirchhoff, neo_hookean; default: linear, for immersed solids neo_hookean
  double density = 0, lambda = 0, mu = 0;
};

/// A side of a solid that is no interface.
struct SideDescription {
  std::string kind;      // free, fixed, slip, periodic, exact; empty: default
  std::string traction;  // prescribed normal traction n·P n, a formula of t, x, y (reference position); empty: none
};

/// The solid at t = 0.
struct SolidInitialDescription {
  // rest: undeformed, with the solid's velocity and angular velocity; exact: of the exact solution (default where that
  // knows the solid); plane_wave: u = amplitude (position + c_p t − n·X)₊ n, a front that runs along n; formula.
  std::string kind;
  double amplitude = 0.01;        // plane_wave: compression behind the front, −n·∇u n; exact waves: displacement
  double position = 0;            // plane_wave: the front at t = 0 is the line n·X = position
  double angle = 0;               // plane_wave, exact plane waves: direction of n in degrees from +x
  std::string wave = "pressure";  // exact plane waves: pressure, shear
  double length = 1;              // exact plane and surface waves: of the wave
  int mode = 1;                   // exact modes of an annulus: number of half waves across
  std::string displacement_x, displacement_y, velocity_x, velocity_y;  // formula: of x, y (reference position)
};

/// Reference-map solids in an incompressible fluid: material within `radius` of `center` (reference position) is led along a path;
/// formulas of t, 0 at t = 0 where the material begins undisplaced; empty: 0.
struct AnchorDescription {
  std::array<double, 2> center{};
  double radius = 0;
  std::string x, y, angle;  // displacement; angle in radians
};

/// One elastic solid. Its reference frame is space: X is the position at t = 0 before any initial displacement.
struct SolidDescription : ShapeDescription {
  // shape, further: annulus; plate (rectangle with a round hole, or without); strip (behind a straight wall through the
  // origin)
  std::string place;                          // file:line:column of its table
  std::string name;                           // default: <shape>_<index>, counted on from the bodies
  double inner_radius = 0, outer_radius = 0;  // annulus
  std::array<double, 2> low{}, high{};        // plate: opposite corners
  double hole = 0;                            // plate: radius of a hole around `position`; 0: none
  double thickness = 0;                       // strip
  std::string wall;                  // strip: height of the wall above the straight line, a formula of x along it
  std::string gas;                   // where it meets gas: outside, inside (annulus, plate), none
  std::array<double, 2> position{};  // of its centre at t = 0
  double angle = 0;                  // degrees
  std::array<double, 2> velocity{};  // at t = 0
  double angular_velocity = 0;       // radians per time, at t = 0
  int layers = 0;                    // cell layers of the gas grid around it; 0: default
  MaterialDescription material;
  double viscosity = 0;   // incompressible fluid: of the material
  std::string actuation;  // incompressible fluid: principal stretch along the body's x axis it tends to, of x, y (about its centre), t
  std::vector<AnchorDescription> anchors;
  SolidInitialDescription initial;
  SideDescription outer, inner, left, right, bottom, top, back;

  bool annulus() const { return shape == "annulus"; }
  bool plate() const { return shape == "plate"; }
  bool strip() const { return shape == "strip"; }
  bool immersed() const { return !annulus() && !plate() && !strip(); }  // an outline with the solid inside
  bool wet() const { return gas != "none"; }                            // has an interface
};

/// What all solids share.
struct SolidOptionsDescription {
  double scale = 1;                  // multiplies density, λ and μ
  std::string limiter;               // none, minmod, mc; default: none where the fluid has none, else mc
  double null_mode_upwinding = 0.5;  // of the deformation gradient (solid/elastic_step.hpp)
};

/// How interfaces are coupled, beside the scheme.
struct CouplingDescription {
  std::string fsrp = "nonlinear";              // fluid-structure Riemann problem: nonlinear, linear
  std::string wall_velocity = "extrapolated";  // traditional schemes: extrapolated (second order), lagged
  std::string load = "current";                // p − p_e acts per current or per reference area
  double reference_pressure = 0;  // p_e; default: the gas's pressure at t = 0 (uniform, or ahead of the shock)
  bool substeps = true;           // a faster solid takes several steps within one of the gas
  double blur = 2;        // reference-map: half width of the zone in which a solid fades into the gas, in cells
  double face_ratio = 1;          // faces of the gas per face of the solid along the interface
};

}  // namespace mortise
