// What is wrong with a command line, in one sentence with the nearest valid name.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace mortise {

/// The sentence for an error that parsing the arguments of `app` gave.
std::string explain(const CLI::App& app, const CLI::ParseError& error);

/// Checks for options that are numbers: a finite number > 0; an integer from 0, or `least`, to `most`.
CLI::Validator positive_number();
CLI::Validator count_from(int least, int most);
CLI::Validator count_up_to(int most);

}  // namespace mortise
