#include "mortise/cases/input/overrides.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

std::vector<std::string> segments_of(const std::string& key, const std::string& place) {
  std::vector<std::string> segments(1);
  for (const char c : key) {
    if (c == '.')
      segments.emplace_back();
    else
      segments.back() += c;
  }
  for (const std::string& segment : segments)
    if (segment.empty()) throw InputError(place + ": the key \"" + key + "\" has an empty part");
  return segments;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

bool is_index(const std::string& segment) {
  return std::all_of(segment.begin(), segment.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Node& array_entry(Node& array, const std::string& segment, const std::string& path, const std::string& place) {
  const std::size_t count = array.items.size();
  std::size_t index = count;
  if (is_index(segment)) std::from_chars(segment.data(), segment.data() + segment.size(), index);
  if (index >= count)
    throw InputError(place + ": there is no entry " + segment + " in " + path + ", whose entries are " +
                     (count == 0 ? "none" : "0 to " + std::to_string(count - 1)));
  return array.items[index];
}

/// One step down the dotted path, making tables where there is nothing.
Node& step_down(Node& here, const std::string& segment, const std::string& path, const std::string& place) {
  if (here.kind == Node::Kind::array) return array_entry(here, segment, path, place);
  if (here.kind != Node::Kind::table)
    throw InputError(place + ": " + path + " is " + here.shown() + " and has no key \"" + segment + "\"");
  if (Node* member = here.member(segment)) return *member;
  Node made;
  made.name = segment;
  made.place = made.key_place = place;
  made.overridden = true;
  here.items.push_back(std::move(made));
  return here.items.back();
}

}  // namespace

void apply_override(Node& root, const std::string& argument) {
  const std::string place = "--set " + argument;
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(place + ": expected key=value, for example time.end=0.5");
  Node* here = &root;
  std::string path;
  for (const std::string& segment : segments_of(trimmed(argument.substr(0, equals)), place)) {
    if (is_index(segment) && here->kind == Node::Kind::table)
      throw InputError(place + ": there is no array \"" + path + "\" in the case file to take entry " + segment +
                       " of");
    here = &step_down(*here, segment, path, place);
    path += (path.empty() ? "" : ".") + segment;
  }
  const std::string name = here->name;
  *here = parse_override_value(trimmed(argument.substr(equals + 1)), place);
  here->name = name;
}

}  // namespace mortise
