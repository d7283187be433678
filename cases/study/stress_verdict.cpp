#include "mortise/cases/study/stress_verdict.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace mortise {
namespace {

/// Where null says that a quantity has no meaning in the scene instead of that a number went bad.
bool may_be_missing(const std::string& path) {
  return path == ".conservation.momentum" || path == ".conservation.energy";
}

/// The first place below `value` where a number belongs and none is; JSON has null for what is not finite.
std::string first_bad_number(const nlohmann::json& value, const std::string& path) {
  if (value.is_null()) return may_be_missing(path) ? "" : path;
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return path;
  if (!value.is_structured()) return "";
  for (const auto& [key, item] : value.items()) {
    const std::string bad = first_bad_number(item, path + "." + key);
    if (!bad.empty()) return bad;
  }
  return "";
}

Judgement lie(const std::string& reason) { return {Verdict::lied, reason}; }

std::string text_at(const nlohmann::json& summary, const char* key) {
  const auto found = summary.find(key);
  return found != summary.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Of a run that ended with status 0.
Judgement judge_finished(const std::string& text) {
  const nlohmann::json summary = nlohmann::json::parse(text, nullptr, false);
  if (!summary.is_object()) return lie(text.empty() ? "there is no summary" : "the summary cannot be read");
  const std::string status = text_at(summary, "status");
  if (status != "finished") return lie("the exit status is 0, but the summary says \"" + status + "\"");
  if (const std::string bad = first_bad_number(summary, ""); !bad.empty())
    return lie("not a finite number: " + bad.substr(1));
  for (const char* key : {"time", "steps", "overlap"})
    if (!summary.contains(key)) return lie(std::string("the summary has no ") + key);
  const nlohmann::json& overlap = summary["overlap"];
  if (!overlap.is_object() || !overlap.contains("orphans") || !overlap["orphans"].is_number_integer())
    return lie("the summary does not count orphans");
  const auto orphans = overlap["orphans"].get<long long>();
  if (orphans != 0) return {Verdict::orphans, std::to_string(orphans) + " cells at the overlap without a donor"};
  return {};
}

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// "nan" or "inf" in the last row of a table.
bool bad_last_row(const std::string& table) {
  std::istringstream lines(table);
  std::string line, last;
  while (std::getline(lines, line))
    if (!line.empty()) last = line;
  std::istringstream row(last);
  for (std::string entry; std::getline(row, entry, ',');) {
    char* end = nullptr;
    const double value = std::strtod(entry.c_str(), &end);
    if (!entry.empty() && *end == '\0' && !std::isfinite(value)) return true;
  }
  return false;
}

}  // namespace

const char* name_of(Verdict verdict) {
  static constexpr const char* names[] = {"passed", "refused", "numerical", "crash", "hang", "lied", "orphans"};
  return names[static_cast<std::size_t>(verdict)];
}

const std::vector<Verdict>& verdicts() {
  static const std::vector<Verdict> all = {Verdict::passed, Verdict::refused, Verdict::numerical, Verdict::crash,
                                           Verdict::hang,   Verdict::lied,    Verdict::orphans};
  return all;
}

bool acceptable(Verdict verdict) {
  return verdict == Verdict::passed || verdict == Verdict::refused || verdict == Verdict::numerical;
}

Judgement judge_run(const RunEnding& ending, const std::string& summary) {
  if (ending.timed_out) return {Verdict::hang, "it did not end in time"};
  if (ending.signal != 0)
    return {Verdict::crash, "ended by signal " + std::to_string(ending.signal) + " (" + strsignal(ending.signal) + ")"};
  if (ending.status == 0) return judge_finished(summary);
  if (ending.status == 2) return {Verdict::refused, "the input was refused"};
  if (ending.status != 3) return {Verdict::crash, "ended with status " + std::to_string(ending.status)};
  const std::string reason = text_at(nlohmann::json::parse(summary, nullptr, false), "reason");
  return {Verdict::numerical, reason.empty() ? "the computation failed at its start" : reason};
}

Judgement judge_run_in(const RunEnding& ending, const std::string& directory) {
  const Judgement judgement = judge_run(ending, file_text(directory + "/summary.json"));
  if (judgement.verdict != Verdict::passed) return judgement;
  for (const char* table : {"bodies.csv", "interface.csv"})
    if (bad_last_row(file_text(directory + "/" + table)))
      return lie(std::string("not a finite number in the last row of ") + table);
  return judgement;
}

}  // namespace mortise
