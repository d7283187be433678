#include "mortise/cases/study/histories_of.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

double number(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Squared residual of the best a cos ωt + b sin ωt.
double residual(const std::vector<double>& times, const std::vector<double>& values, double omega) {
  Eigen::MatrixX2d A(times.size(), 2);
  const Eigen::Map<const Eigen::VectorXd> b(values.data(), static_cast<Eigen::Index>(values.size()));
  for (std::size_t k = 0; k < times.size(); ++k)
    A.row(static_cast<Eigen::Index>(k)) << std::cos(omega * times[k]), std::sin(omega * times[k]);
  return (A * A.colPivHouseholderQr().solve(b) - b).squaredNorm();
}

}  // namespace

std::map<std::string, std::vector<double>> read_history(const std::string& path, const std::string& item) {
  std::istringstream file(read_file(path));
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = fields_of(line);
  std::map<std::string, std::vector<double>> history;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != columns.size() || fields.size() < 2 || fields[1] != item) continue;
    for (std::size_t c = 0; c < columns.size(); ++c) history[columns[c]].push_back(number(fields[c]));
  }
  if (history.empty()) throw EnvironmentError("\"" + path + "\" holds nothing of \"" + item + "\"");
  return history;
}

double history_at(const std::map<std::string, std::vector<double>>& history, const std::string& column, double t) {
  const std::vector<double>&times = history.at("t"), &values = history.at(column);
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  if (after == times.begin()) return values.front();
  if (after == times.end()) return values.back();
  const auto k = static_cast<std::size_t>(after - times.begin());
  const double share = (t - times[k - 1]) / (times[k] - times[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

double fitted_frequency(const std::vector<double>& times, const std::vector<double>& values, double guess) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = 0.9 * guess, high = 1.1 * guess;
  while (high - low > 1e-12 * guess) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    if (residual(times, values, a) < residual(times, values, b))
      high = b;
    else
      low = a;
  }
  return 0.5 * (low + high);
}

}  // namespace mortise
