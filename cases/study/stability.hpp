// `mortise study stability`: which schemes hold a scene, measured and by theory.
#pragma once

#include <functional>
#include <string>

#include "mortise/cases/study/member.hpp"

namespace mortise {

struct StabilityOptions : StudyOptions {
  std::string vary;        // "key=v1,v2,…"
  std::string schemes;     // "a,b,c"; empty: all that can run the scene
  int steps = 400;         // that a disturbance is followed for, at most
  bool threshold = false;  // find where growth begins, between the least and the largest value
  bool along_wall = false;  // disturbances that vary along the wall of a strip, too; theory is that of plane ones
};

/// A disturbance grows when its factor per step exceeds this: conserved quantities keep theirs at 1 up to what a few
/// hundred steps can tell.
inline constexpr double growing = 1 + 3e-4;

/// The value between low and high, both > 0, at which `grows` changes, by bisection of the logarithm to a relative
/// `tolerance`; NaN where it does not change.
double bisected(double low, double high, double tolerance, const std::function<bool(double)>& grows);

/// Throws InputError before anything runs.
int study_stability(StabilityOptions options);

}  // namespace mortise
