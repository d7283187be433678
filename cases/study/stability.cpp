#include "mortise/cases/study/stability.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mortise/cases/input/case_file.hpp"
#include "mortise/cases/study/convergence.hpp"
#include "mortise/cases/study/growth_member.hpp"
#include "mortise/cases/study/scheme_variant.hpp"
#include "mortise/cases/study/stability_map.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;

/// A scheme at one value of what varies.
struct SchemePoint {
  std::string scheme;
  double value = 0;
  std::vector<std::string> overrides;
  GrowthRecord growth;
};

std::vector<std::string> overrides_of(const StabilityOptions& options, const SchemeVariant& scheme,
                                      const std::string& key, double value) {
  std::vector<std::string> all = options.overrides;
  all.insert(all.end(), scheme.overrides.begin(), scheme.overrides.end());
  all.push_back(override_of(key, value));
  return all;
}

/// Measures all points, side by side.
void measure(std::vector<SchemePoint>& points, const StabilityOptions& options, bool quiet) {
  std::vector<Task> tasks;
  const std::string folder = options.output + "/members";
  std::vector<std::string> files;
  for (const SchemePoint& point : points) {
    Task task;
    task.name = point.scheme + "_" + shown(point.value, "%.10g");
    files.push_back(folder + "/" + task.name + ".growth.json");
    task.arguments = {"study",    "growth",    options.case_name, "--steps", std::to_string(options.steps),
                      "--output", files.back()};
    if (options.along_wall) task.arguments.push_back("--along-wall");
    task.identity = read_case(options.case_name, point.overrides, options.cases_root).text;
    for (const std::string& setting : point.overrides) task.arguments.insert(task.arguments.end(), {"--set", setting});
    for (const std::string& word : task.arguments) task.identity += "\n" + word;
    tasks.push_back(task);
  }
  PoolOptions pool;
  pool.directory = folder;
  pool.jobs = options.jobs > 0 ? options.jobs : available_cores();
  pool.quiet = quiet;
  const std::vector<TaskOutcome> outcomes = run_tasks(tasks, pool);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (outcomes[k].status == 2) throw InputError(outcomes[k].message);
    if (outcomes[k].status != 0 && outcomes[k].status != 3)
      throw EnvironmentError(tasks[k].name + " ended with status " + std::to_string(outcomes[k].status) + ": " +
                             outcomes[k].message);
    points[k].growth = read_growth(files[k]);
  }
}

bool grows(const GrowthRecord& growth) { return growth.status == "unstable" || growth.factor > growing; }

/// For people: finished, or when it failed.
std::string ending(const GrowthRecord& growth) {
  if (growth.status == "unstable") return "unstable at t = " + shown(growth.time, "%.3g");
  return grows(growth) ? "grows" : "stable";
}

/// What growth depends on.
std::string ratio_of(const CaseDescription& scene) { return scene.bodies.empty() ? "z_s/z_f" : "m/(z Δt)"; }

Table points_table(const std::vector<SchemePoint>& points, const std::string& key, const CaseDescription& scene) {
  Table table;
  table.title = scene.name + ": growth of small disturbances per step, measured and by theory";
  table.columns = {{"scheme", "scheme", ""},
                   {key, key, "%.4g"},
                   {"ratio", ratio_of(scene), "%.4g"},
                   {"status", "status", ""},
                   {"measured", "measured", "%.5f"},
                   {"predicted", "predicted", "%.5f"},
                   {"deviation", "deviation %", "%.2f"},
                   {"rate", "rate per time", "%.4g"},
                   {"steps", "steps", "%.0f"}};
  for (const SchemePoint& p : points) {
    const GrowthRecord& g = p.growth;
    table.rows.push_back({p.scheme, p.value, g.ratio, ending(g), g.factor, g.predicted,
                          100 * (g.factor / g.predicted - 1), g.rate, g.steps});
  }
  return table;
}

// ---- thresholds

struct Threshold {
  std::string scheme;
  double measured = nothing, predicted = nothing;
  bool grows_below = false;  // of the threshold
};

constexpr double threshold_tolerance = 2e-3;
constexpr int threshold_steps = 1500;

double predicted_threshold(const StabilityOptions& options, const SchemeVariant& scheme, const std::string& key,
                           double low, double high) {
  return bisected(low, high, threshold_tolerance, [&](double value) {
    const auto prediction =
        predict_growth(read_case(options.case_name, overrides_of(options, scheme, key, value), options.cases_root));
    return prediction && prediction->factor > growing;
  });
}

/// Bisects all schemes together, so that their runs are side by side.
std::vector<Threshold> thresholds(const StabilityOptions& options, const std::vector<SchemeVariant>& schemes,
                                  const std::string& key, double low, double high) {
  struct Bracket {
    std::size_t scheme;
    double low, high;
    bool grows_low;
  };
  const auto look = [&](std::size_t scheme, double value) {
    SchemePoint point;
    point.scheme = schemes[scheme].name;
    point.value = value;
    point.overrides = overrides_of(options, schemes[scheme], key, value);
    return point;
  };
  std::vector<Threshold> found(schemes.size());
  std::vector<SchemePoint> ends;
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    found[k].scheme = schemes[k].name;
    found[k].predicted = predicted_threshold(options, schemes[k], key, low, high);
    ends.push_back(look(k, low));
    ends.push_back(look(k, high));
  }
  measure(ends, options, true);
  std::vector<Bracket> open;
  for (std::size_t k = 0; k < schemes.size(); ++k)
    if (const bool below = grows(ends[2 * k].growth); below != grows(ends[2 * k + 1].growth))
      open.push_back({k, low, high, below});
  while (!open.empty() && open.front().high > open.front().low * (1 + threshold_tolerance)) {
    std::vector<SchemePoint> middles;
    for (const Bracket& b : open) middles.push_back(look(b.scheme, std::sqrt(b.low * b.high)));
    measure(middles, options, true);
    for (std::size_t k = 0; k < open.size(); ++k)
      (grows(middles[k].growth) == open[k].grows_low ? open[k].low : open[k].high) = middles[k].value;
  }
  for (const Bracket& b : open) {
    found[b.scheme].measured = std::sqrt(b.low * b.high);
    found[b.scheme].grows_below = b.grows_low;
  }
  return found;
}

Table thresholds_table(const std::vector<Threshold>& all, const std::string& key) {
  Table table;
  table.title = "Where growth begins, in " + key;
  table.columns = {{"scheme", "scheme", ""},
                   {"measured", "measured", "%.4g"},
                   {"predicted", "predicted", "%.4g"},
                   {"deviation", "deviation %", "%.2f"},
                   {"side", "grows", ""}};
  for (const Threshold& t : all)
    table.rows.push_back({t.scheme, t.measured, t.predicted, 100 * (t.measured / t.predicted - 1),
                          std::string(!std::isfinite(t.measured) ? "nowhere, or everywhere, in the range"
                                      : t.grows_below            ? "below"
                                                                 : "above")});
  return table;
}

// ---- maps

std::vector<StabilityMap> maps_of(const StabilityOptions& options, const std::vector<SchemeVariant>& schemes,
                                  const std::string& key, double value) {
  std::vector<StabilityMap> maps;
  for (const SchemeVariant& scheme : schemes) {
    const CaseDescription description =
        read_case(options.case_name, overrides_of(options, scheme, key, value), options.cases_root);
    if (const auto prediction = predict_growth(description))
      maps.push_back(stability_map(scheme.name, *prediction, description.cfl));
  }
  return maps;
}

Table maps_table(const std::vector<StabilityMap>& maps, const CaseDescription& scene) {
  Table table;
  table.title = "Theory over " + ratio_of(scene) + " and Courant numbers in (0, 1]";
  table.columns = {{"scheme", "scheme", ""},
                   {"largest", "largest growth per step − 1", "%.1e"},
                   {"stable", "stable part of the map %", "%.1f"}};
  for (const StabilityMap& map : maps) {
    const auto stable = std::count_if(map.factor.begin(), map.factor.end(), [](double f) { return f <= growing; });
    table.rows.push_back({map.scheme, largest_factor(map) - 1,
                          100 * static_cast<double>(stable) / static_cast<double>(map.factor.size())});
  }
  return table;
}

Json data_of(const std::vector<SchemePoint>& points, const std::vector<Threshold>& all,
             const std::vector<StabilityMap>& maps, const std::string& key, const CaseDescription& scene) {
  Json data = {
      {"kind", "stability"}, {"ratio", ratio_of(scene)}, {"case", scene.name},          {"vary", key},
      {"cfl", scene.cfl},    {"points", Json::array()},  {"thresholds", Json::array()}, {"maps", Json::array()}};
  for (const SchemePoint& p : points) {
    const GrowthRecord& g = p.growth;
    data["points"].push_back({{"scheme", p.scheme},
                              {"value", p.value},
                              {"ratio", g.ratio},
                              {"status", g.status},
                              {"reason", g.reason},
                              {"time", g.time},
                              {"steps", g.steps},
                              {"measured", g.factor},
                              {"rate", g.rate},
                              {"dt", g.dt},
                              {"predicted", g.predicted},
                              {"predicted_rate", g.predicted_rate},
                              {"not_predicted", g.not_predicted}});
  }
  for (const Threshold& t : all)
    data["thresholds"].push_back({{"scheme", t.scheme}, {"measured", t.measured}, {"predicted", t.predicted}});
  for (const StabilityMap& map : maps)
    data["maps"].push_back({{"scheme", map.scheme}, {"ratio", map.ratio}, {"cfl", map.cfl}, {"factor", map.factor}});
  return data;
}

}  // namespace

double bisected(double low, double high, double tolerance, const std::function<bool(double)>& is_growing) {
  const bool below = is_growing(low);
  if (is_growing(high) == below) return nothing;
  while (high > low * (1 + tolerance)) {
    const double middle = std::sqrt(low * high);
    (is_growing(middle) == below ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

int study_stability(StabilityOptions options) {
  const CaseDescription base = read_case(options.case_name, options.overrides, options.cases_root);
  if (options.vary.find('=') == std::string::npos)
    throw InputError("--vary " + options.vary +
                     ": a stability study needs values, for example --vary solid.scale=0.1,1,10");
  const Variation vary = variation(options.vary, 0, base);
  const std::vector<SchemeVariant> schemes =
      scheme_variants(options.schemes.empty() ? default_schemes(base, true) : options.schemes, base);
  const auto [least, most] = std::minmax_element(vary.values.begin(), vary.values.end());
  if (options.threshold && !(*least > 0 && *most > *least))
    throw InputError("--threshold: needs two values > 0 at least, between which to look");
  if (options.output.empty()) options.output = "output/stability_" + base.name;
  std::vector<SchemePoint> points;
  for (const SchemeVariant& scheme : schemes)
    for (const double value : vary.values) {
      SchemePoint point;
      point.scheme = scheme.name;
      point.value = value;
      point.overrides = overrides_of(options, scheme, vary.key, value);
      points.push_back(point);
    }
  for (const SchemePoint& point : points)
    check_scene(read_case(options.case_name, point.overrides, options.cases_root));
  measure(points, options, options.quiet);
  std::vector<Threshold> found;
  if (options.threshold) {
    StabilityOptions longer = options;  // growth is slow where it begins
    longer.steps = std::max(options.steps, threshold_steps);
    found = thresholds(longer, schemes, vary.key, *least, *most);
  }
  const std::vector<StabilityMap> maps = maps_of(options, schemes, vary.key, *most);
  StudyFiles files;
  files.data = data_of(points, found, maps, vary.key, base);
  files.values = points_table(points, vary.key, base);
  files.tables = {files.values};
  if (!found.empty()) files.tables.push_back(thresholds_table(found, vary.key));
  if (!maps.empty()) files.tables.push_back(maps_table(maps, base));
  write_study(files, options.output, options.cases_root);
  return 0;
}

}  // namespace mortise
