// Everything a case file can say, as plain data: read, checked and with defaults filled in.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "mortise/cases/input/solid_description.hpp"

namespace mortise {

/// Angles are in degrees in case files, and in radians in all output.
inline constexpr double radians_per_degree = std::numbers::pi / 180;

/// One rigid body. Lengths non-dimensional.
struct BodyDescription : ShapeDescription {
  std::string place;                    // file:line:column of its table
  std::string name;                     // default: <shape>_<index>, e.g. "stick_0"
  double width = 0;                     // slab
  std::string side;                     // half_space: "left" or "right": where the solid is
  std::array<double, 2> position{};     // of the centre of mass at t = 0; half_space: of its surface
  double angle = 0;                     // degrees
  std::array<double, 2> velocity{};     // at t = 0
  double angular_velocity = 0;          // radians per time, at t = 0
  std::optional<double> density;        // either density …
  std::optional<double> mass, inertia;  // … or mass (per unit depth; 1D: per unit area) and inertia; zero is allowed
  std::vector<std::string> fixed;       // degrees of freedom held: "x", "y", "angle"
  // Prescribed displacement from the position (motion_angle: from the angle, in degrees) at t = 0; expressions of t
  // that vanish at t = 0; empty: not prescribed.
  std::string motion_x, motion_y, motion_angle;
  std::string force_x, force_y, torque;  // prescribed external force, expressions of t; empty: none
  std::string surface = "wall";          // wall: slip wall; exact: exact data on the inner edge, flow passes through
  int layers = 0;                        // cell layers of the body-fitted grid; 0: default
};

/// One piece of a piecewise initial state: the first region that contains the point counts.
struct RegionDescription {
  std::string where;                                      // expression of x, y (non-zero: inside); empty: everywhere
  std::string density, velocity_x, velocity_y, pressure;  // expressions of x, y
};

struct InitialDescription {
  std::string kind;  // uniform, shock, riemann, vortex, regions, exact (the exact solution at t = 0)
  // (ρ, u, v, p). uniform: state (left and right are equal to it); riemann: left and right of the diaphragm; shock: it
  // runs along n from left (the gas behind it, computed from mach by Rankine-Hugoniot unless given) into right (the gas
  // ahead).
  std::array<double, 4> state{}, left{}, right{};
  double mach = 0;      // shock: speed of the front relative to the gas ahead / speed of sound; 0: behind was given
  double position = 0;  // shock or diaphragm: the line n·x = position; left is n·x < position
  double angle = 0;     // degrees from +x: direction of n (1D: 0)
  double strength = 2;  // vortex: β
  double vortex_radius = 0.15;
  std::array<double, 2> vortex_center{}, vortex_velocity{};
  std::vector<RegionDescription> regions;
};

/// Gas between an interface and a fixed far curve, on one grid that deforms with the interface. Beside a strip: in the
/// frame of the wall, whose normal into the gas is at `angle`; around or in an annulus: a ring.
struct LayerDescription {
  double angle = 0;                           // degrees from +x
  double along_low = 0, along_high = 0;       // extent along the wall, on the right of the normal
  double height = 0;                          // of the gas along the normal
  double inner_radius = 0, outer_radius = 0;  // of the ring of gas
};

struct ProbeDescription {
  std::string name;
  std::array<double, 2> position{};
};

struct CaseDescription {
  std::string path, folder, name, text;  // file read, its folder, case name, the text with overrides appended
  std::string title, reference;
  std::string scheme = "rigid";  // of bodies: rigid, traditional; of interfaces: projection, traditional, …; none
  int dimension = 2;             // 1 or 2; in 1D only entry 0 of vectors and (ρ, u, 0, p) of states count

  std::array<double, 2> domain_low{}, domain_high{};  // of the gas's background; without one: of all there is
  std::string grid_kind = "overlapping";  // overlapping; layer: gas on one deforming grid (LayerDescription)
  LayerDescription layer;
  double grid_factor = 0;  // h = 1/(10 factor)
  double spacing() const { return 0.1 / grid_factor; }
  bool layered() const { return grid_kind == "layer"; }
  std::array<int, 2> tile{};  // cells of a background tile; 0: chosen

  double time_end = 0;
  double cfl = 0.9;
  double time_step = 0;  // fixed Δt; 0: from cfl

  std::string fluid_kind = "gas";  // gas; incompressible: density and viscosity below, boundaries and velocities as given
  double fluid_density = 1, fluid_viscosity = 0;
  std::string pressure_solver = "automatic";  // of an incompressible fluid
  bool incompressible() const { return fluid_kind == "incompressible"; }
  double gamma = 1.4, p_inf = 0;
  std::string limiter = "mc", riemann = "hllc";
  double van_albada_k = 10;

  std::string left = "outflow", right = "outflow", bottom = "outflow",
              top = "outflow";     // inflow, outflow, wall, slip_wall, periodic, exact
  std::array<double, 4> inflow{};  // (ρ, u, v, p) of inflow sides; default: state (uniform) or the gas behind the shock
  bool has_inflow = false;         // a side is inflow

  InitialDescription initial;
  std::string exact;  // key of the exact solution; empty: none

  std::vector<BodyDescription> bodies;
  std::vector<SolidDescription> solids;
  SolidOptionsDescription solid;
  CouplingDescription coupling;
  bool has_gas = true;  // false: elastic solids alone

  std::array<double, 2> gravity{};
  double restitution = 1;  // of contacts: 1 elastic, 0 plastic
  bool contact = true;
  double contact_gap = 0;  // bodies closer than this many cells are in contact; 0: what the overlap resolves

  int frames = 0;  // PNG frames (and HDF5 steps) evenly spaced over the run, plus t = 0
  // schlieren, pressure, velocity, mach, stress, grids; default without gas: stress
  std::vector<std::string> pictures = {"schlieren"};
  int picture_width = 1200;                           // pixels
  bool hdf5 = true;
  bool contours = false;  // lines of constant reference map in the solids, over pictures
  std::optional<std::array<double, 2>> oscillation;  // times between which probes are searched for oscillations
  double checkpoint_interval = 0;  // time between checkpoints; 0: none
  std::string output;              // directory; default: output/<name>

  std::vector<ProbeDescription> probes;
  bool skip = true;
};

}  // namespace mortise
