// What theory says of the growth that growth.hpp measures: the spectral radius of the linearised coupled step of a case
// on a line (coupler/amplification.hpp), with the impedances, cells and steps of the case.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "mortise/cases/input/case_description.hpp"
#include "mortise/coupler/amplification.hpp"

namespace mortise {

struct GrowthPrediction {
  double factor = 0;  // growth per step of the gas
  // The same for waves along the wall of a strip that are two faces long, whose nodes do not move (`following` = 0).
  // The dissipation along the wall is left out: an upper estimate of these waves. In the plane the larger of the two
  // counts. Rigid bodies: factor.
  double along_wall = 0;
  double rate = 0;                            // per time: log factor/dt
  double dt = 0;                              // of the gas; the mean where the steps of the gas differ
  double ratio = 0;                           // z_s/z_f; of a rigid body m/(z dt), z the sum over its sides with gas
  std::variant<ElasticLine, RigidLine> line;  // what was looked at
};

/// For one elastic strip beside gas at rest, and for one free slab or half space between gases at rest on a line.
/// Nothing for other scenes: `reason`, if given, then says why. A strip in the plane is taken for one on a line: waves
/// along the wall are left out. Limiters are left out as well. At most 64 cells of each side are taken. Throws
/// InputError like build_scene(), NumericalError like amplification_matrix().
std::optional<GrowthPrediction> predict_growth(const CaseDescription& description, std::string* reason = nullptr);

}  // namespace mortise
