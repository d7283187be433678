#include "mortise/cases/study/member.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "mortise/cases/driver/run_case.hpp"
#include "mortise/cases/input/case_file.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {
namespace {

double number(const nlohmann::json& value) { return value.is_number() ? value.get<double>() : NAN; }

MemberResult result_in(const std::string& directory) {
  MemberResult result;
  result.directory = directory;
  const nlohmann::json summary = nlohmann::json::parse(read_file(directory + "/summary.json"), nullptr, false);
  if (summary.is_discarded()) throw EnvironmentError("\"" + directory + "/summary.json\" cannot be read");
  result.status = summary.at("status");
  result.reason = summary.at("reason");
  result.time = number(summary.at("time"));
  result.steps = number(summary.at("steps"));
  result.cell_updates = number(summary.at("cell_updates"));
  result.seconds = number(summary.at("wall_seconds")) - summary.at("phases").value("output", 0.0);
  if (summary.contains("errors"))
    for (const auto& [quantity, norms] : summary.at("errors").items())
      result.errors[quantity] = {number(norms.at("l1")), number(norms.at("l2")), number(norms.at("max"))};
  return result;
}

Task task_of(const Member& member, const CaseDescription& description, const std::string& directory) {
  Task task;
  task.name = member.name;
  task.weight = member.weight;
  task.arguments = {"run",      member.case_name, "--quiet",  "--overwrite",
                    "--output", directory,        "--frames", member.keep_fields ? "1" : "0"};
  for (const std::string& setting : member.overrides) task.arguments.insert(task.arguments.end(), {"--set", setting});
  task.arguments.insert(task.arguments.end(), {"--set", "output.checkpoint_interval=0"});
  task.identity = description.text;
  for (const std::string& word : task.arguments) task.identity += "\n" + word;
  return task;
}

}  // namespace

std::vector<CaseDescription> check_members(const std::vector<Member>& members, const std::string& cases_root) {
  std::vector<CaseDescription> descriptions;
  for (const Member& member : members)
    descriptions.push_back(read_case(member.case_name, member.overrides, cases_root));
  return descriptions;
}

void check_scene(const CaseDescription& description) { check_case_runs(description, Communicator()); }

std::vector<MemberResult> run_members(const std::vector<Member>& members, const StudyOptions& options,
                                      bool interleave) {
  const std::vector<CaseDescription> descriptions = check_members(members, options.cases_root);
  const std::string folder = options.output + "/members";
  std::vector<Task> tasks;
  for (std::size_t k = 0; k < members.size(); ++k)
    tasks.push_back(task_of(members[k], descriptions[k], folder + "/" + members[k].name));
  PoolOptions pool;
  pool.directory = folder;
  pool.jobs = options.jobs > 0 ? options.jobs : available_cores();
  pool.quiet = options.quiet;
  pool.interleave = interleave;
  const std::vector<TaskOutcome> outcomes = run_tasks(tasks, pool);
  std::vector<MemberResult> results;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const TaskOutcome& outcome = outcomes[k];
    if (outcome.status == 2) throw InputError(outcome.message);
    if (outcome.status == 4) throw EnvironmentError(outcome.message);
    if (outcome.status == 0 || outcome.status == 3) {
      results.push_back(result_in(folder + "/" + members[k].name));
      continue;
    }
    MemberResult crashed;
    crashed.status = "crashed";
    crashed.reason = "status " + std::to_string(outcome.status) + ": " + outcome.message;
    crashed.directory = folder + "/" + members[k].name;
    results.push_back(crashed);
  }
  return results;
}

Snapshot last_fields(const MemberResult& result) {
  const std::vector<std::string> files = series_files(result.directory);
  if (files.empty()) throw EnvironmentError("\"" + result.directory + "\" holds no fields");
  return read_snapshot(files.back());
}

std::string override_of(const std::string& key, double value) { return key + "=" + shortest(value); }

}  // namespace mortise
