// Case files for tests: a small valid one, changed line by line, read from a scratch folder.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise::test {

/// Lines are counted from 1: "title" is line 1, "[grid]" 2, "[time]" 6, "[initial]" 9, "[[bodies]]" 13.
inline const std::string plane_case =
    "title = \"a cylinder\"\n"
    "[grid]\n"
    "factor = 4\n"
    "low = [-1, -1]\n"
    "high = [1, 1]\n"
    "[time]\n"
    "end = 0.5\n"
    "cfl = 0.8\n"
    "[initial]\n"
    "kind = \"uniform\"\n"
    "state = [1, 0, 0, 1]\n"
    "\n"
    "[[bodies]]\n"
    "shape = \"circle\"\n"
    "radius = 0.25\n"
    "density = 1.0\n";

inline const std::string line_case =
    "dimension = 1\n"
    "[grid]\n"
    "factor = 4\n"
    "low = -1\n"
    "high = 1\n"
    "[time]\n"
    "end = 0.5\n"
    "[initial]\n"
    "kind = \"uniform\"\n"
    "state = [1, 0, 1]\n"
    "[[bodies]]\n"
    "shape = \"slab\"\n"
    "width = 0.2\n"
    "mass = 1\n";

/// `text` with the only occurrence of `what` replaced.
inline std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// A folder of its own for each test process, removed at the end.
class Scratch {
 public:
  Scratch() : folder_(std::filesystem::temp_directory_path() / ("mortise_input_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

inline CaseDescription read_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Scratch scratch;
  return read_case(scratch.write("scratch.toml", text), overrides, "nowhere");
}

/// The error that reading gives, with the path of the scratch file shortened; "" if there is none.
inline std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_text(text, overrides);
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::size_t at = message.find("scratch.toml");
    return at == std::string::npos ? message : message.substr(at);
  }
  return "";
}

}  // namespace mortise::test
