#include "mortise/cases/study/stress.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <sstream>

#include "mortise/cases/study/stress_scenes.hpp"
#include "mortise/cases/study/stress_verdict.hpp"
#include "mortise/cases/study/study_files.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/// How one scene ended.
struct Entry {
  std::uint64_t seed = 0;
  std::string kind, verdict, reason;
  bool robust = false;
  double seconds = 0;
};

/// What has been run so far, a line of JSON a scene.
class Journal {
 public:
  explicit Journal(const std::string& directory) : path_(directory + "/journal.jsonl") {
    std::error_code ignored;
    if (!fs::exists(path_, ignored)) return;
    std::istringstream lines(read_file(path_));
    for (std::string line; std::getline(lines, line);) {
      const Json json = Json::parse(line, nullptr, false);
      if (json.is_discarded()) break;  // cut short
      entries_.push_back({json.at("seed"), json.at("kind"), json.at("verdict"), json.at("reason"), json.at("robust"),
                          json.at("seconds")});
    }
  }
  void add(const Entry& entry) {
    entries_.push_back(entry);
    std::string text;
    for (const Entry& e : entries_)
      text += Json{{"seed", e.seed},     {"kind", e.kind},     {"verdict", e.verdict},
                   {"reason", e.reason}, {"robust", e.robust}, {"seconds", e.seconds}}
                  .dump(-1, ' ', false, Json::error_handler_t::replace) +
              '\n';
    write_file(path_, text);
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::string path_;
  std::vector<Entry> entries_;
};

Verdict verdict_of(const std::string& name) {
  for (const Verdict verdict : verdicts())
    if (name == name_of(verdict)) return verdict;
  return Verdict::crash;
}

/// Scenes of consecutive seeds, run, judged and put away.
class Batch {
 public:
  Batch(const StressOptions& options, std::uint64_t first, std::uint64_t count) : options_(options) {
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
      scenes_.push_back(draw_stress_scene(seed));
      seeds_.push_back(seed);
      write_file(file(seed), scenes_.back().text);
    }
  }

  /// Returns false when the time was over before the last scene was started.
  bool run(double seconds_left, Journal& journal) {
    std::vector<Task> tasks;
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
      Task task;
      task.name = name(seeds_[k]);
      task.arguments = {"run", file(seeds_[k]), "--quiet", "--overwrite", "--output", output(seeds_[k])};
      task.identity = scenes_[k].text;
      task.time_limit = options_.time_limit;
      tasks.push_back(task);
    }
    PoolOptions pool;
    pool.directory = options_.output + "/members";
    pool.jobs = options_.jobs > 0 ? options_.jobs : available_cores();
    pool.quiet = true;
    pool.interleave = true;
    pool.budget = seconds_left;
    const std::vector<TaskOutcome> outcomes = run_tasks(tasks, pool);
    for (std::size_t k = 0; k < seeds_.size(); ++k) {
      if (outcomes[k].status >= 0) journal.add(judged(k, outcomes[k]));
      put_away(k, outcomes[k].status >= 0 && journal.entries().back().verdict == name_of(Verdict::passed));
    }
    return outcomes.back().status >= 0;
  }

 private:
  static std::string name(std::uint64_t seed) { return "seed_" + std::to_string(seed); }
  std::string file(std::uint64_t seed) const { return options_.output + "/scenes/" + name(seed) + ".toml"; }
  std::string output(std::uint64_t seed) const { return options_.output + "/members/" + name(seed); }

  Entry judged(std::size_t k, const TaskOutcome& outcome) const {
    RunEnding ending;
    ending.timed_out = outcome.timed_out;
    ending.signal = outcome.status > 128 ? outcome.status - 128 : 0;
    ending.status = outcome.status;
    const Judgement judgement = judge_run_in(ending, output(seeds_[k]));
    return {seeds_[k],        scenes_[k].kind,   name_of(judgement.verdict),
            judgement.reason, scenes_[k].robust, outcome.seconds};
  }

  /// A scene that failed stays, with what the program said.
  void put_away(std::size_t k, bool passed) const {
    const std::string scene = name(seeds_[k]), log = options_.output + "/members/" + scene + ".log";
    std::error_code ignored;
    if (!passed && fs::exists(log, ignored)) {
      make_folder(options_.output + "/failures");
      write_file(options_.output + "/failures/" + scene + ".toml", scenes_[k].text);
      fs::copy_file(log, options_.output + "/failures/" + scene + ".log", fs::copy_options::overwrite_existing,
                    ignored);
    }
    fs::remove(file(seeds_[k]), ignored);
    fs::remove(log, ignored);
    fs::remove(options_.output + "/members/" + scene + ".json", ignored);
    fs::remove_all(output(seeds_[k]), ignored);
  }

  StressOptions options_;
  std::vector<std::uint64_t> seeds_;
  std::vector<StressScene> scenes_;
};

/// Kinds down, verdicts across.
std::map<std::string, std::map<std::string, std::int64_t>> counts_of(const std::vector<Entry>& entries) {
  std::map<std::string, std::map<std::string, std::int64_t>> counts;
  for (const Entry& entry : entries) ++counts[entry.kind][entry.verdict];
  return counts;
}

Table counts_table(const std::vector<Entry>& entries) {
  Table table;
  table.title =
      "Random scenes of seeds " + std::to_string(entries.front().seed) + " to " + std::to_string(entries.back().seed);
  table.columns = {{"kind", "kind", ""}};
  for (const Verdict verdict : verdicts()) table.columns.push_back({name_of(verdict), name_of(verdict), ""});
  std::vector<TableValue> sums = {std::string("all")};
  sums.resize(1 + verdicts().size(), std::int64_t{0});
  for (const auto& [kind, counts] : counts_of(entries)) {
    std::vector<TableValue> row = {kind};
    for (std::size_t k = 0; k < verdicts().size(); ++k) {
      const auto found = counts.find(name_of(verdicts()[k]));
      row.push_back(found == counts.end() ? std::int64_t{0} : found->second);
      std::get<std::int64_t>(sums[k + 1]) += std::get<std::int64_t>(row.back());
    }
    table.rows.push_back(row);
  }
  table.rows.push_back(sums);
  return table;
}

/// What failed of scenes that must not, and everything unacceptable; numerical failures of fragile schemes are
/// expected.
Table failures_table(const std::vector<Entry>& entries) {
  Table table;
  table.title = "To be looked at: failures/seed_N.toml runs each of them again";
  table.columns = {{"seed", "seed", ""}, {"kind", "kind", ""}, {"verdict", "verdict", ""}, {"reason", "reason", ""}};
  for (const Entry& e : entries)
    if (!acceptable(verdict_of(e.verdict)) || (e.robust && e.verdict == name_of(Verdict::numerical)))
      table.rows.push_back({static_cast<std::int64_t>(e.seed), e.kind, e.verdict, e.reason});
  return table;
}

Table values_table(const std::vector<Entry>& entries) {
  Table table;
  table.columns = {{"seed", "", ""},    {"kind", "", ""},    {"robust", "", ""},
                   {"verdict", "", ""}, {"seconds", "", ""}, {"reason", "", ""}};
  for (const Entry& e : entries)
    table.rows.push_back(
        {static_cast<std::int64_t>(e.seed), e.kind, std::int64_t{e.robust}, e.verdict, e.seconds, e.reason});
  return table;
}

Json data_of(const std::vector<Entry>& entries) {
  Json data = {{"kind", "stress"}, {"first", entries.front().seed}, {"last", entries.back().seed}};
  for (const Verdict verdict : verdicts()) data["verdicts"].push_back(name_of(verdict));
  for (const auto& [kind, counts] : counts_of(entries)) data["kinds"].push_back({{"kind", kind}, {"counts", counts}});
  return data;
}

}  // namespace

int study_stress(StressOptions options) {
  if (!options.overrides.empty()) throw InputError("--set: the scenes of a stress study are drawn, not chosen");
  if (options.output.empty()) options.output = "output/stress_seed_" + std::to_string(options.seed);
  make_folder(options.output + "/scenes");
  Journal journal(options.output);
  const std::uint64_t first = journal.entries().empty() ? options.seed : journal.entries().back().seed + 1;
  const std::uint64_t end = options.scenes > 0 ? options.seed + options.scenes : ~std::uint64_t{0};
  const std::uint64_t batch = 8 * static_cast<std::uint64_t>(options.jobs > 0 ? options.jobs : available_cores());
  if (!options.quiet) std::printf("seeds from %llu on\n", static_cast<unsigned long long>(first));
  const Clock::time_point began = Clock::now();
  bool time_left = true;
  for (std::uint64_t seed = first; seed < end && time_left;) {
    const double left = 60 * options.minutes - std::chrono::duration<double>(Clock::now() - began).count();
    if (left <= 0) break;
    const std::uint64_t count = std::min(batch, end - seed);
    time_left = Batch(options, seed, count).run(left, journal);
    seed += count;
    if (options.quiet) continue;
    const auto& entries = journal.entries();
    const auto bad = std::count_if(entries.begin(), entries.end(),
                                   [](const Entry& e) { return !acceptable(verdict_of(e.verdict)); });
    std::printf("%zu scenes, %td unacceptable  eta %.0f s\n", entries.size(), bad,
                std::max(0.0, 60 * options.minutes - std::chrono::duration<double>(Clock::now() - began).count()));
    std::fflush(stdout);
  }
  const std::vector<Entry>& entries = journal.entries();
  if (entries.empty()) throw InputError("--minutes: not a single scene was run");
  StudyFiles files;
  files.data = data_of(entries);
  files.values = values_table(entries);
  files.tables = {counts_table(entries), failures_table(entries)};
  write_study(files, options.output, options.cases_root);
  const bool good =
      std::all_of(entries.begin(), entries.end(), [](const Entry& e) { return acceptable(verdict_of(e.verdict)); });
  return good ? 0 : 3;
}

}  // namespace mortise
