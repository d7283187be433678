#include "mortise/cases/input/node.hpp"

#include <toml++/toml.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

std::string place_of(const toml::source_region& source, const std::string& path, const std::string& parent) {
  if (!source.begin) return parent;
  return path + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
}

Node converted(const toml::node& value, const std::string& path, const std::string& parent_place) {
  Node node;
  node.place = node.key_place = place_of(value.source(), path, parent_place);
  if (const auto* table = value.as_table()) {
    node.kind = Node::Kind::table;
    for (const auto& [key, member] : *table) {
      node.items.push_back(converted(member, path, node.place));
      node.items.back().name = std::string(key.str());
      node.items.back().key_place = place_of(key.source(), path, node.place);
    }
  } else if (const auto* array = value.as_array()) {
    node.kind = Node::Kind::array;
    for (const auto& item : *array) node.items.push_back(converted(item, path, node.place));
  } else if (const auto* text = value.as_string()) {
    node.kind = Node::Kind::text;
    node.text = text->get();
  } else if (const auto* integer = value.as_integer()) {
    node.kind = Node::Kind::integer;
    node.integer = integer->get();
    node.number = static_cast<double>(node.integer);
  } else if (const auto* number = value.as_floating_point()) {
    node.kind = Node::Kind::number;
    node.number = number->get();
  } else if (const auto* boolean = value.as_boolean()) {
    node.kind = Node::Kind::boolean;
    node.boolean = boolean->get();
  } else {
    node.kind = Node::Kind::date;
    std::ostringstream text_of_date;
    value.visit([&](const auto& any) {
      if constexpr (toml::is_chronological<decltype(any)>) text_of_date << any.get();
    });
    node.text = text_of_date.str();
  }
  return node;
}

void mark_overridden(Node& node, const std::string& place) {
  node.overridden = true;
  node.place = node.key_place = place;
  for (Node& item : node.items) mark_overridden(item, place);
}

}  // namespace

const Node* Node::member(std::string_view key) const {
  if (kind != Kind::table) return nullptr;
  for (const Node& item : items)
    if (item.name == key) return &item;
  return nullptr;
}

Node* Node::member(std::string_view key) { return const_cast<Node*>(std::as_const(*this).member(key)); }

const Node* Node::find(std::string_view path) const {
  const Node* here = this;
  while (here && !path.empty()) {
    const std::size_t dot = path.find('.');
    const std::string_view segment = path.substr(0, dot);
    path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
    if (here->kind == Kind::array) {
      std::size_t index = here->items.size();
      std::from_chars(segment.data(), segment.data() + segment.size(), index);
      here = index < here->items.size() ? &here->items[index] : nullptr;
    } else {
      here = here->member(segment);
    }
  }
  return here;
}

std::string Node::shown() const {
  switch (kind) {
    case Kind::boolean:
      return boolean ? "true" : "false";
    case Kind::integer:
      return std::to_string(integer);
    case Kind::number:
      return shortest(number);
    case Kind::text:
      return "\"" + text + "\"";
    case Kind::date:
      return "the date " + text;
    case Kind::array:
      return "an array of " + std::to_string(items.size());
    case Kind::table:
      return "a table";
  }
  return {};
}

Node parse_toml(const std::string& text, const std::string& path) {
  try {
    Node root = converted(toml::parse(text, path), path, path);
    root.place = root.key_place = path;
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(error.source(), path, path) + ": " + std::string(error.description()));
  }
}

Node parse_override_value(const std::string& text, const std::string& place) {
  Node node;
  node.kind = Node::Kind::text;
  node.text = text;
  try {
    const toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1) node = converted(*parsed.get("value"), place, place);
  } catch (const toml::parse_error&) {  // a bare word: keep it as a string
  }
  mark_overridden(node, place);
  return node;
}

void reject(const Node& root, std::string path, const std::string& sentence) {
  const Node* node = root.find(path);
  while (!node) {
    const std::size_t dot = path.rfind('.');
    path.erase(dot == std::string::npos ? 0 : dot);
    node = root.find(path);
  }
  throw InputError(node->place + ": " + sentence);
}

}  // namespace mortise
