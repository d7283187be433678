// `mortise study convergence`: errors of one case over a sequence of resolutions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mortise/cases/study/member.hpp"
#include "mortise/cases/study/study_files.hpp"

namespace mortise {

struct ConvergenceOptions : StudyOptions {
  std::string vary = "grid.factor";  // key, doubled from level to level; or key=v1,v2,…
  int levels = 4;
  std::string against;  // exact, self; empty: exact where the case has an exact solution
};

/// The order p of e = C h^p that fits best (least squares of logarithms); nothing with fewer than two positive errors.
std::optional<double> fitted_order(const std::vector<double>& spacing, const std::vector<double>& error);

/// Errors of one quantity over the levels; of self-convergence the differences of successive levels, one fewer.
struct ErrorSequence {
  std::string quantity;
  std::vector<ErrorNorms> errors;
};

/// Values of "key" or "key=v1,v2,…": the key, and the list or, without one, `levels` values from the case's own on,
/// each twice the one before. Throws InputError.
struct Variation {
  std::string key;
  std::vector<double> values;
  bool refines_grid() const { return key == "grid.factor"; }
};
Variation variation(const std::string& text, int levels, const CaseDescription& description);

/// For people: "fluid.velocity_x" → "fluid u".
std::string quantity_heading(const std::string& quantity);

/// Runs the study; the exit status of the program. Throws InputError before anything runs.
int study_convergence(ConvergenceOptions options);

}  // namespace mortise
