// Scenes with elastic strips, rings and plates around or beside gas.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

/// A shock that runs against the normal of a wall through the origin, from the far side of the gas.
void turn_to_wall(Flow& flow, double normal, double height) {
  if (flow.kind != "shock" && flow.kind != "riemann") return;
  flow.angle = normal + 180 >= 360 ? normal - 180 : normal + 180;
  flow.position = Dice::rounded(-0.7 * height);
}

CaseText begin_layer(Dice& dice, const std::string& title, const std::string& scheme, const Stage& stage,
                     const Flow& flow) {
  CaseText text;
  write_head(text, title + ", " + flow.kind + ", " + scheme + (stage.gentle ? ", gentle" : ""), scheme, stage);
  write_time(text, stage, end_of(stage, flow.fastest, dice.whole(60, stage.dimension == 1 ? 400 : 150)));
  write_gas(text, dice, stage);
  write_flow(text, stage, flow);
  write_coupling(text, dice, stage, true);
  write_output(text, dice);
  return text;
}

bool robust(const Stage& stage, const std::string& scheme) { return stage.gentle && scheme == "projection"; }

}  // namespace

Scene line_strip(Dice& dice, const std::string& title) {
  Stage stage = draw_stage(dice, 1);
  stage.low[0] = 0;
  const Material material = draw_material(dice, stage);
  Flow flow = draw_flow(dice, stage, weakness_of(stage, material));
  turn_to_wall(flow, 0, stage.high[0]);
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_layer(dice, title, scheme, stage, flow);
  text.table("grid")
      .word("kind", "layer")
      .number("factor", stage.factor)
      .number("low", 0)
      .number("high", stage.high[0]);
  text.table("boundaries").word("right", dice.word({"outflow", "wall", flow.kind == "shock" ? "inflow" : "outflow"}));
  text.entry("solids").word("shape", "strip").number("thickness", Dice::rounded(stage.length * dice.between(0.2, 1)));
  write_material(text, material);
  text.word("sides.back", dice.word({"free", "fixed", "slip"}));
  return {flow.kind, scheme, robust(stage, scheme), text.text()};
}

Scene plane_strip(Dice& dice, const std::string& title) {
  Stage stage = draw_stage(dice, 2);
  stage.low[1] = 0;
  const Material material = draw_material(dice, stage);
  Flow flow = draw_flow(dice, stage, weakness_of(stage, material));
  const bool straight = dice.chance(0.6);
  const double normal = straight ? 90 : dice.between(0, 360);
  if (!straight || dice.chance(0.5)) turn_to_wall(flow, normal, stage.high[1]);
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_layer(dice, title, scheme, stage, flow);
  text.table("grid").word("kind", "layer").number("factor", stage.factor).number("angle", normal);
  text.numbers("low", {stage.low[0], 0}).numbers("high", {stage.high[0], stage.high[1]});
  text.table("boundaries");
  const bool repeats = dice.chance(0.4);
  text.word("left", repeats ? "periodic" : "outflow")
      .word("right", repeats ? "periodic" : "wall")
      .word("top", dice.word({"outflow", "wall"}));
  text.entry("solids").word("shape", "strip").number("thickness", Dice::rounded(stage.length * dice.between(0.2, 0.6)));
  if (dice.chance(0.4)) {
    const double k = Dice::rounded(std::numbers::pi / stage.high[0]);
    text.word("wall", digits(Dice::rounded(0.05 * stage.length * dice.between(-1, 1))) + "*cos(" + digits(k) + "*x)");
  }
  write_material(text, material);
  text.word("sides.back", dice.word({"free", "fixed", "slip"}));
  return {flow.kind, scheme, robust(stage, scheme), text.text()};
}

Scene ring(Dice& dice, const std::string& title) {
  Stage stage = draw_stage(dice, 2);
  const Material material = draw_material(dice, stage);
  const Flow flow = draw_flow(dice, stage, weakness_of(stage, material));
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_layer(dice, title, scheme, stage, flow);
  const double middle = Dice::rounded(stage.length * dice.between(0.4, 0.6)), h = stage.spacing();
  const double solid = Dice::rounded(std::max(4 * h, stage.length * dice.between(0.1, 0.3)));  // thickness
  const int layout = dice.whole(0, 2);  // gas in it on one grid, around it, in it over a background
  text.table("grid").number("factor", stage.factor);
  if (layout == 2) {
    const double edge = 1.2 * stage.length;
    text.numbers("low", {-edge, -edge}).numbers("high", {edge, edge});
  } else {
    const double far =
        Dice::rounded(layout == 0 ? middle - std::max(4 * h, 0.15 * stage.length) : middle + 0.4 * stage.length);
    text.word("kind", "layer")
        .number("inner_radius", std::min(middle, far))
        .number("outer_radius", std::max(middle, far));
    text.table("boundaries").word("top", dice.word({"outflow", "wall"}));
  }
  const double inner = layout == 1 ? Dice::rounded(std::max(0.1 * stage.length, middle - solid)) : middle;
  const double outer = layout == 1 ? middle : Dice::rounded(middle + solid);
  text.entry("solids").word("shape", "annulus").number("inner_radius", inner).number("outer_radius", outer);
  text.word("gas", layout == 1 ? "outside" : "inside");
  write_material(text, material);
  text.word(layout == 1 ? "sides.inner" : "sides.outer", dice.word({"free", "fixed", "slip"}));
  return {flow.kind, scheme, robust(stage, scheme), text.text()};
}

Scene hole(Dice& dice, const std::string& title) {
  Stage stage = draw_stage(dice, 2);
  const Material material = draw_material(dice, stage);
  const Flow flow = draw_flow(dice, stage, weakness_of(stage, material));
  const std::string scheme = draw_interface_scheme(dice);
  CaseText text = begin_layer(dice, title, scheme, stage, flow);
  const double radius = Dice::rounded(std::max(stage.length * dice.between(0.25, 0.5), 8 * stage.spacing()));
  text.table("grid").number("factor", stage.factor);
  const double edge = Dice::rounded(1.5 * radius);
  text.numbers("low", {-edge, -edge}).numbers("high", {edge, edge});
  text.entry("solids").word("shape", "plate").number("hole", radius).word("gas", "inside");
  text.numbers("low", {stage.low[0], stage.low[1]}).numbers("high", {stage.high[0], stage.high[1]});
  write_material(text, material);
  for (const char* side : {"left", "right", "bottom", "top"})
    text.word(std::string("sides.") + side, dice.word({"free", "fixed", "slip"}));
  return {flow.kind, scheme, robust(stage, scheme), text.text()};
}

}  // namespace mortise::random_scenes
