#include "mortise/cases/study/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

/// Characters of UTF-8 text.
std::size_t length_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width > length_of(text) ? width - length_of(text) : 0, ' ');
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

std::string latex_text(std::string text) {
  static const std::pair<const char*, const char*> translations[] = {{"\\", "\\textbackslash{}"},
                                                                     {"_", "\\_"},
                                                                     {"%", "\\%"},
                                                                     {"&", "\\&"},
                                                                     {"#", "\\#"},
                                                                     {"ρ", "$\\rho$"},
                                                                     {"σ", "$\\sigma$"},
                                                                     {"λ", "$\\lambda$"},
                                                                     {"μ", "$\\mu$"},
                                                                     {"Δ", "$\\Delta$"},
                                                                     {"γ", "$\\gamma$"},
                                                                     {"ω", "$\\omega$"},
                                                                     {"×", "$\\times$"},
                                                                     {"→", "$\\to$"},
                                                                     {"∞", "$\\infty$"},
                                                                     {"≤", "$\\le$"},
                                                                     {"≥", "$\\ge$"},
                                                                     {"·", "$\\cdot$"},
                                                                     {"ζ", "$\\zeta$"},
                                                                     {"–", "--"},
                                                                     {"²", "$^2$"},
                                                                     {"₁", "$_1$"},
                                                                     {"±", "$\\pm$"},
                                                                     {"⁻", "$^-$"},
                                                                     {"°", "$^\\circ$"}};
  for (const auto& [from, to] : translations) text = replaced(text, from, to);
  return text;
}

/// "1.2e-05" as $1.2\cdot10^{-5}$.
std::string latex_number(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text.empty() ? "" : "$" + text + "$";
  return "$" + text.substr(0, e) + "\\cdot10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}$";
}

/// Quoted when it has to be.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  return '"' + replaced(text, "\"", "\"\"") + '"';
}

std::string csv_value(const TableValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return csv_text(*text);
  if (const auto* count = std::get_if<std::int64_t>(&value)) return std::to_string(*count);
  if (const auto* number = std::get_if<double>(&value)) return shortest(*number);
  return "";
}

}  // namespace

std::string shown(const TableValue& value, const std::string& format) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* count = std::get_if<std::int64_t>(&value)) return std::to_string(*count);
  const auto* number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number)) return "";
  char text[64];
  std::snprintf(text, sizeof text, format.c_str(), *number);
  return text;
}

std::string markdown(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    std::size_t width = std::max<std::size_t>(3, length_of(table.columns[c].heading));
    for (const auto& row : table.rows) width = std::max(width, length_of(shown(row[c], table.columns[c].format)));
    widths.push_back(width);
  }
  std::string text = table.title.empty() ? "" : "**" + table.title + "**\n\n";
  const auto line = [&](const auto& entry) {
    for (std::size_t c = 0; c < widths.size(); ++c) text += "| " + padded(entry(c), widths[c]) + " ";
    text += "|\n";
  };
  line([&](std::size_t c) { return table.columns[c].heading; });
  line([&](std::size_t c) { return std::string(widths[c], '-'); });
  for (const auto& row : table.rows) line([&](std::size_t c) { return shown(row[c], table.columns[c].format); });
  return text;
}

std::string latex(const Table& table) {
  std::string text = "\\begin{table}\n\\centering\n\\caption{" + latex_text(table.title) + "}\n\\begin{tabular}{" +
                     std::string(table.columns.size(), 'r') + "}\n\\toprule\n";
  const auto line = [&](const auto& entry) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) text += (c ? " & " : "") + entry(c);
    text += " \\\\\n";
  };
  line([&](std::size_t c) { return latex_text(table.columns[c].heading); });
  text += "\\midrule\n";
  for (const auto& row : table.rows)
    line([&](std::size_t c) {
      const std::string entry = shown(row[c], table.columns[c].format);
      return std::holds_alternative<std::string>(row[c]) ? latex_text(entry) : latex_number(entry);
    });
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string csv(const Table& table) {
  std::string text;
  for (std::size_t c = 0; c < table.columns.size(); ++c) text += (c ? "," : "") + csv_text(table.columns[c].key);
  text += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) text += (c ? "," : "") + csv_value(row[c]);
    text += '\n';
  }
  return text;
}

}  // namespace mortise
