// Theory over the whole plane of impedance ratio and Courant number.
#pragma once

#include <string>
#include <vector>

#include "mortise/cases/study/prediction.hpp"

namespace mortise {

/// Growth per step of one scheme: factor[i * cfl.size() + j] at ratio[i], cfl[j]. Elastic solids: ratio = z_s/z_f;
/// rigid bodies: m/(z Δt), z the sum of the impedances of all sides.
struct StabilityMap {
  std::string scheme;
  std::vector<double> ratio, cfl, factor;
};

/// Around the line of a prediction made at `cfl`: ratios 1e-6 … 1e6 (of bodies 1e-3 … 1e3), Courant numbers in (0, 1].
StabilityMap stability_map(const std::string& scheme, const GrowthPrediction& prediction, double cfl);

/// Largest factor in the map.
double largest_factor(const StabilityMap& map);

}  // namespace mortise
