// Scenes with elastic solids: immersed in gas, or alone.
#include <algorithm>
#include <cmath>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

/// Begins a scene of solids in gas over a background, up to the solids.
CaseText begin_solids(Dice& dice, const std::string& title, const std::string& scheme, const Stage& stage,
                      const Flow& flow, double fastest) {
  CaseText text;
  write_head(text, title + ", " + flow.kind + ", " + scheme + (stage.gentle ? ", gentle" : ""), scheme, stage);
  text.table("grid").number("factor", stage.factor);
  text.numbers("low", {stage.low[0], stage.low[1]}).numbers("high", {stage.high[0], stage.high[1]});
  write_time(text, stage, end_of(stage, fastest, dice.whole(40, 120)));
  write_gas(text, dice, stage);
  write_sides(text, dice, stage, flow);
  write_flow(text, stage, flow);
  write_coupling(text, dice, stage, false);
  write_output(text, dice);
  return text;
}

void write_solid(CaseText& text, Dice& dice, const Stage& stage, const Material& material, const Shape& shape,
                 const Place& place) {
  text.entry("solids");
  write_shape(text, shape);
  text.numbers("position", {place.position[0], place.position[1]});
  if (place.angle != 0) text.number("angle", place.angle);
  const double fast = stage.gentle ? 0.02 * weakness_of(stage, material) * stage.sound : 0.7 * stage.sound;
  if (dice.chance(0.3))
    text.numbers("velocity", {Dice::rounded(fast * dice.between(-1, 1)), Dice::rounded(fast * dice.between(-1, 1))});
  if (!stage.gentle && dice.chance(0.15))
    text.number("angular_velocity", Dice::rounded(fast / shape.radius * dice.between(-1, 1)));
  write_material(text, material);
}

/// Solids with room for a grid inside.
std::vector<Shape> draw_shapes(Dice& dice, const Stage& stage, int count) {
  std::vector<Shape> shapes;
  for (int k = 0; k < count; ++k) {
    shapes.push_back(draw_shape(dice, stage, 0.4, 7 * stage.spacing() / stage.length));
    Shape& shape = shapes.back();
    if (shape.fillet > 0) shape.fillet = std::max(shape.fillet, Dice::rounded(2 * stage.spacing()));
  }
  return shapes;
}

double draw_traction(Dice& dice, const Material& material) {
  return Dice::rounded(material.density * material.speed() * material.speed() * dice.decades(-5, -1) *
                       (dice.chance(0.5) ? 1 : -1));
}

/// One side of a solid without gas.
void write_side(CaseText& text, Dice& dice, const Stage& stage, const Material& material, const std::string& side) {
  if (dice.chance(0.3))
    text.word("traction." + side, digits(draw_traction(dice, material)) + "*sin(" +
                                      digits(Dice::rounded(material.speed() / stage.length * dice.decades(0, 1))) +
                                      "*t)");
  else
    text.word("sides." + side, dice.word({"free", "fixed", "slip"}));
}

/// A displacement of small strain.
void write_displacement(CaseText& text, Dice& dice, const Stage& stage, const Material& material) {
  const double k = Dice::rounded(dice.between(2, 8) / stage.length),
               amplitude = Dice::rounded(dice.decades(-6, -1.5) / k);
  text.table("solids.initial").word("kind", "formula");
  text.plain("displacement", "[\"" + digits(amplitude) + "*sin(" + digits(k) + "*x)\", \"" + digits(amplitude) +
                                 "*cos(" + digits(k) + "*y)\"]");
  if (dice.chance(0.5))
    text.plain("velocity",
               "[\"" + digits(Dice::rounded(amplitude * k * material.speed())) + "*cos(" + digits(k) + "*x)\", \"0\"]");
}

}  // namespace

Material draw_material(Dice& dice, const Stage& stage) {
  Material material;
  material.law = dice.word({"linear", "saint_venant_kirchhoff", "neo_hookean", "neo_hookean"});
  const double impedance = dice.decades(-6, 6);  // against the gas's
  const double speed = dice.chance(0.8) ? dice.decades(-1, 1) : dice.decades(1, 1.7);
  material.density = Dice::rounded(impedance * stage.density / speed);
  const double modulus = material.density * std::pow(stage.sound * speed, 2);
  material.mu = Dice::rounded(modulus * (dice.chance(0.8) ? dice.between(0.1, 0.49) : dice.decades(-3, -1)));
  material.lambda = Dice::rounded(modulus - 2 * material.mu);
  return material;
}

void write_material(CaseText& text, const Material& m) {
  text.plain("material", "{law = \"" + m.law + "\", density = " + digits(m.density) + ", lambda = " + digits(m.lambda) +
                             ", mu = " + digits(m.mu) + "}");
}

double weakness_of(const Stage& stage, const Material& m) {
  return std::min(m.mu / (stage.gamma * stage.shifted_pressure()), m.speed() / stage.sound);
}

void write_coupling(CaseText& text, Dice& dice, const Stage& stage, bool round) {
  text.table("coupling").number("reference_pressure", stage.pressure());
  if (dice.chance(0.3)) text.word("fsrp", "linear");
  if (dice.chance(0.3)) text.word("load", "reference");
  if (dice.chance(0.3)) text.word("wall_velocity", "lagged");
  if (dice.chance(0.2) && round) text.number("face_ratio", dice.pick<double>({0.5, 2, 0.7, 1.6}));
  if (dice.chance(0.5)) return;
  text.table("solid").word("limiter", dice.word({"none", "minmod", "mc"}));
  if (dice.chance(0.5)) text.number("null_mode_upwinding", 1);
}

std::string draw_interface_scheme(Dice& dice) {
  return dice.word({"projection", "projection", "projection", "projection", "traditional", "traditional-subiterated",
                    "anti-traditional"});
}

Scene plane_solids(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, 2);
  const int count = dice.whole(1, 2);
  std::vector<Material> materials;
  double weakness = 1;
  for (int k = 0; k < count; ++k) {
    materials.push_back(draw_material(dice, stage));
    weakness = std::min(weakness, weakness_of(stage, materials.back()));
  }
  const Flow flow = draw_flow(dice, stage, weakness);
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_solids(dice, title, scheme, stage, flow, flow.fastest);
  std::vector<Shape> shapes = draw_shapes(dice, stage, count);
  const std::vector<Place> places = place_apart(dice, stage, shapes, 3.5 * stage.spacing());
  for (std::size_t k = 0; k < shapes.size(); ++k) write_solid(text, dice, stage, materials[k], shapes[k], places[k]);
  return {flow.kind, scheme, stage.gentle && scheme == "projection", text.text()};
}

Scene mixed_plane(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, 2);
  const Material material = draw_material(dice, stage);
  const Flow flow = draw_flow(dice, stage, weakness_of(stage, material));
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_solids(dice, title, scheme, stage, flow, flow.fastest);
  std::vector<Shape> shapes = draw_shapes(dice, stage, 2);
  const std::vector<Place> places = place_apart(dice, stage, shapes, 4 * stage.spacing());
  if (shapes.size() > 1) write_plane_body(text, dice, stage, shapes[1], places[1], scheme == "traditional");
  write_solid(text, dice, stage, material, shapes[0], places[0]);
  return {flow.kind, scheme, false, text.text()};
}

Scene solids_alone(Dice& dice, const std::string& title) {
  Stage stage = draw_stage(dice, 2);
  const Material material = draw_material(dice, stage);
  const std::string shape = dice.word({"plate", "plate", "plate with a hole", "annulus", "outline"});
  CaseText text;
  write_head(text, title + ", " + shape, "none", stage);
  text.table("grid").number("factor", stage.factor);
  write_time(text, stage, end_of(stage, material.speed(), dice.whole(40, 200)));
  write_output(text, dice);
  if (dice.chance(0.5)) text.table("solid").word("limiter", dice.word({"none", "minmod", "mc"}));
  text.entry("solids");
  std::vector<std::string> sides = {"left", "right", "bottom", "top"};
  if (shape == "annulus") {
    const double outer = stage.high[0];
    text.word("shape", "annulus")
        .number("inner_radius", Dice::rounded(outer * dice.between(0.2, 0.7)))
        .number("outer_radius", outer);
    sides = {"inner", "outer"};
  } else if (shape == "outline") {
    write_shape(text, draw_shape(dice, stage, 0.8, 4 * stage.spacing() / stage.length));
    text.word("gas", "none");
    sides = {"outer"};
  } else {
    text.word("shape", "plate")
        .numbers("low", {stage.low[0], stage.low[1]})
        .numbers("high", {stage.high[0], stage.high[1]});
    if (shape != "plate") text.number("hole", Dice::rounded(stage.high[0] * dice.between(0.2, 0.5)));
    if (shape != "plate") sides.emplace_back("inner");
  }
  write_material(text, material);
  const bool repeats = shape == "plate" && dice.chance(0.2);
  for (const std::string& side : sides) {
    if (repeats && (side == "left" || side == "right"))
      text.word("sides." + side, "periodic");
    else
      write_side(text, dice, stage, material, side);
  }
  const int initial = dice.whole(0, 2);
  if (initial == 0) write_displacement(text, dice, stage, material);
  if (initial == 1) {
    text.table("solids.initial").word("kind", "plane_wave").number("amplitude", dice.decades(-6, -1.5));
    text.number("position", Dice::rounded(stage.low[0] * dice.between(0, 1))).number("angle", dice.between(0, 360));
  }
  return {shape, "none", true, text.text()};
}

}  // namespace mortise::random_scenes
