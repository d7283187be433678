#include "mortise/cases/input/unknown_keys.hpp"

#include <algorithm>
#include <string>

#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

using Strings = std::vector<std::string>;

/// The keys that may stand in the table `pattern` ("" or "bodies.N"); empty if it is not a table.
Strings keys_in(const std::string& pattern, const std::vector<KeyEntry>& known) {
  const std::string prefix = pattern.empty() ? "" : pattern + ".";
  Strings keys;
  for (const KeyEntry& entry : known) {
    if (entry.path.rfind(prefix, 0) != 0) continue;
    const std::string key = entry.path.substr(prefix.size(), entry.path.find('.', prefix.size()) - prefix.size());
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  }
  return keys;
}

/// A key of the same name in another table ("fluid.limiter" for "limiter"), or a similar one in this table, or
/// anywhere.
std::string guess(const std::string& key, const Strings& here, const std::vector<KeyEntry>& known) {
  std::string elsewhere;
  Strings leaves;
  for (const KeyEntry& entry : known) {
    leaves.push_back(entry.path.substr(entry.path.rfind('.') + 1));
    if (leaves.back() == key && elsewhere.empty()) elsewhere = entry.path;
  }
  if (!elsewhere.empty()) return elsewhere;
  if (const std::string similar = nearest(key, here); !similar.empty()) return similar;
  const std::string leaf = nearest(key, leaves);
  const auto found = std::find(leaves.begin(), leaves.end(), leaf);
  return found == leaves.end() ? "" : known[static_cast<std::size_t>(found - leaves.begin())].path;
}

void check(const Node& node, const std::string& path, const std::string& pattern, const std::vector<KeyEntry>& known) {
  if (node.kind == Node::Kind::array) {
    for (std::size_t k = 0; k < node.items.size(); ++k)
      check(node.items[k], path + "." + std::to_string(k), pattern + ".N", known);
    return;
  }
  const Strings allowed = keys_in(pattern, known);
  if (node.kind != Node::Kind::table || allowed.empty()) return;
  for (const Node& member : node.items) {
    if (std::find(allowed.begin(), allowed.end(), member.name) == allowed.end()) {
      const std::string similar = guess(member.name, allowed, known);
      throw InputError(member.key_place + ": unknown key \"" + member.name + "\"" +
                       (path.empty() ? "" : " in " + path) +
                       (similar.empty()          ? ""
                        : similar == member.name ? ", which belongs before the first [table]"
                                                 : ", did you mean \"" + similar + "\"?") +
                       " (known: " + joined(allowed) + ")");
    }
    const std::string dot = path.empty() ? "" : ".";
    check(member, path + dot + member.name, pattern + dot + member.name, known);
  }
}

}  // namespace

void reject_unknown_keys(const Node& root, const std::vector<KeyEntry>& known) { check(root, "", "", known); }

}  // namespace mortise
