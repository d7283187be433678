// `mortise study published`: published numbers beside ours.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mortise/cases/study/member.hpp"
#include "mortise/cases/study/table.hpp"

namespace mortise {

struct PublishedOptions : StudyOptions {
  std::string only;  // names of comparisons, "a,b"; empty: all
};

/// One comparison: the runs it needs and the tables made of their results, in the same order.
struct Comparison {
  std::string name;
  std::vector<Member> members;
  std::vector<Table> (*tables)(std::span<const MemberResult> results);
};

/// elastic_piston, superseismic_shock, cylinder_in_solid, rigid_piston, massless_ellipse, solid_modes. "Published" are
/// numbers from papers on these cases, "independent" those of another program run on the same scene; cases/*/README.md
/// say which case is which.
std::vector<Comparison> comparisons();

/// Throws InputError before anything runs.
int study_published(PublishedOptions options);

}  // namespace mortise
