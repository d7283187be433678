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

/// The first argument that nothing takes, an option before others unless a command must come first; empty: none.
std::string first_unused(const CLI::App& app, bool command_first) {
  const std::vector<std::string> unused = app.remaining(true);
  if (command_first && !unused.empty()) return unused.front();
  const auto option =
      std::find_if(unused.begin(), unused.end(), [](const std::string& word) { return word.rfind('-', 0) == 0; });
  if (option != unused.end()) return *option;
  return unused.empty() ? "" : unused.front();
}

}  // namespace

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string words;  // of the commands that were recognised
  for (auto chosen = const_cast<CLI::App&>(app).get_subcommands(); !chosen.empty(); chosen = chosen.front()->get_subcommands()) {
    command = chosen.front();
    words += (words.empty() ? "" : " ") + command->get_name();
  }
  const bool incomplete = !command_names(*command).empty();  // a command must follow
  const std::string unused = first_unused(app, incomplete);
  const std::string place = words.empty() ? "" : words + ": ";
  const std::string help = " (see mortise " + words + (words.empty() ? "--help)" : " --help)");
  if (!unused.empty() && unused.front() == '-')
    return place + unknown("option", unused.substr(0, unused.find('=')), option_names(*command));
  if (!unused.empty() && incomplete) return place + unknown("command", unused, command_names(*command));
  if (incomplete) return place + "a command is missing: " + joined(command_names(*command)) + help;
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

CLI::Validator count_from(int least, int most) {
  const std::string range = std::to_string(least) + " to " + std::to_string(most);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        int number = 0;
        if (read(text, number) && number >= least && number <= most) return "";
        return "must be an integer from " + range + ", not \"" + text + "\"";
      },
      range);
}

CLI::Validator count_up_to(int most) { return count_from(0, most); }

}  // namespace mortise
