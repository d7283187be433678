// Numbers from the files of a run that has ended.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace mortise {

/// A history: columns of numbers by name; of bodies.csv and the like only the rows of `item` (its second column).
/// Throws EnvironmentError when the file cannot be read or has no such rows.
std::map<std::string, std::vector<double>> read_history(const std::string& path, const std::string& item);

/// The column at time t, linear between rows; the last value after the end.
double history_at(const std::map<std::string, std::vector<double>>& history, const std::string& column, double t);

/// The angular frequency ω near `guess` (± 10 %) for which a cos ωt + b sin ωt fits the values best.
double fitted_frequency(const std::vector<double>& times, const std::vector<double>& values, double guess);

}  // namespace mortise
