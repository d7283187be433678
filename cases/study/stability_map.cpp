#include "mortise/cases/study/stability_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

constexpr int ratios = 49, courant_numbers = 20;
constexpr int cells = 8;  // of a side: the disturbances that grow sit at the interface

/// The line with another ratio of impedances and another step.
ElasticLine changed(ElasticLine line, double ratio, double step_ratio) {
  line.solid.impedance = ratio * line.gas.impedance;
  line.time_step *= step_ratio;
  for (double& share : line.gas_shares) share *= step_ratio;
  line.solid.cells = std::min(line.solid.cells, cells);
  line.gas.cells = std::min(line.gas.cells, cells);
  return line;
}

RigidLine changed(RigidLine line, double ratio, double step_ratio) {
  line.time_step *= step_ratio;
  double z = 0;
  for (AcousticSide& gas : line.gases) {
    z += gas.impedance;
    gas.cells = std::min(gas.cells, cells);
  }
  line.mass = ratio * z * line.time_step;
  return line;
}

template <class Line>
double factor_of(const Line& line) {
  try {
    return growth_factor(line);
  } catch (const NumericalError&) {  // no answer at all
    return std::numeric_limits<double>::infinity();
  }
}

}  // namespace

StabilityMap stability_map(const std::string& scheme, const GrowthPrediction& prediction, double cfl) {
  StabilityMap map;
  map.scheme = scheme;
  const double decades = std::holds_alternative<ElasticLine>(prediction.line) ? 6 : 3;
  for (int i = 0; i < ratios; ++i) map.ratio.push_back(std::pow(10.0, decades * (2.0 * i / (ratios - 1) - 1)));
  for (int j = 1; j <= courant_numbers; ++j) map.cfl.push_back(static_cast<double>(j) / courant_numbers);
  for (const double ratio : map.ratio)
    for (const double number : map.cfl)
      map.factor.push_back(
          std::visit([&](const auto& line) { return factor_of(changed(line, ratio, number / cfl)); }, prediction.line));
  return map;
}

double largest_factor(const StabilityMap& map) { return *std::max_element(map.factor.begin(), map.factor.end()); }

}  // namespace mortise
