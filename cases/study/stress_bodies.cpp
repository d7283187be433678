// Scenes with rigid bodies.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

/// A slab, or at an end of the line a half space.
struct Slab {
  std::string side;  // half_space: where the solid is; empty: a slab
  double position = 0, width = 0;
};

/// Slabs from left to right, at least as far apart as the grids need; the rest of the line is shared out at random.
std::vector<Slab> draw_slabs(Dice& dice, const Stage& stage) {
  const double least = 3.1 * stage.spacing();
  int count = dice.whole(1, 3);
  std::vector<double> widths, shares;
  double room = stage.high[0] - stage.low[0], shared = 0;
  for (int k = 0; k < count; ++k) {
    widths.push_back(Dice::rounded(stage.length * (dice.chance(0.7) ? dice.between(0.05, 0.3) : dice.decades(-5, -1))));
    if (room - widths.back() < 3 * least && k > 0) {
      widths.pop_back();
      break;
    }
    room -= widths.back() + least;
  }
  count = static_cast<int>(widths.size());
  room -= least;
  for (int k = 0; k <= count; ++k) {
    shares.push_back(dice.chance(0.3) ? 0.0 : dice.between(0.1, 1));
    shared += shares.back();
  }
  if (shared == 0) shared = shares.back() = 1;
  std::vector<Slab> slabs;
  double x = stage.low[0];
  for (int k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    x += least + room * shares[i] / shared;
    Slab slab{"", x + 0.5 * widths[i], widths[i]};
    if (k == 0 && dice.chance(0.2)) slab = {"left", x + widths[i], 0};
    if (k > 0 && k + 1 == count && dice.chance(0.2)) slab = {"right", x, 0};
    slabs.push_back(slab);
    x += widths[i];
  }
  return slabs;
}

/// Mass against that of the gas: none, next to none, or anything up to very heavy.
double draw_weight(Dice& dice, bool massive) {
  const int choice = dice.whole(0, 9);
  if (choice < 2 && !massive) return 0;
  if (choice < 3) return dice.decades(-14, -6);
  if (choice < 6) return dice.decades(-1, 1.5);
  return dice.decades(-6, 6);
}

/// A displacement that starts gently or at full speed, and does not go farther than `reach`.
std::string draw_motion(Dice& dice, double reach, double speed) {
  const double amplitude = Dice::rounded(reach * dice.between(0.1, 0.5)), frequency = Dice::rounded(speed / amplitude);
  const std::string a = digits(amplitude), w = digits(frequency);
  const int choice = dice.whole(0, 2);
  if (choice == 0) return a + "*sin(" + w + "*t)";
  if (choice == 1) return "0.5*" + a + "*(1 - cos(" + w + "*t))";
  return "-" + a + "*(1 - exp(-" + w + "*t))";
}

void write_line_motion(CaseText& text, Dice& dice, const Stage& stage, const Slab& slab, bool massive) {
  const double unit = stage.density * (slab.width > 0 ? slab.width : 0.1 * stage.length);  // of the mass
  const int choice = dice.whole(0, 9);
  if (choice == 0) {
    text.words("fixed", {"x"});
    return;
  }
  if (choice == 1) {
    text.word("motion.x", draw_motion(dice, 3 * stage.spacing(), stage.sound * dice.decades(-1, 0.3)));
    return;
  }
  const double weight = draw_weight(dice, massive);
  if (slab.width > 0 && dice.chance(0.5))
    text.number("density", Dice::rounded(weight * stage.density));
  else
    text.number("mass", Dice::rounded(weight * unit));
  if (!stage.gentle && dice.chance(0.3)) text.number("velocity", Dice::rounded(stage.sound * dice.between(-2, 2)));
  if (choice == 2)
    text.word("force.x", digits(Dice::rounded(stage.shifted_pressure() * dice.between(-1, 1))) + "*cos(" +
                             digits(Dice::rounded(stage.sound / stage.length * dice.decades(0, 1.5))) + "*t)");
}

void write_contact(CaseText& text, Dice& dice) {
  text.table("contact").number("restitution", dice.pick<double>({1, 1, 0, 0.5}));
}

std::string draw_body_scheme(Dice& dice) { return dice.chance(0.85) ? "rigid" : "traditional"; }

/// What a scene with rigid bodies begins with, up to the bodies.
CaseText begin_bodies(Dice& dice, const std::string& title, const std::string& scheme, const Stage& stage,
                      const Flow& flow, double fastest, bool repeat = true) {
  CaseText text;
  write_head(text, title + ", " + flow.kind + ", " + scheme, scheme, stage);
  if (dice.chance(0.1)) {
    const double g = stage.sound * stage.sound / stage.length;
    std::vector<double> gravity;
    for (int d = 0; d < stage.dimension; ++d) gravity.push_back(Dice::rounded(g * dice.between(-1, 1)));
    text.numbers("gravity", gravity);
  }
  text.table("grid").number("factor", stage.factor);
  const auto n = static_cast<std::ptrdiff_t>(stage.dimension);
  text.numbers("low", {stage.low.begin(), stage.low.begin() + n})
      .numbers("high", {stage.high.begin(), stage.high.begin() + n});
  write_time(text, stage, end_of(stage, fastest, dice.whole(60, stage.dimension == 1 ? 400 : 160)));
  write_gas(text, dice, stage);
  write_sides(text, dice, stage, flow, repeat);
  write_flow(text, stage, flow);
  write_contact(text, dice);
  write_output(text, dice);
  return text;
}

std::vector<Shape> draw_shapes(Dice& dice, const Stage& stage, int count, double largest) {
  std::vector<Shape> shapes;
  for (int k = 0; k < count; ++k) shapes.push_back(draw_shape(dice, stage, largest, 0.02));
  return shapes;
}

}  // namespace

Scene line_bodies(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, 1);
  const Flow flow = draw_flow(dice, stage, 1);
  const std::string scheme = draw_body_scheme(dice);
  const std::vector<Slab> slabs = draw_slabs(dice, stage);
  const bool half_spaces = std::any_of(slabs.begin(), slabs.end(), [](const Slab& slab) { return !slab.side.empty(); });
  CaseText text = begin_bodies(dice, title, scheme, stage, flow, flow.fastest, !half_spaces);
  for (const Slab& slab : slabs) {
    text.entry("bodies").word("shape", slab.side.empty() ? "slab" : "half_space");
    if (slab.side.empty())
      text.number("width", slab.width);
    else
      text.word("side", slab.side);
    text.number("position", slab.position);
    write_line_motion(text, dice, stage, slab, scheme == "traditional");
  }
  return {flow.kind, scheme, scheme == "rigid" && !half_spaces, text.text()};  // a half space may leave the domain
}

void write_plane_body(CaseText& text, Dice& dice, const Stage& stage, const Shape& shape, const Place& place,
                      bool massive) {
  text.entry("bodies");
  write_shape(text, shape);
  text.numbers("position", {place.position[0], place.position[1]});
  if (place.angle != 0) text.number("angle", place.angle);
  const int choice = dice.whole(0, 19);
  if (choice == 0) {
    text.words("fixed", {"x", "y", "angle"});
    return;
  }
  if (choice == 1) {
    const double speed = stage.sound * dice.decades(-1, 0.3);
    text.word("motion.x", draw_motion(dice, 2 * stage.spacing(), speed));
    text.word("motion.angle", draw_motion(dice, 90, 90 * speed / shape.radius));
    text.words("fixed", {"y"});
    return;
  }
  const double weight = draw_weight(dice, massive);
  if (dice.chance(0.7)) {
    text.number("density", Dice::rounded(weight * stage.density));
  } else {
    const double mass = weight * stage.density * shape.area;
    text.number("mass", Dice::rounded(mass));
    text.number("inertia", Dice::rounded(mass * shape.radius * shape.radius * dice.between(0.1, 0.5)));
  }
  if (choice == 2) {
    text.words("fixed", {dice.word({"x", "y", "angle"})});
    return;
  }
  const double fast = stage.gentle ? 0.3 : 1.5;
  if (dice.chance(0.3))
    text.numbers("velocity", {Dice::rounded(stage.sound * dice.between(-fast, fast)),
                              Dice::rounded(stage.sound * dice.between(-fast, fast))});
  if (dice.chance(0.3))
    text.number("angular_velocity", Dice::rounded(stage.sound / shape.radius * dice.between(-fast, fast)));
}

Scene plane_bodies(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, 2);
  const Flow flow = draw_flow(dice, stage, 1);
  const std::string scheme = draw_body_scheme(dice);
  CaseText text = begin_bodies(dice, title, scheme, stage, flow, flow.fastest + 0.5 * stage.sound);
  std::vector<Shape> shapes = draw_shapes(dice, stage, dice.whole(1, 4), 0.35);
  const std::vector<Place> places = place_apart(dice, stage, shapes, 3.2 * stage.spacing());
  for (std::size_t k = 0; k < shapes.size(); ++k)
    write_plane_body(text, dice, stage, shapes[k], places[k], scheme == "traditional");
  return {flow.kind, scheme, scheme == "rigid", text.text()};
}

Scene close_bodies(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, 2);
  const Flow flow = draw_flow(dice, stage, 1);
  const std::string scheme = draw_body_scheme(dice);
  CaseText text = begin_bodies(dice, title, scheme, stage, flow, flow.fastest + 0.5 * stage.sound);
  std::vector<Shape> shapes = draw_shapes(dice, stage, dice.whole(2, 4), 0.3);
  for (Shape& shape : shapes)
    while (shape.shape == "polygon") shape = draw_shape(dice, stage, 0.3, 0.02);
  const std::vector<Place> places = place_close(dice, stage, shapes);
  for (std::size_t k = 0; k < shapes.size(); ++k)
    write_plane_body(text, dice, stage, shapes[k], places[k], scheme == "traditional");
  return {flow.kind, scheme, scheme == "rigid", text.text()};
}

}  // namespace mortise::random_scenes
