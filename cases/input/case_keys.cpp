#include "mortise/cases/input/case_keys.hpp"

#include "mortise/cases/input/options.hpp"
#include "mortise/cases/input/solid_keys.hpp"

namespace mortise {
namespace {

const std::vector<std::string> time_only = {"t"};

void visit_grid(Section& s, CaseDescription& c) {
  s.require("factor", "a number > 0; the cells have size 1/(10 factor)");
  s.number("factor", c.grid_factor, positive, "resolution: cells have size h = 1/(10 factor)");
  s.vector("low", c.domain_low, any_number,
           "corner of the domain with the smallest coordinates; required where there is gas. A layer beside a strip: "
           "along the wall and along its normal, the latter 0");
  s.vector("high", c.domain_high, any_number, "corner of the domain with the largest coordinates, likewise");
  s.integers("tile", c.tile, {.low = 2, .high = 4096}, "cells of a background tile, even");
  visit_layer(s, c);
}

void visit_time(Section& s, CaseDescription& c) {
  s.require("end", "a number > 0, the time at which the run ends");
  s.number("end", c.time_end, positive, "time at which the run ends");
  s.number("cfl", c.cfl, {.low = 0, .high = 1, .low_open = true}, "Courant number");
  s.number("step", c.time_step, positive, "fixed time step; chosen from cfl if omitted");
}

void visit_gas(Section& s, CaseDescription& c) {
  s.number("gamma", c.gamma, {.low = 1, .low_open = true}, "ratio of specific heats");
  s.number("p_inf", c.p_inf, non_negative, "p∞ of a stiffened gas, p = (γ − 1) ρ e − γ p∞; 0: ideal gas");
}

void visit_fluid(Section& s, CaseDescription& c) {
  s.choice("kind", c.fluid_kind, options::fluid_kinds, "gas: compressible; incompressible: with density and viscosity");
  s.number("density", c.fluid_density, positive, "incompressible: density");
  s.number("viscosity", c.fluid_viscosity, non_negative, "incompressible: dynamic viscosity");
  s.choice("pressure_solver", c.pressure_solver, options::pressure_solvers, "incompressible: how the pressure is found");
  s.choice("limiter", c.limiter, options::limiters, "slope limiter; none for smooth flow, mc for shocks");
  s.choice("riemann", c.riemann, options::riemann_solvers, "Riemann solver at cell faces");
  s.number("van_albada_k", c.van_albada_k, non_negative, "K of the van Albada limiter's floor ε² = K h³ q²");
}

void visit_boundaries(Section& s, CaseDescription& c) {
  s.choice("left", c.left, options::boundaries, "side at low x");
  s.choice("right", c.right, options::boundaries, "side at high x");
  s.choice("bottom", c.bottom, options::boundaries, "side at low y; not in 1D");
  s.choice("top", c.top, options::boundaries, "side at high y; not in 1D");
  s.state("inflow", c.inflow, c.p_inf, "gas at inflow sides; default: the uniform state, or the gas behind the shock");
}

void visit_region(Section& s, RegionDescription& r) {
  for (const char* key : {"density", "velocity", "pressure"}) s.require(key, "a number or a formula of x, y");
  s.formula("where", r.where, place_only, "non-zero inside the region; omitted in the last region: everywhere else");
  s.formula("density", r.density, place_only, "density");
  s.formulas("velocity", r.velocity_x, r.velocity_y, place_only, "velocity");
  s.formula("pressure", r.pressure, place_only, "pressure");
}

void visit_initial(Section& s, CaseDescription& c) {
  InitialDescription& i = c.initial;
  s.choice("kind", i.kind, options::initial_kinds, "how the gas is at t = 0; required where there is gas");
  s.state("state", i.state, c.p_inf,
          "uniform: the gas; exact: the gas at rest, or the stream, that the exact solution is made from");
  s.state("ahead", i.right, c.p_inf, "shock: gas ahead of the shock");
  s.number("mach", i.mach, {.low = 1, .low_open = true}, "shock: its Mach number relative to the gas ahead");
  s.state("behind", i.left, c.p_inf, "shock: gas behind, instead of mach");
  s.state("left", i.left, c.p_inf, "riemann: gas on the side of low n·x");
  s.state("right", i.right, c.p_inf, "riemann: gas on the side of high n·x");
  s.number("position", i.position, any_number, "shock, riemann: the front is the line n·x = position");
  s.number("angle", i.angle, any_number, "shock, riemann: direction of n in degrees from +x; in 1D, with solids only, 0 or 180");
  s.number("strength", i.strength, any_number, "vortex: β");
  s.number("radius", i.vortex_radius, positive, "vortex: length scale");
  s.vector("center", i.vortex_center, any_number, "vortex: centre at t = 0");
  s.vector("velocity", i.vortex_velocity, any_number, "vortex: velocity of the surrounding stream");
  s.tables("regions", [&](Section& region, std::size_t) { visit_region(region, i.regions.emplace_back()); });
}

void visit_body_shape(Section& s, BodyDescription& b) {
  s.require("shape", "circle, ellipse, stick, rectangle, polygon or spline in 2D, slab or half_space in 1D");
  s.choice("shape", b.shape, options::shapes, "shape of the body");
  visit_outline(s, b);
  s.number("width", b.width, positive, "slab: width");
  s.choice("side", b.side, options::sides, "half_space: side of its surface on which the solid is");
}

void visit_body(Section& s, BodyDescription& b) {
  s.text("name", b.name, "name in all output; default: <shape>_<index>");
  visit_body_shape(s, b);
  s.vector("position", b.position, any_number, "centre of mass at t = 0; half_space: its surface");
  s.number("angle", b.angle, any_number, "angle at t = 0 in degrees; not in 1D");
  s.vector("velocity", b.velocity, any_number, "velocity at t = 0");
  s.number("angular_velocity", b.angular_velocity, any_number, "radians per time at t = 0; not in 1D");
  s.number("density", b.density, non_negative, "density; 0: massless; not together with mass and inertia");
  s.number("mass", b.mass, non_negative, "mass per unit depth, in 1D per unit area; 0: massless");
  s.number("inertia", b.inertia, non_negative, "moment of inertia per unit depth; not in 1D");
  s.choices("fixed", b.fixed, options::degrees_of_freedom, "degrees of freedom that are held");
  s.table("motion", [&](Section& m) {
    m.formula("x", b.motion_x, time_only, "prescribed displacement along x; 0 at t = 0");
    m.formula("y", b.motion_y, time_only, "prescribed displacement along y; 0 at t = 0; not in 1D");
    m.formula("angle", b.motion_angle, time_only, "prescribed turn in degrees; 0 at t = 0; not in 1D");
  });
  s.table("force", [&](Section& f) {
    f.formula("x", b.force_x, time_only, "external force along x");
    f.formula("y", b.force_y, time_only, "external force along y; not in 1D");
    f.formula("torque", b.torque, time_only, "external torque; not in 1D");
  });
  s.choice("surface", b.surface, options::surfaces, "wall: slip wall; exact: the exact solution, which flows through");
  s.integer("layers", b.layers, {.low = 0, .high = 1000},
            "cell layers of the body-fitted grid; 0: chosen by the program");
}

void visit_output(Section& s, CaseDescription& c) {
  s.integer("frames", c.frames, {.low = 0, .high = 100000}, "frames evenly spaced over the run, and one at t = 0");
  s.choices("pictures", c.pictures, options::pictures, "what the PNG frames show");
  s.integer("picture_width", c.picture_width, {.low = 16, .high = 16384}, "pixels");
  s.boolean("hdf5", c.hdf5, "write HDF5 and XDMF files at the frames");
  s.boolean("contours", c.contours, "reference-map: lines of constant ξ in the solids, over all pictures");
  s.interval("oscillation", c.oscillation, non_negative,
             "incompressible reference-map: times between which the motion of the probes is searched for its amplitude and "
             "frequency");
  s.number("checkpoint_interval", c.checkpoint_interval, non_negative, "time between checkpoints; 0: none");
  s.text("directory", c.output, "directory of all output; default: output/<case>");
}

}  // namespace

void visit_case(Section& s, CaseDescription& c) {
  s.text("title", c.title, "what the case shows, in one line");
  s.text("reference", c.reference, "where the case and its numbers are from");
  s.choice(
      "scheme", c.scheme, options::schemes,
      "coupling scheme; omitted: projection with elastic solids in gas, rigid with rigid bodies, none without either");
  s.integer("dimension", c.dimension, {.low = 1, .high = 2}, "1 or 2");
  s.set_dimension(c.dimension);
  s.choice("exact", c.exact, options::exact_solutions, "exact solution to compare with; omitted: none");
  if (c.exact == "none") c.exact.clear();
  s.vector("gravity", c.gravity, any_number, "acceleration of all bodies");
  s.table("grid", [&](Section& t) { visit_grid(t, c); });
  s.table("time", [&](Section& t) { visit_time(t, c); });
  s.table("gas", [&](Section& t) { visit_gas(t, c); });
  s.table("fluid", [&](Section& t) { visit_fluid(t, c); });
  s.table("boundaries", [&](Section& t) { visit_boundaries(t, c); });
  s.table("initial", [&](Section& t) { visit_initial(t, c); });
  s.tables("bodies", [&](Section& t, std::size_t) { visit_body(t, c.bodies.emplace_back()); });
  s.tables("solids", [&](Section& t, std::size_t) { visit_solid(t, c.solids.emplace_back()); });
  s.table("solid", [&](Section& t) { visit_solid_options(t, c.solid); });
  s.table("coupling", [&](Section& t) { visit_coupling(t, c.coupling); });
  s.table("contact", [&](Section& t) {
    t.boolean("enabled", c.contact, "bodies bounce off each other and off walls");
    t.number("restitution", c.restitution, {.low = 0, .high = 1}, "1: elastic, 0: plastic");
    t.number("gap", c.contact_gap, non_negative, "contact distance in cells; 0: what the grids resolve");
  });
  s.table("output", [&](Section& t) { visit_output(t, c); });
  s.tables("probes", [&](Section& t, std::size_t) {
    ProbeDescription& probe = c.probes.emplace_back();
    t.require("position", "where the probe is");
    t.text("name", probe.name, "column in probes.csv; default: probe_<index>");
    t.vector("position", probe.position, any_number, "where the probe is");
  });
}

std::vector<KeyEntry> all_keys() {
  std::vector<KeyEntry> keys;
  CaseDescription defaults;
  Section list(keys, "");
  visit_case(list, defaults);
  return keys;
}

}  // namespace mortise
