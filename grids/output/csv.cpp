#include "mortise/grids/output/csv.hpp"

#include <charconv>
#include <filesystem>
#include <string_view>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

std::string quoted(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string written(const CsvValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return shortest(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return quoted(std::get<std::string>(value));
}

template <class Items>
std::string line(const Items& items) {
  std::string text;
  for (const auto& item : items) {
    if (&item != &items.front()) text += ',';
    text += written(item);
  }
  return text + '\n';
}

/// The first column of a row as a number, if it is one and not after `time`.
bool kept(std::string_view row, double time) {
  double t = 0;
  const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), t);
  return error == std::errc() && *end == ',' && t <= time;
}

}  // namespace

CsvWriter::CsvWriter(std::string path, std::size_t columns, std::ios::openmode mode)
    : path_(std::move(path)), columns_(columns), file_(path_, mode | std::ios::binary) {
  if (!file_) throw EnvironmentError("cannot write \"" + path_ + "\"");
}

CsvWriter::CsvWriter(std::string path, std::vector<std::string> columns)
    : CsvWriter(std::move(path), columns.size(), std::ios::trunc) {
  row(std::vector<CsvValue>(columns.begin(), columns.end()));
}

CsvWriter CsvWriter::truncate_after(const std::string& path, const std::vector<std::string>& columns, double time) {
  if (!std::filesystem::exists(path)) return CsvWriter(path, columns);
  const std::string old = read_file(path);
  std::string content = line(std::vector<CsvValue>(columns.begin(), columns.end()));
  if (old.compare(0, content.size(), content) != 0)
    throw EnvironmentError("cannot continue \"" + path + "\": its columns are not those of this run");
  for (std::size_t start = content.size(), end = 0; (end = old.find('\n', start)) != std::string::npos;
       start = end + 1) {
    const std::string_view row = std::string_view(old).substr(start, end + 1 - start);
    if (kept(row, time)) content += row;
  }
  write_file(path, content);
  return CsvWriter(path, columns.size(), std::ios::app);
}

void CsvWriter::row(const std::vector<CsvValue>& values) {
  if (values.size() != columns_) throw EnvironmentError("a row of \"" + path_ + "\" has the wrong number of values");
  file_ << line(values) << std::flush;
  if (!file_) throw EnvironmentError("cannot write \"" + path_ + "\": is the disk full?");
}

}  // namespace mortise
