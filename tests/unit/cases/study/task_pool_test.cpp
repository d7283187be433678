#include "mortise/cases/study/task_pool.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "unit/grids/output/scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

class TaskPool : public ::testing::Test {
 protected:
  /// A shell command as a task; each run of it adds a line to the file `ran`.
  Task task(const std::string& name, const std::string& command, double limit = 0) const {
    Task made;
    made.name = name;
    made.arguments = {"-c", "echo " + name + " >> " + folder / "ran" + "; " + command};
    made.identity = command;
    made.time_limit = limit;
    return made;
  }
  std::vector<TaskOutcome> run(const std::vector<Task>& tasks, int jobs = 2, double budget = 0) const {
    PoolOptions options;
    options.directory = folder / "records";
    options.jobs = jobs;
    options.quiet = true;
    options.program = "/bin/sh";
    options.budget = budget;
    return run_tasks(tasks, options);
  }
  long runs() const {
    const std::string text = read_file(folder / "ran");
    return std::count(text.begin(), text.end(), '\n');
  }
  const ScratchFolder folder;
};

TEST_F(TaskPool, TellsHowEachTaskEnded) {
  const auto outcomes = run({task("good", "true"), task("bad", "echo first >&2; echo last >&2; exit 3"),
                             task("killed", "kill -SEGV $$"), task("hangs", "sleep 60", 0.2)});
  EXPECT_EQ(outcomes[0].status, 0);
  EXPECT_EQ(outcomes[1].status, 3);
  EXPECT_EQ(outcomes[1].message, "last");
  EXPECT_EQ(outcomes[2].status, 128 + SIGSEGV);
  EXPECT_FALSE(outcomes[2].timed_out);
  EXPECT_EQ(outcomes[3].status, 128 + SIGKILL);
  EXPECT_TRUE(outcomes[3].timed_out);
  for (const TaskOutcome& outcome : outcomes) EXPECT_FALSE(outcome.reused);
}

TEST_F(TaskPool, WhatHasEndedIsNotRunAgain) {
  run({task("a", "exit 3")});
  const auto outcomes = run({task("a", "exit 3"), task("b", "true")});
  EXPECT_EQ(runs(), 2);
  EXPECT_TRUE(outcomes[0].reused);
  EXPECT_EQ(outcomes[0].status, 3);
  EXPECT_FALSE(outcomes[1].reused);
}

TEST_F(TaskPool, AnotherTaskOfTheSameNameIsRun) {
  run({task("a", "true")});
  const auto outcomes = run({task("a", "exit 5")});
  EXPECT_EQ(outcomes[0].status, 5);
  EXPECT_EQ(runs(), 2);
}

TEST_F(TaskPool, ADamagedRecordIsNoRecord) {
  run({task("a", "true")});
  write_file(folder / "records/a.json", "{\"identity\": \"tr");
  EXPECT_FALSE(run({task("a", "true")})[0].reused);
}

TEST_F(TaskPool, NothingStartsAfterTheBudget) {
  const auto outcomes = run({task("a", "sleep 0.3"), task("b", "true"), task("c", "true")}, 1, 0.1);
  EXPECT_EQ(outcomes[0].status, 0);
  EXPECT_EQ(outcomes[1].status, -1);
  EXPECT_EQ(outcomes[2].status, -1);
}

// Two tasks that wait for each other end only if they run side by side.
TEST_F(TaskPool, TasksRunSideBySide) {
  const auto meet = [&](const std::string& own, const std::string& other) {
    return "touch " + folder / own + "; while ! [ -e " + folder / other + " ]; do sleep 0.01; done";
  };
  const auto outcomes = run({task("a", meet("x", "y"), 20), task("b", meet("y", "x"), 20)});
  EXPECT_EQ(outcomes[0].status, 0);
  EXPECT_EQ(outcomes[1].status, 0);
}

TEST_F(TaskPool, AProgramThatCannotBeStartedIsTheEnvironmentsFault) {
  PoolOptions options;
  options.directory = folder / "records";
  options.quiet = true;
  options.program = folder / "none";
  EXPECT_THROW(run_tasks({task("a", "true")}, options), EnvironmentError);
}

}  // namespace
}  // namespace mortise
