#include "mortise/cases/input/solid_keys.hpp"

#include "mortise/cases/input/options.hpp"

namespace mortise {
namespace {

void visit_geometry(Section& s, SolidDescription& b) {
  s.require("shape", "circle, ellipse, stick, rectangle, polygon, spline, annulus, plate or strip");
  s.choice("shape", b.shape, options::solid_shapes, "shape of the solid");
  visit_outline(s, b);
  s.number("inner_radius", b.inner_radius, positive, "annulus: inner radius");
  s.number("outer_radius", b.outer_radius, positive, "annulus: outer radius");
  s.vector("low", b.low, any_number, "plate: corner with the smallest coordinates");
  s.vector("high", b.high, any_number, "plate: corner with the largest coordinates");
  s.number("hole", b.hole, non_negative, "plate: radius of a round hole around position; 0: none");
  s.number("thickness", b.thickness, positive, "strip: thickness behind the wall, which passes through the origin");
  s.formula("wall", b.wall, {"x"}, "strip: height of the wall above the straight line, of the place x along it");
  s.choice("gas", b.gas, options::gas_places,
           "side on which there is gas; omitted: outside, but none for annulus and plate");
}

void visit_material(Section& s, MaterialDescription& m) {
  s.require("density", "a number > 0");
  s.require("lambda", "Lamé's first parameter, λ + μ > 0");
  s.require("mu", "the shear modulus, > 0");
  s.choice("law", m.law, options::laws, "stress law; omitted: neo_hookean if immersed in gas, else linear");
  s.number("density", m.density, positive, "density of the undeformed solid");
  s.number("lambda", m.lambda, any_number, "Lamé's first parameter; λ + μ > 0");
  s.number("mu", m.mu, positive, "shear modulus");
}

void visit_initial(Section& s, SolidInitialDescription& i) {
  s.choice("kind", i.kind, options::solid_initial_kinds,
           "the solid at t = 0; omitted: of the exact solution if that knows the solid, else at rest");
  s.number("amplitude", i.amplitude, any_number, "plane_wave: compression behind the front; exact waves: displacement");
  s.number("position", i.position, any_number,
           "plane_wave: the front is the line n·x = position; exact = plane_waves: a zero of the sine");
  s.number("angle", i.angle, any_number, "plane_wave, exact = plane_waves: direction of n in degrees from +x");
  s.choice("wave", i.wave, options::waves, "exact = plane_waves: their kind");
  s.number("length", i.length, positive, "exact = plane_waves, rayleigh_wave: wave length");
  s.integer("mode", i.mode, {.low = 1, .high = 20}, "exact = annulus_modes: number of half waves across");
  s.formulas("displacement", i.displacement_x, i.displacement_y, place_only, "formula: displacement");
  s.formulas("velocity", i.velocity_x, i.velocity_y, place_only, "formula: velocity");
}

void visit_sides(Section& s, SolidDescription& b) {
  for (const auto& [key, side] : side_keys(b))
    s.choice(key, side->kind, options::solid_sides, "what happens on this side; omitted: free");
}

void visit_tractions(Section& s, SolidDescription& b) {
  for (const auto& [key, side] : side_keys(b))
    s.formula(key, side->traction, {"t", "x", "y"},
              "prescribed normal traction on this side per reference area, tension positive");
}

}  // namespace

std::vector<std::pair<const char*, SideDescription*>> side_keys(SolidDescription& b) {
  return {{"outer", &b.outer}, {"inner", &b.inner},   {"left", &b.left}, {"right", &b.right},
          {"top", &b.top},     {"bottom", &b.bottom}, {"back", &b.back}};
}

void visit_outline(Section& s, ShapeDescription& b) {
  s.number("radius", b.radius, positive, "circle: radius");
  s.vector("semi_axes", b.semi_axes, positive, "ellipse: semi-axes along x and y at angle 0");
  s.vector("size", b.size, positive, "stick, rectangle: width and height at angle 0");
  s.number("fillet", b.fillet, positive, "stick, rectangle, polygon: radius of the rounded corners");
  s.points("corners", b.corners, "polygon: corners relative to the body's own origin");
  s.text("points", b.points, "spline: file of points, one \"x y\" a line, beside the case file");
}

void visit_layer(Section& s, CaseDescription& c) {
  s.choice("kind", c.grid_kind, options::grid_kinds,
           "overlapping: a background and grids fitted to bodies; layer: gas on one grid between a strip's or an "
           "annulus's interface and a fixed far curve");
  s.number("angle", c.layer.angle, any_number, "layer beside a strip: the wall's normal into the gas, degrees from +x");
  s.number("inner_radius", c.layer.inner_radius, positive, "layer in or around an annulus: inner radius of the gas");
  s.number("outer_radius", c.layer.outer_radius, positive, "layer in or around an annulus: outer radius of the gas");
}

void visit_solid(Section& s, SolidDescription& b) {
  s.text("name", b.name, "name in all output; default: <shape>_<index>, counted on from the bodies");
  visit_geometry(s, b);
  s.vector("position", b.position, any_number, "centre at t = 0; not of strips");
  s.number("angle", b.angle, any_number, "angle at t = 0 in degrees");
  s.vector("velocity", b.velocity, any_number, "velocity at t = 0");
  s.number("angular_velocity", b.angular_velocity, any_number, "radians per time at t = 0");
  s.integer("layers", b.layers, {.low = 0, .high = 1000},
            "cell layers of the gas's grid at the interface; 0: chosen by the program");
  s.table("material", [&](Section& t) { visit_material(t, b.material); });
  s.number("viscosity", b.viscosity, non_negative,
           "incompressible fluid: viscosity of the material, besides its elasticity");
  s.formula("actuation", b.actuation, {"x", "y", "t"},
            "incompressible fluid: stretch along the solid's own x axis that it tends to, 1/stretch across; of the "
            "undeformed place about its centre");
  s.tables("anchors", [&](Section& t, std::size_t) {
    AnchorDescription& a = b.anchors.emplace_back();
    t.vector("center", a.center, any_number, "incompressible fluid: where material is held, undeformed");
    t.number("radius", a.radius, positive, "all material so near is held");
    t.formula("x", a.x, {"t"}, "its displacement along x");
    t.formula("y", a.y, {"t"}, "its displacement along y");
    t.formula("angle", a.angle, {"t"}, "its turn about the centre, radians");
  });
  s.table("initial", [&](Section& t) { visit_initial(t, b.initial); });
  s.table("sides", [&](Section& t) { visit_sides(t, b); });
  s.table("traction", [&](Section& t) { visit_tractions(t, b); });
}

void visit_solid_options(Section& s, SolidOptionsDescription& o) {
  s.number("scale", o.scale, positive, "multiplies density, λ and μ of all solids");
  s.choice("limiter", o.limiter, options::solid_limiters,
           "slope limiter in the solids; omitted: none if the fluid has none, else mc");
  s.number("null_mode_upwinding", o.null_mode_upwinding, non_negative,
           "upwinding of what no wave carries in the deformation gradient");
}

void visit_coupling(Section& s, CouplingDescription& c) {
  s.choice("fsrp", c.fsrp, options::fsrps, "Riemann problem at the interface: the gas's full wall law, or acoustic");
  s.choice("wall_velocity", c.wall_velocity, options::wall_velocities,
           "traditional schemes: extrapolated in time to second order, or that of the last step");
  s.choice("load", c.load, options::loads, "current: p − p_e acts per present area; reference: per undeformed area");
  s.number("reference_pressure", c.reference_pressure, any_number,
           "p_e, at which the undeformed solid is in equilibrium; omitted: that of the gas ahead at t = 0");
  s.boolean("substeps", c.substeps, "a solid that is faster than the gas takes several steps within one of the gas");
  s.number("blur", c.blur, {.low = 1, .high = 4},
           "reference-map: half width of the zone in which a solid fades into the gas, in cells");
  s.number("face_ratio", c.face_ratio, {.low = 0.125, .high = 8},
           "faces of the gas per face of the solid along interfaces");
}

}  // namespace mortise
