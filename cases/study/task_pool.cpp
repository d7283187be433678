#include "mortise/cases/study/task_pool.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "mortise/cases/study/pool_progress.hpp"
#include "mortise/cases/summary/provenance.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

extern char** environ;

namespace mortise {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Which program it is: a build, not a version, so that a mended program does not reuse what a broken one found.
std::string build_identity(const std::string& program) {
  struct stat file {};
  stat(program.c_str(), &file);
  return provenance().version + " " + provenance().git + " " + std::to_string(file.st_size) + " " +
         std::to_string(file.st_mtim.tv_sec);
}

std::string last_line(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return "";
  std::string text = read_file(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

/// Records of what has ended.
class Records {
 public:
  explicit Records(const PoolOptions& options)
      : directory_(options.directory), build_(build_identity(options.program)) {
    make_folder(directory_);
  }

  std::string log(const Task& task) const { return directory_ + "/" + task.name + ".log"; }

  bool find(const Task& task, TaskOutcome& outcome) const {
    std::error_code ignored;
    if (!std::filesystem::exists(file(task), ignored)) return false;
    const Json record = Json::parse(read_file(file(task)), nullptr, false);
    if (record.is_discarded() || record.value("identity", "") != task.identity || record.value("build", "") != build_)
      return false;
    outcome.status = record.value("status", -1);
    outcome.timed_out = record.value("timed_out", false);
    outcome.seconds = record.value("seconds", 0.0);
    outcome.message = record.value("message", "");
    outcome.reused = true;
    return true;
  }

  void forget(const Task& task) const {
    std::error_code ignored;
    std::filesystem::remove(file(task), ignored);
  }

  void keep(const Task& task, const TaskOutcome& outcome) const {
    const Json record = {{"identity", task.identity},      {"build", build_},
                         {"arguments", task.arguments},    {"status", outcome.status},
                         {"timed_out", outcome.timed_out}, {"seconds", outcome.seconds},
                         {"message", outcome.message}};
    write_file(file(task), record.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  }

 private:
  std::string file(const Task& task) const { return directory_ + "/" + task.name + ".json"; }

  std::string directory_, build_;
};

/// The environment without what a launcher of MPI processes, or MPI in this process, has put there.
std::vector<char*> environment_of_children() {
  std::vector<char*> kept;
  for (char** entry = environ; *entry; ++entry) {
    const bool of_mpi = std::strncmp(*entry, "OMPI_COMM_", 10) == 0 || std::strncmp(*entry, "PMIX_", 5) == 0 ||
                        std::strncmp(*entry, "OMPI_UNIVERSE", 13) == 0;
    if (!of_mpi) kept.push_back(*entry);
  }
  kept.push_back(nullptr);
  return kept;
}

pid_t start(const std::string& program, const Task& task, const std::string& log) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), task.arguments.begin(), task.arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::vector<char*> environment = environment_of_children();
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) throw EnvironmentError("cannot write \"" + log + "\": " + std::strerror(errno));
  const pid_t parent = getpid(), child = fork();
  if (child == 0) {  // only calls that are safe between fork and exec
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execve(program.c_str(), argv.data(), environment.data());
    _exit(127);
  }
  close(file);
  if (child < 0) throw EnvironmentError(std::string("cannot start a process: ") + std::strerror(errno));
  return child;
}

/// The processes that are running.
class Pool {
 public:
  Pool(const std::vector<Task>& tasks, const PoolOptions& options, std::vector<TaskOutcome>& outcomes)
      : tasks_(tasks), options_(options), records_(options), outcomes_(outcomes) {}

  ~Pool() {
    for (const auto& [pid, run] : running_) kill(pid, SIGKILL), waitpid(pid, nullptr, 0);
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void run() {
    std::vector<std::size_t> waiting;
    for (std::size_t k = 0; k < tasks_.size(); ++k)
      if (!records_.find(tasks_[k], outcomes_[k])) waiting.push_back(k);
    if (!options_.interleave)
      std::stable_sort(waiting.begin(), waiting.end(),
                       [&](std::size_t a, std::size_t b) { return tasks_[a].weight > tasks_[b].weight; });
    double work = 0;
    for (const std::size_t k : waiting) work += tasks_[k].weight;
    PoolProgress progress(tasks_.size(), tasks_.size() - waiting.size(), work, options_.quiet, options_.budget);
    auto next = waiting.begin();
    const Clock::time_point began = Clock::now();
    while (next != waiting.end() || !running_.empty()) {
      if (options_.budget > 0 && seconds_since(began) > options_.budget) next = waiting.end();
      while (next != waiting.end() && running_.size() < static_cast<std::size_t>(options_.jobs)) launch(*next++);
      if (!wait_for_one(progress)) usleep(2000);
    }
    progress.finish();
  }

 private:
  struct Running {
    std::size_t task;
    Clock::time_point start;
    bool timed_out = false;
  };

  void launch(std::size_t k) {
    records_.forget(tasks_[k]);
    const pid_t child = mortise::start(options_.program, tasks_[k], records_.log(tasks_[k]));
    running_[child] = {k, Clock::now()};
  }

  /// Collects a process that has ended, if there is one; kills those over their limit.
  bool wait_for_one(PoolProgress& progress) {
    int state = 0;
    const pid_t child = waitpid(-1, &state, WNOHANG);
    const auto found = running_.find(child);
    if (child <= 0 || found == running_.end()) {
      for (auto& [pid, run] : running_) {
        const double limit = tasks_[run.task].time_limit;
        if (limit > 0 && !run.timed_out && seconds_since(run.start) > limit) {
          run.timed_out = true;
          kill(pid, SIGKILL);
        }
      }
      progress.show(running_.size());
      return false;
    }
    const Running run = found->second;
    running_.erase(found);
    const Task& task = tasks_[run.task];
    TaskOutcome& outcome = outcomes_[run.task];
    outcome.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    outcome.timed_out = run.timed_out;
    outcome.seconds = seconds_since(run.start);
    outcome.message = last_line(records_.log(task));
    if (outcome.status == 127) throw EnvironmentError("the program could not start itself for \"" + task.name + "\"");
    records_.keep(task, outcome);
    progress.ended(task.name, task.weight, outcome.seconds, running_.size());
    return true;
  }

  const std::vector<Task>& tasks_;
  const PoolOptions& options_;
  Records records_;
  std::vector<TaskOutcome>& outcomes_;
  std::map<pid_t, Running> running_;
};

}  // namespace

std::vector<TaskOutcome> run_tasks(const std::vector<Task>& tasks, const PoolOptions& options) {
  TaskOutcome not_run;
  not_run.status = -1;
  std::vector<TaskOutcome> outcomes(tasks.size(), not_run);
  Pool(tasks, options, outcomes).run();
  return outcomes;
}

int available_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

}  // namespace mortise
