// A case file as a tree of values that know where they were written. This is all the rest of mortise sees of TOML.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {

struct Node {
  enum class Kind { boolean, integer, number, text, date, array, table };

  Kind kind = Kind::table;
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0;        // of an integer too
  std::string text;         // of a string or date
  std::string name;         // key in the table that holds this node; empty in arrays and for the root
  std::vector<Node> items;  // entries of an array, members of a table

  std::string place;        // of the value: "case.toml:7:11" (line and column from 1) or "--set key=value"
  std::string key_place;    // of the key; in arrays of the value
  bool overridden = false;  // given by --set

  bool is_number() const { return kind == Kind::integer || kind == Kind::number; }
  /// Member of a table; nullptr if absent or not a table.
  const Node* member(std::string_view key) const;
  Node* member(std::string_view key);
  /// What a dotted path leads to ("bodies.0.density"; "" is this node); nullptr if there is no such thing.
  const Node* find(std::string_view path) const;
  /// The value as a reader of an error message wants to see it: `"none"`, `-1`, `an array of 3`, `a table`.
  std::string shown() const;
};

/// Parses the text of a TOML file; `path` is for messages. Throws InputError with file, line and column.
Node parse_toml(const std::string& text, const std::string& path);

/// Parses the right-hand side of `--set key=value`: a TOML value, or a bare word, which is a string.
Node parse_override_value(const std::string& text, const std::string& place);

/// Throws InputError: the place of what `path` leads to (or of the nearest table around it), then the sentence.
[[noreturn]] void reject(const Node& root, std::string path, const std::string& sentence);


}  // namespace mortise
