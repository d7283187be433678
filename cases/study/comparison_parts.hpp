// What the comparisons with published numbers share.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "mortise/cases/study/convergence.hpp"
#include "mortise/cases/study/histories_of.hpp"
#include "mortise/cases/study/published.hpp"

namespace mortise::published {

using Overrides = std::vector<std::string>;
using Results = std::span<const MemberResult>;

inline Member member(const std::string& name, const std::string& case_name, Overrides overrides, double weight = 1,
                     bool keep_fields = false) {
  return {name, case_name, std::move(overrides), keep_fields, weight};
}

inline Overrides operator+(Overrides a, const Overrides& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::string text(double value, const char* format) { return shown(value, format); }

inline double error(const MemberResult& result, const std::string& quantity, double ErrorNorms::*norm) {
  const auto found = result.errors.find(quantity);
  return found == result.errors.end() ? nothing : found->second.*norm;
}

/// A largest or mean error of one quantity.
struct PublishedError {
  const char* quantity;
  double published;
};

// comparisons_elastic.cpp
Comparison elastic_piston();
Comparison superseismic_shock();
Comparison cylinder_in_solid();

// comparisons_single.cpp: rigid bodies, and solids alone
Comparison rigid_piston();
Comparison massless_ellipse();
Comparison solid_modes();

}  // namespace mortise::published
