// `mortise study …` on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace mortise {

/// Adds the command and its kinds of study. The kind that is chosen is kept in `run`, which then takes the folder of
/// the shipped cases, runs it and returns the exit status. `run` must outlive the parsing.
void add_study(CLI::App& app, std::function<int(const std::string& cases_root)>& run);

}  // namespace mortise
