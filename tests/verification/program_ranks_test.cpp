// Files are the same, bit for bit, on any number of ranks, and with and without skipping.
#include "verification/program_scenes.hpp"

namespace mortise::testing {
namespace {

std::string run(const ScratchFolder& folder, const std::string& name, const Arguments& scene, int ranks,
                const Arguments& more = {}) {
  const Outcome outcome = run_program(Arguments{"run"} + scene + Arguments{"--output", folder / name} + more, {ranks});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  return folder / name;
}

void expect_same(const ScratchFolder& folder, const Arguments& scene, const std::vector<int>& ranks) {
  const std::string one = run(folder, "one", scene, 0);
  ASSERT_GE(files_in(one).size(), 8U);
  EXPECT_EQ(differences(one, run(folder, "again", scene, 0)), std::vector<std::string>{});
  for (const int count : ranks) {
    const std::string many = run(folder, std::to_string(count) + "_ranks", scene, count);
    EXPECT_EQ(differences(one, many), std::vector<std::string>{}) << count << " ranks";
    EXPECT_EQ(summary_of(many)["ranks"], count);
  }
  const std::string all = run(folder, "all", scene, 0, {"--no-skip"});
  // Checkpoints leave out tiles inside bodies, which a run without skipping has.
  EXPECT_EQ(differences(one, all, {"cell_updates", "skipped_fraction", "checkpoint.h5"}), std::vector<std::string>{});
  EXPECT_GT(summary_of(one)["skipped_fraction"], 0.0);
  EXPECT_EQ(summary_of(all)["skipped_fraction"], 0.0);
}

TEST(ProgramRanks, Sticks) {
  const ScratchFolder folder;
  expect_same(folder, sticks(folder), {1, 2, 4});
}

TEST(ProgramRanks, Piston) {
  const ScratchFolder folder;
  expect_same(folder, piston(), {2, 4});
}

TEST(ProgramRanks, SoftSticks) {
  const ScratchFolder folder;
  expect_same(folder, soft_sticks(), {1, 2, 4});
}

TEST(ProgramRanks, SoftSticksAsAReferenceMap) {
  const ScratchFolder folder;
  expect_same(folder, soft_sticks() + Arguments{"--set", "scheme=reference-map"}, {1, 2, 4});
}

TEST(ProgramRanks, HoleInAPlate) {
  const ScratchFolder folder;
  expect_same(folder, hole_in_plate(), {1, 2, 4});
}

TEST(ProgramRanks, SpinningDiskInALiquid) {
  const ScratchFolder folder;
  const std::string one = run(folder, "one", spinning_disk(), 0), two = run(folder, "two", spinning_disk(), 2);
  ASSERT_GE(files_in(one).size(), 8U);
  EXPECT_EQ(differences(one, two), std::vector<std::string>{});
  EXPECT_EQ(summary_of(two)["ranks"], 2);
}

TEST(ProgramRanks, ClosingClipInALiquid) {
  const ScratchFolder folder;
  const std::string one = run(folder, "one", closing_clip(), 0), two = run(folder, "two", closing_clip(), 2);
  ASSERT_GE(files_in(one).size(), 7U);
  EXPECT_EQ(differences(one, two), std::vector<std::string>{});
}

TEST(ProgramRanks, CylindersInContact) {
  const ScratchFolder folder;
  expect_same(folder, {"many_cylinders", "--quiet", "--frames", "3", "--until", "1.2", "--set", "grid.factor=4"}, {3});
  EXPECT_GT(summary_of(folder / "one")["contacts"], 0);
}

TEST(ProgramRanks, DifferencesAreSeen) {
  const ScratchFolder folder;
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder / name);
    write_file(folder / (name + std::string("/x")), "same");
    write_file(folder / (name + std::string("/summary.json")), "{\"steps\": 1, \"ranks\": 1}");
  }
  EXPECT_TRUE(differences(folder / "a", folder / "b").empty());
  write_file(folder / "b/x", "sane");
  write_file(folder / "b/y", "more");
  write_file(folder / "b/summary.json", "{\"steps\": 2, \"ranks\": 2}");
  EXPECT_EQ(differences(folder / "a", folder / "b"), (std::vector<std::string>{"x", "y", "summary.json:steps"}));
}

}  // namespace
}  // namespace mortise::testing
