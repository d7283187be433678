#include "mortise/cases/input/case_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "mortise/cases/input/alternatives.hpp"
#include "mortise/cases/input/case_checks.hpp"
#include "mortise/cases/input/case_keys.hpp"
#include "mortise/cases/input/overrides.hpp"
#include "mortise/cases/input/unknown_keys.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;

fs::path file_of_case(const std::string& wanted, const std::string& cases_root) {
  const fs::path path(wanted), named = fs::path(cases_root) / path / "case.toml";
  std::error_code ignored;
  const bool is_name = path.extension() != ".toml" && wanted.find('/') == std::string::npos;
  if (is_name && fs::exists(named, ignored)) return named;
  if (fs::is_regular_file(path, ignored)) return path;
  if (fs::is_regular_file(path / "case.toml", ignored)) return path / "case.toml";
  if (!is_name) throw InputError("there is no case file \"" + wanted + "\"");
  const std::vector<std::string> known = case_names(cases_root);
  const std::string guess = nearest(wanted, known);
  throw InputError("there is no case \"" + wanted + "\"" + (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") +
                   " (known: " + joined(known) + ")");
}

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw InputError("the case file \"" + file.string() + "\" cannot be read");
  return text.str();
}

}  // namespace

CaseDescription read_case(const std::string& case_name_or_path, const std::vector<std::string>& overrides,
                          const std::string& cases_root) {
  CaseDescription description;
  const fs::path file = file_of_case(case_name_or_path, cases_root);
  description.path = file.string();
  description.folder = file.parent_path().string();
  const fs::path folder_name = fs::absolute(file).lexically_normal().parent_path().filename();
  description.name = (file.filename() == "case.toml" ? folder_name : file.stem()).string();
  description.text = contents_of(file);

  Node root = parse_toml(description.text, description.path);
  for (const std::string& argument : overrides) {
    apply_override(root, argument);
    description.text += "# --set " + argument + "\n";
  }
  reject_unknown_keys(root, all_keys());
  drop_superseded(root);
  Section section(root, "", description.dimension);
  visit_case(section, description);
  check_alternatives(root);
  complete_case(root, description);
  check_case(root, description);
  return description;
}

std::vector<std::string> case_names(const std::string& cases_root) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(cases_root, ignored))
    if (fs::exists(entry.path() / "case.toml", ignored)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string describe_keys() {
  std::string text;
  for (const KeyEntry& key : all_keys())
    text += key.path + "\n    " + key.meaning + "\n    " + key.allowed +
            (key.initial.empty() ? "" : "; default " + key.initial) + "\n";
  return text;
}

}  // namespace mortise
