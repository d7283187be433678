// A CSV file of reference numbers with one header row; text columns (case names) are kept as text.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace mortise::testing {

using ReferenceRow = std::map<std::string, std::string>;

/// All rows of tests/data/<name>, keyed by column. Throws std::runtime_error if the file is missing or empty.
inline std::vector<ReferenceRow> reference_table(const std::string& name) {
  std::ifstream file(MORTISE_TEST_DATA "/" + name);
  std::string line, field;
  if (!std::getline(file, line)) throw std::runtime_error("no reference data in " + name);
  std::vector<std::string> columns;
  for (std::istringstream header(line); std::getline(header, field, ',');) columns.push_back(field);
  std::vector<ReferenceRow> rows;
  while (std::getline(file, line)) {
    std::istringstream values(line);
    ReferenceRow row;
    for (const std::string& column : columns)
      if (std::getline(values, field, ',')) row[column] = field;
    rows.push_back(row);
  }
  if (rows.empty()) throw std::runtime_error("no reference data in " + name);
  return rows;
}

/// The number in one column.
inline double number(const ReferenceRow& row, const std::string& column) { return std::stod(row.at(column)); }

}  // namespace mortise::testing
