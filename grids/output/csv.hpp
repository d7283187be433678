// Histories as comma-separated values: a header row with names, then one row per event, first column the time.
// Numbers have the fewest digits that read back to the same double; nothing depends on the locale.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace mortise {

/// One entry of a row. Text is quoted when it has to be; line breaks in it become spaces.
using CsvValue = std::variant<double, std::int64_t, std::string>;

/// Owns the open file. All members throw EnvironmentError naming the file.
class CsvWriter {
 public:
  /// Starts a new file (replacing an old one) with a header row.
  CsvWriter(std::string path, std::vector<std::string> columns);

  /// Continues an existing file after a restart: keeps the complete rows whose first column is ≤ time and appends
  /// after them; starts a new file if there is none. Throws EnvironmentError if the file has other columns.
  static CsvWriter truncate_after(const std::string& path, const std::vector<std::string>& columns, double time);

  /// One value per column; the row is in the file when the call returns.
  void row(const std::vector<CsvValue>& values);

 private:
  CsvWriter(std::string path, std::size_t columns, std::ios::openmode mode);

  std::string path_;
  std::size_t columns_;
  std::ofstream file_;
};

}  // namespace mortise
