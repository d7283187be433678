// Failures on the way: the computation (exit status 3) and its surroundings (4). What was written before stays good.
#include "mortise/grids/output/checkpoint.hpp"
#include "mortise/grids/output/xdmf.hpp"
#include "verification/program_run.hpp"

namespace mortise::testing {
namespace {

class FailingRun : public ::testing::Test {
 protected:
  FailingRun() { write_file(folder / "case.toml", two_bodies); }

  Outcome run(const Arguments& arguments, Launch launch = {}) const {
    launch.folder = folder.path();
    return run_program(Arguments{"run", "case.toml", "--output", "out", "--quiet"} + arguments, launch);
  }

  /// `status` of the program, and the same sentence in summary.json and, once, on stderr.
  void expect_failed(const Outcome& outcome, int status, const std::string& kind) const {
    ASSERT_EQ(outcome.status, status) << outcome.errors;
    const nlohmann::json summary = summary_of(out);
    EXPECT_EQ(summary["status"], kind);
    EXPECT_EQ(lines(outcome.errors).at(0), "mortise: " + summary["reason"].get<std::string>());
    EXPECT_EQ(count(outcome.errors, "mortise: "), 1) << outcome.errors;
    EXPECT_LT(summary["time"], 0.1);
  }

  /// Every file is whole: the checkpoint, the fields, the index; no unfinished ones are left.
  void expect_whole_files() const {
    for (const std::string& path : series_files(out)) EXPECT_FALSE(read_snapshot(path).grids.empty()) << path;
    for (const std::string& name : files_in(out)) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    if (!std::filesystem::exists(out + "/checkpoint.h5")) return;
    EXPECT_FALSE(CheckpointReader(out + "/checkpoint.h5").doubles("values").empty());
  }

  const ScratchFolder folder;
  const std::string out = folder / "out";
};

using NumericalFailure = FailingRun;

// Steps far too long for the waves in the tube.
TEST_F(NumericalFailure, NamesTheFirstBadCell) {
  const Outcome outcome =
      run_program({"run", "sod", "--output", "out", "--quiet", "--set", "time.step=0.02"}, {.folder = folder.path()});
  expect_failed(outcome, 3, "unstable");
  const std::string reason = summary_of(out)["reason"];
  for (const char* part :
       {" at t = 0.0", "step ", "grid background, cell (", ") at (", "density ", "pressure ", "velocity "})
    EXPECT_NE(reason.find(part), std::string::npos) << part << " in: " << reason;
  expect_whole_files();
}

TEST_F(NumericalFailure, BodyDrivenIntoTheEdge) {
  expect_failed(run({"--set", "bodies.0.motion={x=\"-10*t\", y=\"0\", angle=\"0\"}"}), 3, "unstable");
  const std::string reason = summary_of(out)["reason"];
  for (const char* part : {"without a donor", "grid background, cell (", ") at (-0.9"})
    EXPECT_NE(reason.find(part), std::string::npos) << part << " in: " << reason;
  expect_whole_files();
}

const Arguments torn_away = {"--set", "bodies.0.force.x=1e6*max(0, t - 0.02)", "--set",
                             "output.checkpoint_interval=0.01"};

TEST_F(NumericalFailure, KeepsTheLastGoodCheckpoint) {
  expect_failed(run(torn_away), 3, "unstable");
  expect_whole_files();
  const double checkpoint = CheckpointReader(out + "/checkpoint.h5").doubles("motion").at(0);
  EXPECT_GE(checkpoint, 0.01);
  EXPECT_LE(checkpoint, summary_of(out)["time"]);
  const Outcome without_force = run({"--restart", "out"});
  EXPECT_EQ(without_force.status, 0) << without_force.errors;
  EXPECT_EQ(summary_of(out)["status"], "finished");
}

TEST_F(NumericalFailure, OnTwoRanks) {
  expect_failed(run(torn_away, {.ranks = 2}), 3, "unstable");
  expect_whole_files();
}

// Traditional coupling diverges when the body is lighter than the gas it moves.
TEST_F(NumericalFailure, TraditionalCouplingOfALightBody) {
  expect_failed(
      run({"--set", "scheme=traditional", "--set", "bodies.0.density=1e-4", "--set", "bodies.1.density=1e-4"}), 3,
      "unstable");
  const std::string reason = summary_of(out)["reason"];
  for (const char* part : {"unstable", " at t = 0.0", "step ", "body ", " moves at "})
    EXPECT_NE(reason.find(part), std::string::npos) << part << " in: " << reason;
  expect_whole_files();
}

TEST_F(NumericalFailure, ForceThatIsNoNumber) {
  expect_failed(run({"--set", "bodies.0.force.x=sqrt(0.05 - t)"}), 3, "unstable");
  const std::string reason = summary_of(out)["reason"];
  EXPECT_NE(reason.find("\"first\""), std::string::npos) << reason;
  EXPECT_NE(reason.find("not finite"), std::string::npos) << reason;
}

/// A shell pressed together ever harder from outside, until something gives way.
class PressedShell : public FailingRun {
 protected:
  void expect_reason(const Arguments& more, const std::vector<std::string>& parts) const {
    const Outcome outcome =
        run_program(Arguments{"run", "radial_shell", "--output", "out", "--quiet", "--frames", "1", "--set",
                              "exact=none", "--set", "grid.factor=2", "--set", "output.checkpoint_interval=0.02"} +
                        more,
                    {.folder = folder.path()});
    ASSERT_EQ(outcome.status, 3) << outcome.errors;
    const std::string reason = summary_of(out)["reason"];
    EXPECT_EQ(lines(outcome.errors).at(0), "mortise: " + reason);
    for (const std::string& part : parts) EXPECT_NE(reason.find(part), std::string::npos) << part << " in: " << reason;
    expect_whole_files();
    const double checkpoint = CheckpointReader(out + "/checkpoint.h5").doubles("motion").at(0);
    EXPECT_GT(checkpoint, 0.0);
    EXPECT_LE(checkpoint, summary_of(out)["time"]);
  }
};

TEST_F(PressedShell, FoldedGridIsNamed) {
  expect_reason({"--set", "solids.0.traction.outer=-4*t"},
                {" at t = 0.", "step ", "the gas around solid shell has no grid any more", "cell (", "folded at ("});
}

TEST_F(PressedShell, InvertedCellIsNamed) {
  expect_reason({"--set", "solids.0.traction.outer=-20*t", "--set", "solids.0.material.law=saint_venant_kirchhoff"},
                {" at t = 0.", "step ", "grid shell, cell (", ") at (", "J -0."});
}

using EnvironmentFailure = FailingRun;

// Files that may not grow beyond a size fail as on a full disk, which tests cannot have everywhere.
TEST_F(EnvironmentFailure, FullDiskAtTheFields) {
  const Outcome outcome = run({}, {.file_size = 200 << 10});
  expect_failed(outcome, 4, "failed");
  EXPECT_NE(outcome.errors.find("cannot write \"out/fields/step_000000.h5\""), std::string::npos) << outcome.errors;
  EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome.errors;
  expect_whole_files();
}

TEST_F(EnvironmentFailure, FullDiskAtTheHistories) {
  const Outcome outcome = run({"--set", "output.frames=0"}, {.file_size = 3 << 10});
  expect_failed(outcome, 4, "failed");
  EXPECT_NE(outcome.errors.find("cannot write \"out/bodies.csv\""), std::string::npos) << outcome.errors;
}

TEST_F(EnvironmentFailure, FullDiskKeepsTheLastCheckpoint) {
  const Arguments often = {"--set", "output.checkpoint_interval=0.01", "--set", "output.frames=0"};
  ASSERT_EQ(run(often + Arguments{"--until", "0.05"}).status, 0);
  const std::string before = read_file(out + "/checkpoint.h5");
  const Outcome outcome = run(often + Arguments{"--restart", "out"}, {.file_size = 100 << 10});
  expect_failed(outcome, 4, "failed");
  EXPECT_NE(outcome.errors.find("cannot write \"out/checkpoint.h5\""), std::string::npos) << outcome.errors;
  EXPECT_EQ(read_file(out + "/checkpoint.h5"), before);
  expect_whole_files();
}

TEST_F(EnvironmentFailure, StandardOutputThatIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  Program program({"sh", "-c", "exec \"$0\" \"$@\" > /dev/full", MORTISE_PROGRAM}, {"list"}, {});
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.status, 4);
  EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome.errors;
}

class BadRestart : public FailingRun {
 protected:
  void expect_refused(const Arguments& arguments, const std::string& fragment, int ranks = 0) const {
    const Outcome outcome = run(arguments, {.ranks = ranks});
    EXPECT_EQ(outcome.status, 4) << outcome.errors;
    const std::string sentence = lines(outcome.errors).at(0);
    EXPECT_EQ(sentence.rfind("mortise: cannot read the restart \"", 0), 0U) << outcome.errors;
    EXPECT_NE(sentence.find(fragment), std::string::npos) << outcome.errors;
    EXPECT_EQ(count(outcome.errors, "mortise: "), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
};

TEST_F(BadRestart, Missing) {
  expect_refused({"--restart", "nowhere"}, "missing");
  expect_refused({"--restart", "nowhere"}, "missing", 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
}

TEST_F(BadRestart, TruncatedDamagedOrOfAnotherScene) {
  ASSERT_EQ(run({"--until", "0.03"}).status, 0);
  std::filesystem::rename(out, folder / "early");
  expect_refused({"--restart", "early", "--set", "grid.factor=4.5"}, "another scene");
  expect_refused({"--restart", "early", "--set", "grid.tile=[40, 40]"}, "another scene");
  const std::string checkpoint = folder / "early/checkpoint.h5", whole = read_file(checkpoint);
  write_file(checkpoint, whole.substr(0, whole.size() / 2));
  expect_refused({"--restart", "early"}, "incomplete");
  std::string damaged = whole;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  write_file(checkpoint, damaged);
  expect_refused({"--restart", "early"}, "damaged");
}

}  // namespace
}  // namespace mortise::testing
