#include "mortise/cases/study/stress_scenes.hpp"

#include <utility>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise {
namespace {

struct Kind {
  const char* name;
  stress::Scene (*make)(Dice&, const std::string& title);
  int weight;  // how often it is drawn
};

constexpr Kind kinds[] = {{"gas alone", stress::gas_alone, 1},
                          {"rigid bodies on a line", stress::line_bodies, 4},
                          {"rigid bodies", stress::plane_bodies, 4},
                          {"close rigid bodies", stress::close_bodies, 3},
                          {"elastic bodies", stress::plane_solids, 4},
                          {"elastic and rigid bodies", stress::mixed_plane, 2},
                          {"elastic strip on a line", stress::line_strip, 4},
                          {"elastic strip", stress::plane_strip, 2},
                          {"elastic ring", stress::ring, 2},
                          {"gas in a hole", stress::hole, 1},
                          {"elastic solids alone", stress::solids_alone, 2}};

const Kind& drawn(Dice& dice) {
  int sum = 0;
  for (const Kind& kind : kinds) sum += kind.weight;
  int left = dice.whole(0, sum - 1);
  const Kind* chosen = kinds;
  while (left >= chosen->weight) left -= (chosen++)->weight;
  return *chosen;
}

}  // namespace

const std::vector<std::string>& stress_kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Kind& kind : kinds) all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

StressScene draw_stress_scene(std::uint64_t seed) {
  Dice dice(seed);
  const Kind& kind = drawn(dice);
  stress::Scene scene = kind.make(dice, "Stress " + std::to_string(seed) + ": " + kind.name);
  return {kind.name, std::move(scene.text), scene.robust};
}

std::string stress_scene(std::uint64_t seed) { return draw_stress_scene(seed).text; }

}  // namespace mortise
