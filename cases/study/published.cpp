#include "mortise/cases/study/published.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "mortise/cases/study/comparison_parts.hpp"
#include "mortise/cases/study/scheme_variant.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/registry.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;

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

Json data_of(const Table& table) {
  Json data = {{"title", table.title}, {"columns", Json::array()}, {"rows", Json::array()}};
  for (const TableColumn& column : table.columns) data["columns"].push_back(column.key);
  for (const auto& row : table.rows) {
    Json values = Json::array();
    for (const TableValue& value : row)
      std::visit(
          [&]<class Value>(const Value& known) {
            if constexpr (std::is_same_v<Value, std::monostate>)
              values.push_back(nullptr);
            else
              values.push_back(known);
          },
          value);
    data["rows"].push_back(values);
  }
  return data;
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
  nlohmann::ordered_json data = {{"kind", "published"}};
  std::size_t first = 0;
  for (const Comparison& comparison : all) {
    for (const Table& table : comparison.tables({results.data() + first, comparison.members.size()})) {
      text += (text.empty() ? "" : "\n") + markdown(table);
      data["tables"].push_back(data_of(table));
      values += "# " + table.title + "\n" + csv(table);
    }
    first += comparison.members.size();
  }
  write_file(options.output + "/study.md", text);
  write_file(options.output + "/study.csv", values);
  write_file(options.output + "/study.json", data.dump(2) + '\n');
  std::printf("\n%s\ntables    %s/study.md, study.csv, study.json\n", text.c_str(), options.output.c_str());
  return 0;
}

}  // namespace mortise
