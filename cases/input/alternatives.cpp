#include "mortise/cases/input/alternatives.hpp"

#include <algorithm>
#include <functional>
#include <span>

#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

using Strings = std::vector<std::string>;

/// The keys that only some words of a choice need or allow.
struct Choice {
  std::string word;
  Strings required, optional;

  bool allows(const std::string& key) const {
    return std::find(required.begin(), required.end(), key) != required.end() ||
           std::find(optional.begin(), optional.end(), key) != optional.end();
  }
};

const std::vector<Choice> shapes = {
    {"circle", {"radius"}, {}},
    {"ellipse", {"semi_axes"}, {}},
    {"stick", {"size", "fillet"}, {}},
    {"rectangle", {"size", "fillet"}, {}},
    {"polygon", {"corners", "fillet"}, {}},
    {"spline", {"points"}, {}},
    {"slab", {"width"}, {}},
    {"half_space", {"side"}, {}},
};
const std::vector<Choice> solid_shapes = {
    {"circle", {"radius"}, {"position", "angle"}},
    {"ellipse", {"semi_axes"}, {"position", "angle"}},
    {"stick", {"size", "fillet"}, {"position", "angle"}},
    {"rectangle", {"size", "fillet"}, {"position", "angle"}},
    {"polygon", {"corners", "fillet"}, {"position", "angle"}},
    {"spline", {"points"}, {"position", "angle"}},
    {"annulus", {"inner_radius", "outer_radius"}, {"position"}},
    {"plate", {"low", "high"}, {"hole", "position"}},
    {"strip", {"thickness"}, {"wall"}},
};
const std::vector<Choice> solid_initial_kinds = {
    {"rest", {}, {}},
    {"exact", {}, {"amplitude", "position", "angle", "wave", "length", "mode"}},
    {"plane_wave", {"amplitude"}, {"position", "angle"}},
    {"formula", {}, {"displacement", "velocity"}},
};
const std::vector<Choice> initial_kinds = {
    {"uniform", {"state"}, {}},
    {"shock", {"ahead"}, {"mach", "behind", "position", "angle"}},
    {"riemann", {"left", "right"}, {"position", "angle"}},
    {"vortex", {}, {"strength", "radius", "center", "velocity"}},
    {"regions", {"regions"}, {}},
    {"exact", {}, {"state"}},
};

/// The choice made in `table` under `selector`; nullptr if there is none or it is not known.
const Choice* chosen(const Node& table, const char* selector, const std::vector<Choice>& choices) {
  const Node* word = table.member(selector);
  for (const Choice& choice : choices)
    if (word && word->text == choice.word) return &choice;
  return nullptr;
}

bool belongs_elsewhere(const std::string& key, const Choice& choice, const std::vector<Choice>& choices) {
  return !choice.allows(key) &&
         std::any_of(choices.begin(), choices.end(), [&](const Choice& c) { return c.allows(key); });
}

bool overridden(const Node* node) {
  return node && (node->overridden || std::any_of(node->items.begin(), node->items.end(),
                                                  [](const Node& item) { return overridden(&item); }));
}

void drop(Node& table, const std::function<bool(const std::string&)>& unwanted) {
  std::erase_if(table.items, [&](const Node& member) { return unwanted(member.name) && !overridden(&member); });
}

void drop_other_choices(Node& table, const char* selector, const std::vector<Choice>& choices) {
  if (!overridden(table.member(selector))) return;
  if (const Choice* choice = chosen(table, selector, choices))
    drop(table, [&](const std::string& key) { return belongs_elsewhere(key, *choice, choices); });
}

/// Of two ways to say one thing, the one set on the command line counts.
void drop_other_ways(Node& table, const Strings& one, const Strings& other) {
  for (const auto& [kept, dropped] : {std::pair{one, other}, std::pair{other, one}}) {
    const auto set = [&](const std::string& key) { return overridden(table.member(key)); };
    if (std::any_of(kept.begin(), kept.end(), set))
      drop(table,
           [&](const std::string& key) { return std::find(dropped.begin(), dropped.end(), key) != dropped.end(); });
  }
}

void drop_forces_along_motion(Node& body) {
  const Node* motion = body.member("motion");
  Node* force = body.member("force");
  if (!motion || !force) return;
  for (const char* axis : {"x", "y", "angle"}) {
    const std::string along = axis == std::string("angle") ? "torque" : axis;
    if (overridden(motion->member(axis))) drop(*force, [&](const std::string& key) { return key == along; });
  }
}

void check_choice(const Node& root, const std::string& path, const char* selector, const std::vector<Choice>& choices) {
  const Node& table = *root.find(path);
  const Choice* choice = chosen(table, selector, choices);
  if (!choice) return;
  for (const Node& member : table.items) {
    if (!belongs_elsewhere(member.name, *choice, choices)) continue;
    Strings own = choice->required;
    own.insert(own.end(), choice->optional.begin(), choice->optional.end());
    throw InputError(member.key_place + ": the key \"" + path + "." + member.name + "\" does not belong to " +
                     selector + " = \"" + choice->word + "\" (which takes " + joined(own) + ")");
  }
  for (const std::string& key : choice->required)
    if (!table.member(key))
      throw InputError(table.place + ": the key \"" + path + "." + key + "\" is missing: " + selector + " = \"" +
                       choice->word + "\" needs " + joined(choice->required));
}

/// The tables of an array; none if it is not there.
std::span<Node> entries(Node& root, const char* array) {
  Node* node = root.member(array);
  return node && node->kind == Node::Kind::array ? std::span<Node>(node->items) : std::span<Node>();
}

void check_solid_choices(const Node& root) {
  const Node* solids = root.member("solids");
  for (std::size_t k = 0; solids && k < solids->items.size(); ++k) {
    const std::string path = "solids." + std::to_string(k);
    check_choice(root, path, "shape", solid_shapes);
    if (solids->items[k].member("initial")) check_choice(root, path + ".initial", "kind", solid_initial_kinds);
  }
}

}  // namespace

void drop_superseded(Node& root) {
  if (Node* initial = root.member("initial")) {
    drop_other_choices(*initial, "kind", initial_kinds);
    drop_other_ways(*initial, {"mach"}, {"behind"});
  }
  for (Node& solid : entries(root, "solids")) {
    drop_other_choices(solid, "shape", solid_shapes);
    if (Node* initial = solid.member("initial")) drop_other_choices(*initial, "kind", solid_initial_kinds);
  }
  for (Node& body : entries(root, "bodies")) {
    drop_other_choices(body, "shape", shapes);
    drop_other_ways(body, {"density"}, {"mass", "inertia"});
    drop_forces_along_motion(body);
  }
}

void check_alternatives(const Node& root) {
  if (const Node* initial = root.member("initial")) {
    check_choice(root, "initial", "kind", initial_kinds);
    const Node *mach = initial->member("mach"), *behind = initial->member("behind");
    if (mach && behind)
      reject(root, "initial.behind", "initial.mach and initial.behind are both given: one of them says it all");
    if (initial->member("ahead") && !mach && !behind)
      reject(root, "initial",
             "the key \"initial.mach\" is missing: the Mach number of the shock, > 1 (or initial.behind)");
  }
  check_solid_choices(root);
  const Node* bodies = root.member("bodies");
  for (std::size_t k = 0; bodies && k < bodies->items.size(); ++k) {
    const std::string path = "bodies." + std::to_string(k);
    check_choice(root, path, "shape", shapes);
    for (const char* key : {"mass", "inertia"})
      if (bodies->items[k].member("density") && bodies->items[k].member(key))
        reject(root, path + "." + key,
               path + ".density and " + path + "." + key + " are both given: give one or the other");
  }
}

}  // namespace mortise
