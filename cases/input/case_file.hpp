// Reading case files.
#pragma once

#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"

namespace mortise {

/// Reads, completes and checks a case. `case_name_or_path`: the name of a folder below `cases_root` that holds a
/// case.toml, or the path of a TOML file, or of a folder with a case.toml. `overrides`: "key=value" each, applied in
/// order; what one of them chooses makes void what the file chose instead (density: mass and inertia; shape and
/// initial.kind: the keys of the others). Throws InputError: one sentence with place (file:line:column or --set
/// key=value), key, value, what is allowed, nearest name.
CaseDescription read_case(const std::string& case_name_or_path, const std::vector<std::string>& overrides,
                          const std::string& cases_root);

/// Names of the cases below `cases_root`, sorted.
std::vector<std::string> case_names(const std::string& cases_root);

/// All keys of a case file with type, range, default and meaning, as a text for people.
std::string describe_keys();

}  // namespace mortise
