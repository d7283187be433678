// Tables of a study, as text for people (Markdown), for papers (LaTeX) and for programs (CSV).
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace mortise {

/// Nothing, text, a count or a number.
using TableValue = std::variant<std::monostate, std::string, std::int64_t, double>;
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();  // shown like no value

struct TableColumn {
  std::string key;              // in CSV: "fluid.density_l1"
  std::string heading;          // for people: "ρ L1"; also in LaTeX, with Greek letters and arrows translated
  std::string format = "%.3g";  // printf format of numbers
};

struct Table {
  std::string title;
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableValue>> rows;  // one value per column
};

/// "" for nothing and for numbers that are not finite.
std::string shown(const TableValue& value, const std::string& format);

/// The title in bold, then the table; columns are padded to read as they are.
std::string markdown(const Table& table);

/// A `table` environment with booktabs rules, numbers as a·10ᵇ in math mode.
std::string latex(const Table& table);

/// Full precision, a header row with the keys.
std::string csv(const Table& table);

}  // namespace mortise
