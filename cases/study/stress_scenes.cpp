#include "mortise/cases/study/stress_scenes.hpp"

#include <utility>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise {
namespace {

struct SceneKind {
  const char* name;
  random_scenes::Scene (*make)(Dice&, const std::string& title);
  int weight;  // how often it is drawn
};

constexpr SceneKind scene_kinds[] = {{"gas alone", random_scenes::gas_alone, 1},
                                     {"rigid bodies on a line", random_scenes::line_bodies, 4},
                                     {"rigid bodies", random_scenes::plane_bodies, 4},
                                     {"close rigid bodies", random_scenes::close_bodies, 3},
                                     {"elastic bodies", random_scenes::plane_solids, 4},
                                     {"elastic and rigid bodies", random_scenes::mixed_plane, 2},
                                     {"elastic strip on a line", random_scenes::line_strip, 4},
                                     {"elastic strip", random_scenes::plane_strip, 2},
                                     {"elastic ring", random_scenes::ring, 2},
                                     {"gas in a hole", random_scenes::hole, 1},
                                     {"elastic solids alone", random_scenes::solids_alone, 2}};

const SceneKind& drawn(Dice& dice) {
  int sum = 0;
  for (const SceneKind& kind : scene_kinds) sum += kind.weight;
  int left = dice.whole(0, sum - 1);
  const SceneKind* chosen = scene_kinds;
  while (left >= chosen->weight) left -= (chosen++)->weight;
  return *chosen;
}

}  // namespace

const std::vector<std::string>& stress_kinds() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const SceneKind& kind : scene_kinds) all.emplace_back(kind.name);
    return all;
  }();
  return names;
}

StressScene draw_stress_scene(std::uint64_t seed) {
  Dice dice(seed);
  const SceneKind& kind = drawn(dice);
  random_scenes::Scene scene = kind.make(dice, "Stress " + std::to_string(seed) + ": " + kind.name);
  return {kind.name, std::move(scene.text), scene.robust};
}

std::string stress_scene(std::uint64_t seed) { return draw_stress_scene(seed).text; }

}  // namespace mortise
