// Gas: units, the state at t = 0, the sides of the domain.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/input/case_checks.hpp"
#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

/// (ρ, u, v, p) as the case file wants it: without v on a line.
std::vector<double> listed(const Stage& stage, const std::array<double, 4>& state) {
  if (stage.dimension == 1) return {state[0], state[1], state[3]};
  return {state.begin(), state.end()};
}

std::array<double, 4> at_rest(const Stage& stage) { return {stage.density, 0, 0, stage.pressure()}; }

double speed_of_sound(const Stage& stage, const std::array<double, 4>& state) {
  return std::sqrt(stage.gamma * (state[3] + stage.p_inf) / state[0]);
}

/// |u| + c, and what an expansion into vacuum may reach.
double speed_of_escape(const Stage& stage, const std::array<double, 4>& state) {
  const double c = speed_of_sound(stage, state);
  return std::hypot(state[1], state[2]) + c * std::max(1.0, std::min(2 / (stage.gamma - 1), 5.0));
}

/// A front across the domain that runs into it from one side.
void place_front(Dice& dice, const Stage& stage, Flow& flow) {
  if (stage.dimension == 1)
    flow.angle = 0;
  else
    flow.angle = dice.chance(0.5) ? 0 : dice.chance(0.5) ? 90.0 * dice.whole(0, 3) : dice.between(0, 360);
  const double radians = flow.angle * std::numbers::pi / 180, n[] = {std::cos(radians), std::sin(radians)};
  double low = 0, high = 0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(stage.dimension); ++d) {
    low += std::min(n[d] * stage.low[d], n[d] * stage.high[d]);
    high += std::max(n[d] * stage.low[d], n[d] * stage.high[d]);
  }
  flow.position = Dice::rounded(low + (high - low) * dice.between(0.02, dice.chance(0.8) ? 0.2 : 0.8));
}

void draw_shock(Dice& dice, const Stage& stage, double strength, Flow& flow) {
  flow.kind = "shock";
  flow.state = at_rest(stage);
  // [p]/p̃ = 2γ/(γ + 1) (M² − 1)
  flow.mach = std::sqrt(1 + (stage.gamma + 1) / (2 * stage.gamma) * strength);
  if (!(flow.mach > 1)) flow.mach = 1 + 1e-15;
  place_front(dice, stage, flow);
  const double radians = flow.angle * std::numbers::pi / 180;
  const auto behind =
      gas_behind_shock(flow.state, flow.mach, {std::cos(radians), std::sin(radians)}, stage.gamma, stage.p_inf);
  flow.fastest = std::hypot(behind[1], behind[2]) + speed_of_sound(stage, behind);
}

/// Two states, at worst next to a vacuum or torn apart.
void draw_riemann(Dice& dice, const Stage& stage, Flow& flow) {
  flow.kind = "riemann";
  place_front(dice, stage, flow);
  if (dice.chance(0.5)) flow.position = Dice::rounded(0.5 * (stage.low[0] + stage.high[0]));
  flow.left = flow.right = at_rest(stage);
  std::array<double, 4>& thin = dice.chance(0.7) ? flow.right : flow.left;
  const double emptiness = dice.chance(0.5) ? dice.decades(-2, 0) : dice.decades(-8, -2);
  thin[0] = Dice::rounded(thin[0] * (dice.chance(0.5) ? emptiness : dice.decades(-3, 1)));
  thin[3] = Dice::rounded((thin[3] + stage.p_inf) * emptiness) - stage.p_inf;
  if (dice.chance(0.3)) {
    const double apart = stage.sound * dice.between(-3, 3);
    flow.left[1] = Dice::rounded(-apart);
    flow.right[1] = Dice::rounded(apart);
  }
  flow.fastest = std::max(speed_of_escape(stage, flow.left), speed_of_escape(stage, flow.right));
}

/// A round or plane region of other pressure in gas at rest.
void draw_bump(Dice& dice, const Stage& stage, double strength, bool smooth, Flow& flow) {
  flow.kind = "regions";
  flow.state = at_rest(stage);
  const auto across = [&](std::size_t d) { return stage.high[d] - stage.low[d]; };
  std::string r2;
  for (std::size_t d = 0; d < static_cast<std::size_t>(stage.dimension); ++d) {
    const double center = Dice::rounded(stage.low[d] + across(d) * dice.between(0.1, 0.9));
    const double scale = Dice::rounded(across(d) * dice.between(0.08, 0.2));
    r2 += (d == 0 ? "" : " + ") +
          ("((" + std::string(d == 0 ? "x" : "y") + " - (" + digits(center) + "))/" + digits(scale)) + ")^2";
  }
  const std::string size = digits(Dice::rounded(strength * stage.shifted_pressure()));
  flow.bump = digits(stage.pressure()) + " + " + size + (smooth ? "*exp(-(" + r2 + "))" : "*((" + r2 + ") < 1)");
  flow.fastest = stage.sound * std::sqrt(1 + strength) * (strength > 1 ? 3 : 1);
}

void draw_stream(Dice& dice, const Stage& stage, Flow& flow) {
  flow.kind = "uniform";
  flow.state = at_rest(stage);
  if (!stage.gentle && dice.chance(0.5))
    for (std::size_t d = 0; d < static_cast<std::size_t>(stage.dimension); ++d)
      flow.state[1 + d] = Dice::rounded(stage.sound * (d == 0 ? dice.between(-4, 4) : dice.between(-1, 1)));
  flow.fastest = std::hypot(flow.state[1], flow.state[2]) + stage.sound;
}

}  // namespace

Stage draw_stage(Dice& dice, int dimension) {
  Stage stage;
  stage.dimension = dimension;
  if (dice.chance(0.2)) stage.length = std::pow(10.0, dice.whole(-4, 4));
  stage.factor =
      (dimension == 1 ? dice.pick<double>({2, 4, 6, 10, 20}) : dice.pick<double>({2, 3, 4, 4, 5, 6})) / stage.length;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
    stage.high[d] = Dice::rounded(stage.length * dice.between(0.8, 1.2));
    stage.low[d] = -stage.high[d];
  }
  if (dice.chance(0.3)) {
    stage.density = dice.decades(-4, 4);
    stage.sound = dice.decades(-3, 3);
  }
  stage.gamma = dice.pick<double>({1.4, 1.4, 1.4, 1.6666666666666667, 1.1, 1.2, 3});
  if (dice.chance(0.1)) stage.p_inf = Dice::rounded(stage.shifted_pressure() * dice.pick<double>({0.5, 0.99, 0.9999}));
  stage.cfl = dice.pick<double>({0.9, 0.9, 1, 0.5, 0.3});
  stage.gentle = dice.chance(0.4);
  return stage;
}

Flow draw_flow(Dice& dice, const Stage& stage, double weakness) {
  Flow flow;
  const int choice = dice.whole(0, 9);
  if (stage.gentle) {
    const double strength = dice.between(0.01, 0.1) * std::min(1.0, weakness);
    if (choice < 3) draw_shock(dice, stage, strength, flow);
    if (choice >= 3 && choice < 7) draw_bump(dice, stage, strength, true, flow);
    if (choice >= 7) draw_stream(dice, stage, flow);
    return flow;
  }
  if (choice < 5) draw_shock(dice, stage, dice.chance(0.7) ? dice.between(0.1, 10) : dice.decades(1, 3), flow);
  if (choice == 5 || choice == 6) draw_riemann(dice, stage, flow);
  if (choice == 7) draw_bump(dice, stage, dice.decades(-2, 3), dice.chance(0.3), flow);
  if (choice > 7) draw_stream(dice, stage, flow);
  return flow;
}

double end_of(const Stage& stage, double fastest, int steps) {
  return Dice::rounded(steps * stage.cfl * stage.spacing() / (stage.dimension * fastest));
}

void write_head(CaseText& text, const std::string& title, const std::string& scheme, const Stage& stage) {
  text.word("title", title);
  if (!scheme.empty()) text.word("scheme", scheme);
  text.number("dimension", stage.dimension);
}

void write_time(CaseText& text, const Stage& stage, double end) {
  text.table("time").number("end", end).number("cfl", stage.cfl);
}

void write_gas(CaseText& text, Dice& dice, const Stage& stage) {
  text.table("gas").number("gamma", stage.gamma);
  if (stage.p_inf > 0) text.number("p_inf", stage.p_inf);
  text.table("fluid").word("limiter", dice.word({"mc", "mc", "none", "minmod", "van_albada"}));
  text.word("riemann", dice.word({"hllc", "hllc", "exact", "hlle"}));
}

void write_flow(CaseText& text, const Stage& stage, const Flow& flow) {
  text.table("initial").word("kind", flow.kind);
  if (flow.kind == "uniform") text.numbers("state", listed(stage, flow.state));
  if (flow.kind == "shock") text.numbers("ahead", listed(stage, flow.state)).number("mach", flow.mach);
  if (flow.kind == "riemann")
    text.numbers("left", listed(stage, flow.left)).numbers("right", listed(stage, flow.right));
  if (flow.kind == "shock" || flow.kind == "riemann") text.number("position", flow.position);
  if (flow.angle != 0) text.number("angle", flow.angle);
  if (flow.kind != "regions") return;
  text.entry("initial.regions").number("density", stage.density).word("pressure", flow.bump);
  text.numbers("velocity", std::vector<double>(static_cast<std::size_t>(stage.dimension), 0.0));
}

void write_sides(CaseText& text, Dice& dice, const Stage& stage, const Flow& flow, bool repeat) {
  text.table("boundaries");
  const bool stream = flow.kind == "shock" || flow.kind == "uniform";
  for (int d = 0; d < stage.dimension; ++d) {
    const std::string low = d == 0 ? "left" : "bottom", high = d == 0 ? "right" : "top";
    const bool along_shock = flow.kind == "shock" && d == 0;
    if (!along_shock && dice.chance(0.15) && repeat) {
      text.word(low, "periodic").word(high, "periodic");
      continue;
    }
    text.word(low, dice.word(stream && d == 0 ? std::vector<std::string>{"inflow", "inflow", "outflow", "wall"}
                                              : std::vector<std::string>{"outflow", "wall", "wall"}));
    text.word(high, dice.word({"outflow", "outflow", "wall"}));
  }
}

void write_output(CaseText& text, Dice& dice) {
  text.table("output");
  const bool frames = dice.chance(0.05);
  text.number("frames", frames ? 2 : 0);
  if (frames) text.number("picture_width", 200);
}

Scene gas_alone(Dice& dice, const std::string& title) {
  const Stage stage = draw_stage(dice, dice.whole(1, 2));
  const Flow flow = draw_flow(dice, stage, 1);
  CaseText text;
  write_head(text, title + ", " + flow.kind, "", stage);
  text.table("grid").number("factor", stage.factor);
  const auto n = static_cast<std::ptrdiff_t>(stage.dimension);
  text.numbers("low", {stage.low.begin(), stage.low.begin() + n})
      .numbers("high", {stage.high.begin(), stage.high.begin() + n});
  write_time(text, stage, end_of(stage, flow.fastest, dice.whole(40, 200)));
  write_gas(text, dice, stage);
  write_sides(text, dice, stage, flow);
  write_flow(text, stage, flow);
  write_output(text, dice);
  return {flow.kind, "none", true, text.text()};
}

}  // namespace mortise::random_scenes
