// A run that was stopped and goes on gives the same files, bit for bit, as one that never stopped.
#include "mortise/grids/output/checkpoint.hpp"
#include "mortise/grids/output/xdmf.hpp"
#include "verification/program_scenes.hpp"

namespace mortise::testing {
namespace {

/// What belongs to the last piece of a run alone.
const std::set<std::string> work = {"cell_updates", "skipped_fraction"};

class Restart : public ::testing::Test {
 protected:
  std::string run(const Arguments& scene, const std::string& name, const Arguments& more = {}, int ranks = 0) const {
    const Outcome outcome =
        run_program(Arguments{"run"} + scene + Arguments{"--output", folder / name} + more, {ranks});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return folder / name;
  }
  std::string go_on(const Arguments& scene, const std::string& name, int ranks = 0) const {
    const Outcome outcome = run_program(Arguments{"run"} + scene + Arguments{"--restart", folder / name}, {ranks});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return folder / name;
  }

  /// Stopped at each of the times in turn, then continued; stopped on two ranks, then continued on three.
  void expect_same(const Arguments& scene, const std::vector<std::string>& times) const {
    const std::string whole = run(scene, "whole");
    for (const std::string& until : times) {
      run(scene, "parts", {"--until", until, "--overwrite"});
      EXPECT_EQ(summary_of(folder / "parts")["time"], std::stod(until));
      EXPECT_EQ(differences(whole, go_on(scene, "parts"), work), std::vector<std::string>{}) << until;
    }
    run(scene, "ranks", {"--until", times.front()}, 2);
    EXPECT_EQ(differences(whole, go_on(scene, "ranks", 3), work), std::vector<std::string>{});
  }

  const ScratchFolder folder;
};

// Between frames, and at one.
TEST_F(Restart, Sticks) { expect_same(sticks(folder), {"0.35", "0.4"}); }
TEST_F(Restart, Piston) { expect_same(piston(), {"0.55", "0.5"}); }

TEST_F(Restart, SoftSticks) { expect_same(soft_sticks(), {"0.025", "0.03"}); }
TEST_F(Restart, SoftSticksAsAReferenceMap) {
  expect_same(soft_sticks() + Arguments{"--set", "scheme=reference-map"}, {"0.025", "0.03"});
}
TEST_F(Restart, HoleInAPlate) { expect_same(hole_in_plate(), {"0.25", "0.3"}); }

TEST_F(Restart, ClosingClipInALiquid) { expect_same(closing_clip(), {"0.27", "0.3"}); }  // while its parts touch
TEST_F(Restart, SpinningDiskInALiquid) { expect_same(spinning_disk(), {"0.04", "0.05"}); }

// The history that oscillations are found in goes on, too.
TEST_F(Restart, OscillationsInALiquid) {
  const Arguments scene = spinning_disk() + Arguments{"--set", "output.oscillation=[0.01, 0.1]"};
  const std::string whole = run(scene, "whole");
  EXPECT_EQ(summary_of(whole)["oscillations"].size(), 4U);
  run(scene, "parts", {"--until", "0.04"});
  EXPECT_FALSE(summary_of(folder / "parts").contains("oscillations"));
  EXPECT_EQ(differences(whole, go_on(scene, "parts"), work), std::vector<std::string>{});
  EXPECT_EQ(run_program(Arguments{"run"} + piston() + Arguments{"--restart", folder / "parts"}).status, 4);
  const Arguments other = {"--set", "probes=[{position=[0.25, 0]}]", "--restart", folder / "parts"};
  EXPECT_EQ(run_program(Arguments{"run"} + scene + other).status, 4) << "another number of probes";
}

/// An elastic piston that takes several steps within one of the gas, or one within several.
Arguments elastic_piston(const std::string& scheme, double scale) {
  return {"elastic_piston", "--quiet",
          "--frames",       "2",
          "--set",          "grid.factor=2",
          "--set",          "scheme=" + scheme,
          "--set",          "solid.scale=" + std::to_string(scale),
          "--set",          "output.checkpoint_interval=0.1"};
}

// What the schemes remember of the last steps, and structures' steps that are under way, are kept.
TEST_F(Restart, EverySchemeOfAnElasticPiston) {
  for (const char* scheme : {"projection", "traditional", "traditional-subiterated"}) {
    const Arguments scene = elastic_piston(scheme, 10), slow = {"--set", "solids.0.material.density=1000"};
    for (const Arguments& all : {scene, scene + slow}) {
      const std::string whole = run(all, "whole", {"--overwrite"});
      for (const std::string until : {"0.3", "0.35"}) {
        run(all, "parts", {"--until", until, "--overwrite"});
        EXPECT_EQ(differences(whole, go_on(all, "parts"), work), std::vector<std::string>{}) << scheme << " " << until;
      }
    }
  }
}

TEST_F(Restart, UntilLeavesACheckpointWithoutAnInterval) {
  const Arguments scene = piston() + Arguments{"--set", "output.checkpoint_interval=0"};
  for (const std::string until : {"0.5", "0.6"}) {  // at a frame, and between two
    run(scene, "parts", {"--until", until, "--overwrite"});
    EXPECT_TRUE(std::filesystem::exists(folder / "parts/checkpoint.h5"));
    go_on(scene, "parts");
    EXPECT_EQ(summary_of(folder / "parts")["time"], 1.0);
  }
}

TEST_F(Restart, InThreePiecesWithContacts) {
  const Arguments scene = {"many_cylinders", "--quiet",       "--frames", "2",
                           "--set",          "grid.factor=4", "--set",    "time.end=1.5"};
  const std::string whole = run(scene, "whole");
  run(scene, "parts", {"--until", "1.1"});
  EXPECT_EQ(run_program(Arguments{"run"} + scene + Arguments{"--restart", folder / "parts", "--until", "1.3"}).status,
            0);
  std::vector<std::string> different = differences(whole, go_on(scene, "parts"), work);
  EXPECT_EQ(different, std::vector<std::string>{"checkpoint.h5"});  // the whole run writes none
  EXPECT_GT(summary_of(whole)["contacts"], 0);
}

// Ten frames over the run: those after 0.5 of it follow, whatever came before.
TEST_F(Restart, WithOtherFrames) {
  struct Part {
    Arguments scene;
    std::string until;
  };
  for (const Part& part : {Part{piston(), "0.55"}, Part{spinning_disk(), "0.055"}}) {
    run(part.scene, "parts", {"--until", part.until, "--overwrite"});
    Arguments ten = part.scene;
    *(std::ranges::find(ten, "--frames") + 1) = "10";
    const std::string out = run(ten, "late", {"--restart", folder / "parts", "--overwrite"});
    std::set<std::string> numbers;
    for (const auto& entry : std::filesystem::directory_iterator(out + "/frames")) {
      const std::string name = entry.path().stem().string();
      numbers.insert(name.substr(name.size() - 4));
    }
    EXPECT_EQ(numbers, (std::set<std::string>{"0006", "0007", "0008", "0009", "0010"})) << part.until;
    EXPECT_EQ(summary_of(out)["status"], "finished");
  }
}

TEST_F(Restart, IntoAnotherDirectory) {
  const Arguments scene = piston();
  run(scene, "whole");
  run(scene, "early", {"--until", "0.55"});
  const std::set<std::string> before = files_in(folder / "early");
  run(scene, "late", {"--restart", folder / "early"});
  EXPECT_EQ(files_in(folder / "early"), before);
  EXPECT_EQ(read_file(folder / "late/checkpoint.h5"), read_file(folder / "whole/checkpoint.h5"));
  EXPECT_EQ(summary_of(folder / "late")["bodies"], summary_of(folder / "whole")["bodies"]);
  const Outcome again =
      run_program(Arguments{"run"} + scene + Arguments{"--restart", folder / "early", "--output", folder / "late"});
  EXPECT_EQ(again.status, 2) << "another run there must not be mixed with this one";
}

// Killed at any moment, a run leaves whole files only, and goes on to the same end.
TEST_F(Restart, AfterAKill) {
  const Arguments scene = sticks(folder);
  const std::string whole = run(scene, "whole");
  for (const int milliseconds : {0, 5, 20}) {
    const std::string name = "killed_" + std::to_string(milliseconds), out = folder / name;
    Program program(Arguments{"run"} + scene + Arguments{"--output", out});
    for (int k = 0; k < 60000 && !std::filesystem::exists(out + "/checkpoint.h5"); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.kill();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, -1) << "it ended before it was killed";
    EXPECT_FALSE(CheckpointReader(out + "/checkpoint.h5").doubles("values").empty());
    for (const std::string& path : series_files(out)) EXPECT_EQ(read_snapshot(path).grids.size(), 6U) << path;
    const std::string index = read_file(out + "/mortise.xdmf");
    EXPECT_NE(index.find("</Xdmf>\n"), std::string::npos);
    EXPECT_EQ(files_in(out).count("summary.json"), 0U);
    write_file(out + "/fields/step_000099.h5.part", "what was being written");
    EXPECT_EQ(differences(whole, go_on(scene, name), work), std::vector<std::string>{}) << milliseconds << " ms";
  }
}

}  // namespace
}  // namespace mortise::testing
