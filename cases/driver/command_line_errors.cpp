#include "mortise/cases/driver/command_line_errors.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

template <class Number>
bool read(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

std::string unknown(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
  const std::string guess = nearest(word, known);
  return "unknown " + what + " \"" + word + "\"" + (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") +
         " (known: " + joined(known) + ")";
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The first argument that nothing takes, an option before others; empty: none.
std::string first_unused(const CLI::App& app) {
  const std::vector<std::string> unused = app.remaining(true);
  const auto option =
      std::find_if(unused.begin(), unused.end(), [](const std::string& word) { return word.rfind('-', 0) == 0; });
  if (option != unused.end()) return *option;
  return unused.empty() ? "" : unused.front();
}

}  // namespace

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = const_cast<CLI::App&>(app).get_subcommands();
  const std::string unused = first_unused(app);
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string place = chosen.empty() ? "" : command.get_name() + ": ";
  const std::string help =
      chosen.empty() ? " (see mortise --help)" : " (see mortise " + command.get_name() + " --help)";
  if (!unused.empty() && unused.front() == '-')
    return place + unknown("option", unused.substr(0, unused.find('=')), option_names(command));
  if (!unused.empty() && chosen.empty()) return unknown("command", unused, command_names(app));
  if (chosen.empty()) return "a command is missing: " + joined(command_names(app)) + help;
  if (!unused.empty()) return place + "unexpected argument \"" + unused + "\"" + help;
  return place + error.what() + help;
}

CLI::Validator positive_number() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        double number = 0;
        if (read(text, number) && number > 0 && std::isfinite(number)) return "";
        return "must be a number > 0, not \"" + text + "\"";
      },
      "> 0");
}

CLI::Validator count_up_to(int most) {
  return CLI::Validator(
      [most](const std::string& text) -> std::string {
        int number = 0;
        if (read(text, number) && number >= 0 && number <= most) return "";
        return "must be an integer from 0 to " + std::to_string(most) + ", not \"" + text + "\"";
      },
      "0 to " + std::to_string(most));
}

}  // namespace mortise
