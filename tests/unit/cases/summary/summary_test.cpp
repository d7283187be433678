#include "mortise/cases/summary/summary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "../../grids/output/scratch_folder.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

nlohmann::json written(const RunSummary& summary) {
  const ScratchFolder folder;
  write_summary(summary, folder / "summary.json");
  EXPECT_EQ(folder.files(), 1);
  return nlohmann::json::parse(read_file(folder / "summary.json"));
}

RunSummary example() {
  RunSummary run;
  run.case_name = "shock_rigid_sticks";
  run.scheme = "rigid";
  run.time = 0.7;
  run.steps = 812;
  run.wall_seconds = 2;
  run.cell_updates = 1.2e8;
  run.skipped_fraction = 0.41;
  run.phases = {{"fluid", 0.9}, {"overlap", 0.2}};
  run.cells = {{"background", 160000}, {"stick_0", 4096}};
  run.bodies = {{"stick_0", {0.5, 0.25}, {1, 2}, 0.1, -3}};
  run.overlap = {0, 300, 700};
  run.provenance = provenance();
  run.case_text = "title = \"ρ\"\n";
  return run;
}

TEST(Summary, HasTheAgreedMembers) {
  const nlohmann::json json = written(example());
  for (const char* key : {"case", "scheme", "status", "reason", "time", "steps", "ranks", "wall_seconds",
                          "cell_updates", "cell_updates_per_second", "skipped_fraction", "phases", "memory_bytes",
                          "cells", "bodies", "solids", "interfaces", "overlap", "provenance"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["status"], "finished");
  EXPECT_EQ(json["steps"], 812);
  EXPECT_EQ(json["cell_updates_per_second"], 6e7);
  EXPECT_EQ(json["phases"]["overlap"], 0.2);
  EXPECT_EQ(json["cells"]["stick_0"], 4096);
  EXPECT_EQ(json["bodies"][0]["position"], nlohmann::json({0.5, 0.25}));
  EXPECT_EQ(json["bodies"][0]["angular_velocity"], -3);
  EXPECT_EQ(json["overlap"]["holes"], 700);
  EXPECT_EQ(json["provenance"]["case_text"], "title = \"ρ\"\n");
  for (const char* key : {"version", "git", "dirty", "compiler", "flags"})
    EXPECT_TRUE(json["provenance"].contains(key)) << key;
}

TEST(Summary, SolidsAndInterfaces) {
  RunSummary run = example();
  EXPECT_TRUE(written(run)["solids"].empty());
  EXPECT_TRUE(written(run)["interfaces"].empty());
  run.solids = {{"disk", "neo_hookean", 3, {1, 2}, {0.5, 0.25}, {1.5, 0.75}, 0.1, 0.2, 0.3, 0.9, 7}};
  run.interfaces = {{"disk", {-1, -2}, {1, 2}, 3, 0.7, {0.5, 0.25}, {4, 5}}};
  const nlohmann::json json = written(run), solid = json["solids"][0], interface = json["interfaces"][0];
  EXPECT_EQ(solid["law"], "neo_hookean");
  EXPECT_EQ(solid["mass"], 3);
  EXPECT_EQ(solid["position"], nlohmann::json({1, 2}));
  EXPECT_EQ(solid["momentum"], nlohmann::json({1.5, 0.75}));
  EXPECT_EQ(solid["angular_momentum"], 0.1);
  EXPECT_EQ(solid["kinetic_energy"], 0.2);
  EXPECT_EQ(solid["strain_energy"], 0.3);
  EXPECT_EQ(solid["least_j"], 0.9);
  EXPECT_EQ(solid["max_von_mises"], 7);
  EXPECT_EQ(interface["low"], nlohmann::json({-1, -2}));
  EXPECT_EQ(interface["area"], 3);
  EXPECT_EQ(interface["pressure"], 0.7);
  EXPECT_EQ(interface["velocity"], nlohmann::json({0.5, 0.25}));
  EXPECT_EQ(interface["force"], nlohmann::json({4, 5}));
}

TEST(Summary, ErrorsAndConservationOnlyWhenKnown) {
  RunSummary run = example();
  EXPECT_FALSE(written(run).contains("errors"));
  EXPECT_FALSE(written(run).contains("conservation"));
  run.errors = {{"fluid.density", {1e-3, 2e-3, 0.1}}};
  run.conservation = {1e-14, 2e-14, 3e-14};
  const nlohmann::json json = written(run);
  EXPECT_EQ(json["errors"]["fluid.density"]["l2"], 2e-3);
  EXPECT_EQ(json["conservation"]["momentum"], 2e-14);
}

TEST(Summary, SurvivesNumbersAndTextThatAreNotJson) {
  RunSummary run = example();
  run.time = std::numeric_limits<double>::quiet_NaN();
  run.errors = {{"fluid.density", {std::numeric_limits<double>::infinity(), 0, 0}}};
  run.reason = "bad byte \xff";
  const nlohmann::json json = written(run);
  EXPECT_TRUE(json["time"].is_null());
  EXPECT_TRUE(json["errors"]["fluid.density"]["l1"].is_null());
}

TEST(Summary, ReportsAFolderThatIsNotThere) {
  const ScratchFolder folder;
  EXPECT_THROW(write_summary(example(), folder / "no/summary.json"), EnvironmentError);
}

}  // namespace
}  // namespace mortise
