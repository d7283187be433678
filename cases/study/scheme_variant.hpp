// Coupling schemes as studies name them: a scheme and how it is run.
#pragma once

#include <string>
#include <vector>

#include "mortise/cases/input/case_description.hpp"

namespace mortise {

/// "traditional", "traditional+lagged", "projection+substeps": a key of schemes and variants behind "+".
struct SchemeVariant {
  std::string name;
  std::vector<std::string> overrides;  // "key=value" each
};

/// Variants: substeps (the faster side takes several steps; without it both sides take the same ones), lagged (the wall
/// velocity of the last step instead of the extrapolated one), linear (acoustic interface problem). Throws InputError
/// for words that do not exist, with the nearest that does, and for a scheme without what the scene has.
SchemeVariant scheme_variant(const std::string& name, const CaseDescription& scene);
std::vector<SchemeVariant> scheme_variants(const std::string& names, const CaseDescription& scene);

/// All that can run the scene: of interfaces projection, projection+substeps, traditional, traditional-subiterated and,
/// if `all`, anti-traditional and the lagged ones, otherwise the reference map where it can; of rigid bodies rigid and traditional.
std::string default_schemes(const CaseDescription& scene, bool all = false);

/// The parts of a list "a,b,c". Throws InputError for an empty part, naming `option`.
std::vector<std::string> split_list(const std::string& text, const std::string& option);

}  // namespace mortise
