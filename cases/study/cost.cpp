#include "mortise/cases/study/cost.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/scheme_variant.hpp"
#include "mortise/cases/study/snapshot_difference.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/core/registry.hpp"

namespace mortise {
namespace {

/// What is run: configurations × resolutions, and the reference if the case has no exact solution.
struct Plan {
  std::vector<CostPoint> points;
  std::vector<Member> members;  // the points `repeats` times over, interleaved; then the reference
  bool self = false;
};

Member member_of(const CostOptions& options, const SchemeVariant& scheme, const std::string& limiter,
                 const std::string& cfl, const std::string& key, double value) {
  Member member;
  member.case_name = options.case_name;
  member.overrides = options.overrides;
  member.overrides.insert(member.overrides.end(), scheme.overrides.begin(), scheme.overrides.end());
  member.name = scheme.name;
  if (!options.limiters.empty()) member.overrides.push_back("fluid.limiter=" + limiter), member.name += "_" + limiter;
  if (!options.cfls.empty()) member.overrides.push_back("time.cfl=" + cfl), member.name += "_cfl" + cfl;
  member.overrides.push_back(override_of(key, value));
  member.name += "_" + override_of(key, value);
  return member;
}

/// Every repeat begins with another point, so that none is always run first, or after the most expensive one.
std::size_t first_of(int repeat, int repeats, std::size_t points) {
  return points * static_cast<std::size_t>(repeat) / static_cast<std::size_t>(repeats);
}

/// Where the result of a point is among those of all members.
std::size_t place_of(std::size_t point, int repeat, int repeats, std::size_t points) {
  return static_cast<std::size_t>(repeat) * points + (point + points - first_of(repeat, repeats, points)) % points;
}

Plan plan_of(const CostOptions& options, const CaseDescription& base, const Variation& vary) {
  Plan plan;
  plan.self = options.against == "self";
  const std::vector<SchemeVariant> schemes =
      scheme_variants(options.schemes.empty() ? default_schemes(base) : options.schemes, base);
  const std::vector<std::string> limiters =
      options.limiters.empty() ? std::vector<std::string>{base.limiter} : split_list(options.limiters, "--limiters");
  const std::vector<std::string> cfls =
      options.cfls.empty() ? std::vector<std::string>{shown(base.cfl, "%g")} : split_list(options.cfls, "--cfls");
  std::vector<Member> once;
  for (const SchemeVariant& scheme : schemes)
    for (const std::string& limiter : limiters)
      for (const std::string& cfl : cfls)
        for (const double value : vary.values) {
          CostPoint point;
          point.scheme = scheme.name, point.limiter = limiter, point.cfl = cfl, point.value = value;
          plan.points.push_back(point);
          Member member = member_of(options, scheme, limiter, cfl, vary.key, value);
          member.weight = std::pow(value / vary.values.front(), 3);
          once.push_back(member);
        }
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (std::size_t k = 0; k < once.size(); ++k) {
      Member member = once[(k + first_of(repeat, options.repeats, once.size())) % once.size()];
      member.name += "_" + std::to_string(repeat + 1);
      member.keep_fields = plan.self;
      plan.members.push_back(member);
    }
  if (plan.self) {
    Member reference =
        member_of(options, schemes.front(), limiters.front(), cfls.front(), vary.key, 2 * vary.values.back());
    reference.name = "reference_" + reference.name;
    reference.keep_fields = true;
    reference.weight = std::pow(2 * vary.values.back() / vary.values.front(), 3);
    plan.members.push_back(reference);
  }
  return plan;
}

/// Errors that count: those of gas and solids, without the components of what is there as a whole.
bool counts(const std::string& quantity, const std::string& chosen) {
  if (!chosen.empty()) return quantity == chosen;
  const bool component = quantity.rfind("solid.", 0) == 0 && quantity.find('_') != std::string::npos;
  return !component && quantity.rfind("interface.", 0) != 0;
}

/// The geometric mean over the quantities of L1 errors, each relative to that of the first point that finished.
double combined(const std::map<std::string, ErrorNorms>& errors, const std::map<std::string, ErrorNorms>& unit,
                const std::string& chosen) {
  double sum = 0;
  int count = 0;
  for (const auto& [quantity, norms] : errors) {
    const auto one = unit.find(quantity);
    if (!counts(quantity, chosen) || one == unit.end() || !(one->second.l1 > 0) || !(norms.l1 > 0)) continue;
    sum += std::log(norms.l1 / one->second.l1);
    ++count;
  }
  return count > 0 ? std::exp(sum / count) : nothing;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Fills in what was measured; returns the quantities the error is made of.
std::set<std::string> measure(Plan& plan, const std::vector<MemberResult>& results, const CostOptions& options) {
  const std::size_t count = plan.points.size();
  if (plan.self && !results.back().finished())
    throw NumericalError("the reference solution of the study did not finish: " + results.back().reason);
  std::vector<std::map<std::string, ErrorNorms>> errors(count);
  const Snapshot reference = plan.self ? last_fields(results.back()) : Snapshot();
  std::map<std::string, ErrorNorms> unit;
  for (std::size_t k = 0; k < count; ++k) {
    if (!results[k].finished()) continue;
    errors[k] = plan.self ? snapshot_difference(last_fields(results[k]), reference) : results[k].errors;
    if (unit.empty()) unit = errors[k];
  }
  std::set<std::string> quantities;
  for (const auto& [quantity, norms] : unit)
    if (counts(quantity, options.quantity)) quantities.insert(quantity);
  if (!unit.empty() && quantities.empty()) {
    std::vector<std::string> known;
    for (const auto& [quantity, norms] : unit) known.push_back(quantity);
    throw InputError("--quantity " + options.quantity + ": the errors of this case are those of " + joined(known));
  }
  for (std::size_t k = 0; k < count; ++k) {
    CostPoint& point = plan.points[k];
    std::vector<double> seconds;
    for (int repeat = 0; repeat < options.repeats; ++repeat)
      seconds.push_back(results[place_of(k, repeat, options.repeats, count)].seconds);
    point.status = results[k].status;
    point.error = results[k].finished() ? combined(errors[k], unit, options.quantity) : nothing;
    point.seconds = median(seconds);
    point.least = *std::min_element(seconds.begin(), seconds.end());
    point.most = *std::max_element(seconds.begin(), seconds.end());
    point.cell_updates = results[k].cell_updates;
  }
  mark_pareto_front(plan.points);
  return quantities;
}

std::string configuration(const CostPoint& point, const CostOptions& options) {
  return point.scheme + (options.limiters.empty() ? "" : ", " + point.limiter) +
         (options.cfls.empty() ? "" : ", CFL " + point.cfl);
}

Table points_table(const Plan& plan, const Variation& vary, const std::string& name) {
  Table table;
  table.title = name + ": run time against error";
  table.columns = {{"scheme", "scheme", ""},
                   {"limiter", "limiter", ""},
                   {"cfl", "CFL", ""},
                   {vary.key, vary.key, "%g"},
                   {"status", "status", ""},
                   {"error", "error", "%.3e"},
                   {"seconds", "seconds", "%.3g"},
                   {"least_seconds", "least", "%.3g"},
                   {"most_seconds", "most", "%.3g"},
                   {"cell_updates", "cell updates", "%.3e"},
                   {"pareto", "Pareto front", ""}};
  for (const CostPoint& p : plan.points)
    table.rows.push_back({p.scheme, p.limiter, p.cfl, p.value, p.status, p.error, p.seconds, p.least, p.most,
                          p.cell_updates, std::string(p.on_front ? "yes" : "")});
  return table;
}

/// Curves of one configuration each, in the order of the points.
std::vector<std::vector<CostPoint>> curves_of(const Plan& plan, const CostOptions& options) {
  std::vector<std::vector<CostPoint>> curves;
  for (const CostPoint& point : plan.points) {
    if (curves.empty() || configuration(curves.back().front(), options) != configuration(point, options))
      curves.emplace_back();
    curves.back().push_back(point);
  }
  return curves;
}

/// Seconds for equal error: errors at which the first configuration's middle resolutions are.
Table equal_error_table(const Plan& plan, const CostOptions& options) {
  Table table;
  table.title = "Seconds for equal error, and relative to the first configuration";
  table.columns = {{"configuration", "configuration", ""}};
  const std::vector<std::vector<CostPoint>> curves = curves_of(plan, options);
  std::vector<double> errors;
  for (std::size_t k = 0; k + 1 < curves.front().size(); ++k) {
    errors.push_back(std::sqrt(curves.front()[k].error * curves.front()[k + 1].error));
    table.columns.push_back({"seconds_" + std::to_string(k), "error " + shown(errors.back(), "%.2g"), "%.3g"});
    table.columns.push_back({"ratio_" + std::to_string(k), "ratio", "%.2f"});
  }
  for (const std::vector<CostPoint>& curve : curves) {
    std::vector<TableValue> row = {configuration(curve.front(), options)};
    for (const double error : errors) {
      const double seconds = seconds_for(curve, error);
      row.push_back(seconds);
      row.push_back(seconds / seconds_for(curves.front(), error));
    }
    table.rows.push_back(row);
  }
  return table;
}

nlohmann::ordered_json data_of(const Plan& plan, const CostOptions& options, const Variation& vary,
                               const std::set<std::string>& quantities, const std::string& name) {
  nlohmann::ordered_json data = {{"kind", "cost"},
                                 {"case", name},
                                 {"against", plan.self ? "self" : "exact"},
                                 {"vary", vary.key},
                                 {"repeats", options.repeats},
                                 {"quantities", quantities}};
  for (const CostPoint& p : plan.points)
    data["points"].push_back({{"configuration", configuration(p, options)},
                              {"scheme", p.scheme},
                              {"limiter", p.limiter},
                              {"cfl", p.cfl},
                              {"value", p.value},
                              {"status", p.status},
                              {"error", p.error},
                              {"seconds", p.seconds},
                              {"least_seconds", p.least},
                              {"most_seconds", p.most},
                              {"cell_updates", p.cell_updates},
                              {"pareto", p.on_front}});
  return data;
}

}  // namespace

void mark_pareto_front(std::vector<CostPoint>& points) {
  for (CostPoint& p : points) {
    p.on_front = p.status == "finished" && std::isfinite(p.error);
    for (const CostPoint& q : points)
      if (q.status == "finished" && q.error <= p.error && q.seconds <= p.seconds &&
          (q.error < p.error || q.seconds < p.seconds))
        p.on_front = false;
  }
}

double seconds_for(std::vector<CostPoint> curve, double error) {
  std::erase_if(curve, [](const CostPoint& p) { return p.status != "finished" || !(p.error > 0) || !(p.seconds > 0); });
  std::sort(curve.begin(), curve.end(), [](const CostPoint& a, const CostPoint& b) { return a.error > b.error; });
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const CostPoint &a = curve[k], &b = curve[k + 1];
    if (!(a.error >= error && error >= b.error && a.error > b.error)) continue;
    const double share = std::log(a.error / error) / std::log(a.error / b.error);
    return a.seconds * std::pow(b.seconds / a.seconds, share);
  }
  return nothing;
}

int study_cost(CostOptions options) {
  const CaseDescription base = read_case(options.case_name, options.overrides, options.cases_root);
  const bool has_exact = !base.exact.empty() && base.exact != "none";
  if (options.against.empty()) options.against = has_exact ? "exact" : "self";
  if (options.against == "exact" && !has_exact)
    throw InputError("--against exact: the case \"" + base.name + "\" has no exact solution; use --against self");
  const Variation vary = variation(options.vary, options.levels, base);
  if (options.output.empty()) options.output = "output/cost_" + base.name;
  if (options.jobs == 0) options.jobs = 1;  // a run beside others is not timed
  Plan plan = plan_of(options, base, vary);
  check_scene(check_members(plan.members, options.cases_root).front());
  const std::vector<MemberResult> results = run_members(plan.members, options, true);
  const std::set<std::string> quantities = measure(plan, results, options);
  StudyFiles files;
  files.data = data_of(plan, options, vary, quantities, base.name);
  files.values = points_table(plan, vary, base.name);
  files.tables = {files.values, equal_error_table(plan, options)};
  write_study(files, options.output, options.cases_root);
  return 0;
}

}  // namespace mortise
