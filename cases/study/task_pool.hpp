// Runs of the program side by side, each a process of its own: what one of them does to itself touches no other.
// A task that has ended leaves a record; the same task with the same program is not run again.
#pragma once

#include <string>
#include <vector>

namespace mortise {

/// One run of the program.
struct Task {
  std::string name;                    // of its files: letters, digits, "_", "-", ".", "+"
  std::vector<std::string> arguments;  // of the program
  std::string identity;                // what decides its result, besides the program: the case, the arguments
  double weight = 1;                   // expected cost, in any unit: for the order and the time left
  double time_limit = 0;               // seconds after which it counts as hanging and is killed; 0: none
};

/// How a task ended.
struct TaskOutcome {
  int status = 0;          // exit status; 128 + signal for a process that was killed
  bool timed_out = false;  // it was killed at its time limit
  bool reused = false;     // it had been run before
  double seconds = 0;      // wall time of the process
  std::string message;     // what it wrote to the standard error, its last line
};

struct PoolOptions {
  std::string directory;                   // of the records, made if it is not there: NAME.json, NAME.log
  int jobs = 1;                            // processes at a time, ≥ 1
  bool quiet = false;                      // no progress
  bool interleave = false;                 // in the order given; false: the most expensive first
  std::string program = "/proc/self/exe";  // to run; this one
  double budget = 0;                       // seconds after which no further task is started; 0: none
};

/// Runs what has no record yet and waits for it; outcomes in the order of the tasks, those of tasks the budget did not
/// reach have status −1. Shows progress with the time left. Children end with this process, however it ends.
/// Throws EnvironmentError when a process cannot be started or a record cannot be written.
std::vector<TaskOutcome> run_tasks(const std::vector<Task>& tasks, const PoolOptions& options);

/// Cores this process may use.
int available_cores();

}  // namespace mortise
