#include "mortise/cases/study/convergence.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/snapshot_difference.hpp"
#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;

struct Norm {
  const char* key;
  const char* heading;
  double ErrorNorms::*value;
};
constexpr std::array<Norm, 3> table_norms = {
    {{"l1", "L1", &ErrorNorms::l1}, {"l2", "L2", &ErrorNorms::l2}, {"max", "max", &ErrorNorms::max}}};

double number_of(const std::string& text, const std::string& place) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(place + ": \"" + text + "\" is not a number");
  return value;
}

/// What the key is in the case as it stands.
double present_value(const std::string& key, const CaseDescription& description, const std::string& place) {
  if (key == "grid.factor") return description.grid_factor;
  if (key == "time.time_step" && description.time_step > 0) return description.time_step;
  if (key == "solid.scale") return description.solid.scale;
  throw InputError(place + ": a study needs to know the values of this key, for example --vary " + key + "=1,2,4");
}

/// The spacing that errors are plotted over: of the grid, or the inverse of what is doubled.
std::vector<double> spacings(const Variation& vary) {
  std::vector<double> h;
  for (const double value : vary.values) h.push_back(vary.refines_grid() ? 0.1 / value : 1 / value);
  return h;
}

std::vector<Member> members_of(const ConvergenceOptions& options, const Variation& vary, bool keep_fields) {
  std::vector<Member> members;
  for (const double value : vary.values) {
    Member member;
    const std::string setting = override_of(vary.key, value);
    member.name = setting;
    member.case_name = options.case_name;
    member.overrides = options.overrides;
    member.overrides.push_back(setting);
    member.keep_fields = keep_fields;
    member.weight = std::pow(value / vary.values.front(), 3);
    members.push_back(member);
  }
  return members;
}

/// What is known of all levels that finished, quantity by quantity.
std::vector<ErrorSequence> sequences_of(const std::vector<std::map<std::string, ErrorNorms>>& levels) {
  std::vector<ErrorSequence> sequences;
  std::set<std::string> quantities;
  for (const auto& level : levels)
    for (const auto& [quantity, ignored] : level) quantities.insert(quantity);
  for (const std::string& quantity : quantities) {
    ErrorSequence sequence{quantity, {}};
    for (const auto& level : levels) {
      const auto found = level.find(quantity);
      sequence.errors.push_back(found == level.end() ? ErrorNorms{NAN, NAN, NAN} : found->second);
    }
    sequences.push_back(sequence);
  }
  return sequences;
}

std::vector<std::map<std::string, ErrorNorms>> errors_of(const std::vector<MemberResult>& results, bool self) {
  std::vector<std::map<std::string, ErrorNorms>> levels;
  if (!self) {
    for (const MemberResult& result : results) levels.push_back(result.errors);
    return levels;
  }
  for (std::size_t k = 0; k + 1 < results.size(); ++k) {
    const bool both = results[k].finished() && results[k + 1].finished();
    levels.push_back(both ? snapshot_difference(last_fields(results[k]), last_fields(results[k + 1]))
                          : std::map<std::string, ErrorNorms>{});
  }
  return levels;
}

std::vector<double> values_of(const ErrorSequence& sequence, double ErrorNorms::*norm) {
  std::vector<double> values;
  for (const ErrorNorms& errors : sequence.errors) values.push_back(errors.*norm);
  return values;
}

/// Components beside the length of a vector or tensor are for the CSV file.
bool principal(const std::string& quantity) {
  return quantity.rfind("solid.", 0) != 0 || quantity.find('_') == std::string::npos;
}

Table table_of(const std::vector<ErrorSequence>& sequences, const Variation& vary, const Norm& norm, bool self,
               const std::string& name) {
  Table table;
  table.title = name + ": " + norm.heading + (self ? " differences of successive levels" : " errors");
  table.columns = {{"quantity", "", ""}};
  const std::size_t count = vary.values.size() - (self ? 1 : 0);
  for (std::size_t k = 0; k < count; ++k) {
    if (k > 0) table.columns.push_back({"order_" + std::to_string(k), "order", "%.2f"});
    table.columns.push_back({"error_" + std::to_string(k), override_of(vary.key, vary.values[k]), "%.2e"});
  }
  table.columns.push_back({"fitted_order", "fitted", "%.2f"});
  const std::vector<double> h = spacings(vary);
  for (const ErrorSequence& sequence : sequences) {
    const std::vector<double> e = values_of(sequence, norm.value);
    if (!principal(sequence.quantity) || std::all_of(e.begin(), e.end(), [](double error) { return error == 0; }))
      continue;
    std::vector<TableValue> row = {quantity_heading(sequence.quantity)};
    for (std::size_t k = 0; k < count; ++k) {
      if (k > 0) row.push_back(std::log(e[k - 1] / e[k]) / std::log(h[k - 1] / h[k]));
      row.push_back(e[k]);
    }
    const auto order = fitted_order({h.begin(), h.begin() + static_cast<std::ptrdiff_t>(count)}, e);
    row.push_back(order ? TableValue(*order) : TableValue());
    table.rows.push_back(row);
  }
  return table;
}

Table values_table(const std::vector<ErrorSequence>& sequences, const Variation& vary) {
  Table table;
  table.columns = {{vary.key, "", ""}, {"spacing", "", ""}, {"quantity", "", ""},
                   {"l1", "", ""},     {"l2", "", ""},      {"max", "", ""}};
  const std::vector<double> h = spacings(vary);
  for (const ErrorSequence& sequence : sequences)
    for (std::size_t k = 0; k < sequence.errors.size(); ++k)
      table.rows.push_back({vary.values[k], h[k], sequence.quantity, sequence.errors[k].l1, sequence.errors[k].l2,
                            sequence.errors[k].max});
  return table;
}

Json data_of(const std::vector<ErrorSequence>& sequences, const Variation& vary,
             const std::vector<MemberResult>& results, const std::string& name, bool self) {
  const std::vector<double> h = spacings(vary);
  Json data = {{"kind", "convergence"}, {"case", name}, {"against", self ? "self" : "exact"}, {"vary", vary.key}};
  for (std::size_t k = 0; k < results.size(); ++k)
    data["levels"].push_back({{"value", vary.values[k]},
                              {"spacing", h[k]},
                              {"status", results[k].status},
                              {"reason", results[k].reason},
                              {"time", results[k].time},
                              {"steps", results[k].steps},
                              {"seconds", results[k].seconds},
                              {"cell_updates", results[k].cell_updates}});
  data["quantities"] = Json::array();
  for (const ErrorSequence& sequence : sequences) {
    Json entry = {{"name", sequence.quantity},
                  {"heading", quantity_heading(sequence.quantity)},
                  {"principal", principal(sequence.quantity)}};
    for (const Norm& norm : table_norms) {
      const std::vector<double> e = values_of(sequence, norm.value);
      entry[norm.key] = e;
      const auto order = fitted_order({h.begin(), h.begin() + static_cast<std::ptrdiff_t>(e.size())}, e);
      entry[std::string(norm.key) + "_order"] = order ? Json(*order) : Json();
    }
    data["quantities"].push_back(entry);
  }
  return data;
}

}  // namespace

std::optional<double> fitted_order(const std::vector<double>& spacing, const std::vector<double>& error) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (!(error[k] > 0) || !std::isfinite(error[k])) continue;
    const double a = std::log(spacing[k]), b = std::log(error[k]);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 0)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

Variation variation(const std::string& text, int levels, const CaseDescription& description) {
  const std::string place = "--vary " + text;
  const std::size_t equals = text.find('=');
  Variation vary{text.substr(0, equals), {}};
  if (equals == std::string::npos) {
    const double first = present_value(vary.key, description, place);
    for (int k = 0; k < levels; ++k) vary.values.push_back(std::ldexp(first, k));
    return vary;
  }
  for (std::size_t start = equals + 1; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    vary.values.push_back(number_of(text.substr(start, end - start), place));
    start = end + 1;
  }
  return vary;
}

std::string quantity_heading(const std::string& quantity) {
  static const std::map<std::string, std::string> headings = {{"fluid.density", "fluid ρ"},
                                                              {"fluid.velocity_x", "fluid u"},
                                                              {"fluid.velocity_y", "fluid v"},
                                                              {"fluid.pressure", "fluid p"},
                                                              {"fluid.temperature", "fluid T"},
                                                              {"solid.displacement", "solid displacement"},
                                                              {"solid.velocity", "solid velocity"},
                                                              {"solid.stress", "solid stress"},
                                                              {"interface.position", "interface position"},
                                                              {"interface.velocity", "interface velocity"},
                                                              {"interface.pressure", "interface pressure"}};
  const auto found = headings.find(quantity);
  return found == headings.end() ? quantity : found->second;
}

int study_convergence(ConvergenceOptions options) {
  const CaseDescription base = read_case(options.case_name, options.overrides, options.cases_root);
  const bool has_exact = !base.exact.empty() && base.exact != "none";
  if (options.against.empty()) options.against = has_exact ? "exact" : "self";
  const bool self = options.against == "self";
  if (!self && !has_exact)
    throw InputError("--against exact: the case \"" + base.name + "\" has no exact solution; use --against self");
  const Variation vary = variation(options.vary, options.levels, base);
  if (vary.values.size() < (self ? 3u : 2u))
    throw InputError(std::string("--levels: ") +
                     (self ? "self-convergence needs three levels at least" : "an order needs two levels at least"));
  if (options.output.empty()) options.output = "output/convergence_" + base.name;
  const std::vector<Member> members = members_of(options, vary, self);
  check_scene(check_members(members, options.cases_root).front());
  const std::vector<MemberResult> results = run_members(members, options);

  const std::vector<ErrorSequence> sequences = sequences_of(errors_of(results, self));
  StudyFiles files;
  files.data = data_of(sequences, vary, results, base.name, self);
  files.values = values_table(sequences, vary);
  for (const Norm& norm : table_norms) files.tables.push_back(table_of(sequences, vary, norm, self, base.name));
  for (std::size_t k = 0; k < results.size(); ++k)
    if (!results[k].finished()) std::printf("%s: %s\n", members[k].name.c_str(), results[k].reason.c_str());
  write_study(files, options.output, options.cases_root);
  return 0;
}

}  // namespace mortise
