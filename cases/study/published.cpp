#include "mortise/cases/study/published.hpp"

#include <algorithm>
#include <cstdio>

#include "mortise/cases/study/comparison_parts.hpp"
#include "mortise/cases/study/scheme_variant.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/registry.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

std::vector<Comparison> chosen(const std::string& only) {
  const std::vector<Comparison> all = comparisons();
  if (only.empty()) return all;
  std::vector<std::string> names;
  for (const Comparison& comparison : all) names.push_back(comparison.name);
  std::vector<Comparison> some;
  for (const std::string& name : split_list(only, "--only")) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const std::string guess = nearest(name, names);
      throw InputError("--only " + name + ": there is no such comparison" +
                       (guess.empty() ? "" : ", did you mean \"" + guess + "\"?") + " (known: " + joined(names) + ")");
    }
    some.push_back(all[static_cast<std::size_t>(found - names.begin())]);
  }
  return some;
}

}  // namespace

std::vector<Comparison> comparisons() {
  return {published::elastic_piston(), published::superseismic_shock(), published::cylinder_in_solid(),
          published::rigid_piston(),   published::massless_ellipse(),   published::solid_modes()};
}

int study_published(PublishedOptions options) {
  if (!options.overrides.empty()) throw InputError("--set: published numbers are those of the cases as they are");
  if (options.output.empty()) options.output = "output/published";
  const std::vector<Comparison> all = chosen(options.only);
  std::vector<Member> members;
  for (const Comparison& comparison : all)
    members.insert(members.end(), comparison.members.begin(), comparison.members.end());
  const std::vector<MemberResult> results = run_members(members, options);
  std::string text, values;
  std::size_t first = 0;
  for (const Comparison& comparison : all) {
    for (const Table& table : comparison.tables({results.data() + first, comparison.members.size()})) {
      text += (text.empty() ? "" : "\n") + markdown(table);
      values += "# " + table.title + "\n" + csv(table);
    }
    first += comparison.members.size();
  }
  write_file(options.output + "/study.md", text);
  write_file(options.output + "/study.csv", values);
  std::printf("\n%s\ntables    %s/study.md, study.csv\n", text.c_str(), options.output.c_str());
  return 0;
}

}  // namespace mortise
