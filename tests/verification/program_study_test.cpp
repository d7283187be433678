// Studies as a user runs them: tables, resuming, bad input.
#include "verification/program_run.hpp"

namespace mortise::testing {
namespace {

class Study : public ::testing::Test {
 protected:
  Outcome study(const Arguments& arguments, const std::string& name = "study") const {
    return run_program(Arguments{"study"} + arguments + Arguments{"--output", folder / name});
  }
  /// Study data, without what is measured by the clock.
  nlohmann::json data(const std::string& name = "study") const {
    nlohmann::json all = nlohmann::json::parse(read_file(folder / name + "/study.json"));
    for (nlohmann::json& level : all["levels"]) level.erase("seconds");
    return all;
  }
  void expect_refused(const Arguments& arguments, const std::string& part) const {
    const Outcome outcome = study(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "study"));
  }
  const ScratchFolder folder;
  const Arguments piston = {"convergence", "elastic_piston", "--levels", "3", "--set", "grid.factor=2"};
};

TEST_F(Study, ConvergenceOfTheElasticPistonIsSecondOrder) {
  const Outcome outcome = study(piston);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("| solid stress"), std::string::npos);
  for (const char* file : {"study.csv", "study.md", "study.tex", "study.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "study/" + file)) << file << outcome.errors;
  int found = 0;
  const nlohmann::json all = data();
  for (const nlohmann::json& quantity : all["quantities"])
    if (quantity["name"] == "fluid.density" || quantity["name"] == "solid.displacement") {
      EXPECT_GT(quantity["l1_order"].get<double>(), 1.8) << quantity["name"];
      EXPECT_LT(quantity["l1_order"].get<double>(), 2.5) << quantity["name"];
      ++found;
    }
  EXPECT_EQ(found, 2);
}

TEST_F(Study, SelfConvergenceFindsTheSameOrder) {
  const Outcome outcome =
      study({"convergence", "elastic_piston", "--levels", "4", "--against", "self", "--set", "grid.factor=2"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const nlohmann::json all = data();
  const auto density = std::find_if(all["quantities"].begin(), all["quantities"].end(),
                                    [](const nlohmann::json& quantity) { return quantity["name"] == "fluid.density"; });
  ASSERT_NE(density, all["quantities"].end());
  EXPECT_NEAR((*density)["l1_order"].get<double>(), 2, 0.2);
}

TEST_F(Study, ThatWasKilledGoesOnWithWhatItHad) {
  ASSERT_EQ(study(piston, "whole").status, 0);
  {
    Program killed(Arguments{"study"} + piston + Arguments{"--jobs", "1", "--output", folder / "study"});
    const std::string first = folder / "study/members/grid.factor=8.json";  // the most expensive one comes first
    for (int wait = 0; wait < 3000 && !std::filesystem::exists(first); ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ASSERT_TRUE(std::filesystem::exists(first));
  }
  ASSERT_FALSE(std::filesystem::exists(folder / "study/study.json"));
  const auto record = std::filesystem::last_write_time(folder / "study/members/grid.factor=8.json");
  const Outcome outcome = study(piston);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(std::filesystem::last_write_time(folder / "study/members/grid.factor=8.json"), record);
  EXPECT_EQ(data(), data("whole"));
  EXPECT_EQ(read_file(folder / "study/study.csv"), read_file(folder / "whole/study.csv"));
}

TEST_F(Study, CostMarksTheParetoFront) {
  const Outcome outcome = study({"cost", "elastic_piston", "--levels", "2", "--repeats", "2", "--set", "grid.factor=2",
                                 "--set", "solid.scale=0.5", "--schemes", "projection,traditional"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const nlohmann::json points = nlohmann::json::parse(read_file(folder / "study/study.json")).at("points");
  ASSERT_EQ(points.size(), 4u);
  int on_front = 0;
  for (const nlohmann::json& point : points) {
    EXPECT_LE(point["least_seconds"], point["seconds"]);
    EXPECT_LE(point["seconds"], point["most_seconds"]);
    if (point["status"] == "finished") {
      EXPECT_GT(point["error"].get<double>(), 0);
    }
    on_front += point["pareto"].get<bool>();
  }
  EXPECT_GE(on_front, 1);
}

TEST_F(Study, StabilityPutsTheoryBesideTheRun) {
  const Outcome outcome = study({"stability", "resting_tube", "--vary", "solid.scale=0.5,2", "--schemes",
                                 "traditional+lagged,projection", "--threshold", "--steps", "300"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "study/study.png")) << outcome.errors;
  const nlohmann::json all = nlohmann::json::parse(read_file(folder / "study/study.json"));
  ASSERT_EQ(all["points"].size(), 4u);
  EXPECT_NEAR(all["points"][0]["measured"].get<double>(), 2, 0.02);
  EXPECT_NEAR(all["points"][0]["predicted"].get<double>(), 2, 1e-4);
  for (const std::size_t k : {1u, 2u, 3u}) {
    EXPECT_LE(all["points"][k]["measured"].get<double>(), 1) << k;
    EXPECT_LE(all["points"][k]["predicted"].get<double>(), 1 + 1e-12) << k;
  }
  EXPECT_NEAR(all["thresholds"][0]["measured"].get<double>(), 1, 0.02);
  EXPECT_NEAR(all["thresholds"][0]["predicted"].get<double>(), 1, 0.02);
  EXPECT_TRUE(all["thresholds"][1]["measured"].is_null());
}

TEST_F(Study, StressGoesOnWithTheNextSeed) {
  const Outcome first = study({"stress", "--scenes", "3", "--seed", "5", "--minutes", "2"});
  ASSERT_EQ(first.status, 0) << first.output << first.errors;
  EXPECT_EQ(lines(read_file(folder / "study/journal.jsonl")).size(), 3u);
  // The fourth one was cut short: it is run again.
  write_file(folder / "study/journal.jsonl", read_file(folder / "study/journal.jsonl") + "{\"seed\": 8, \"ki");
  const Outcome second = study({"stress", "--scenes", "5", "--seed", "5", "--minutes", "2"});
  ASSERT_EQ(second.status, 0) << second.output << second.errors;
  std::vector<int> seeds;
  for (const std::string& line : lines(read_file(folder / "study/journal.jsonl")))
    seeds.push_back(nlohmann::json::parse(line).at("seed"));
  EXPECT_EQ(seeds, (std::vector<int>{5, 6, 7, 8, 9}));
}

TEST_F(Study, PublishedNumbersStandBesideOurs) {
  const Outcome outcome = study({"published", "--only", "rigid_piston"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string line = "\"released, F = 16, L1: ρ\",6.2e-05,";
  const std::string table = read_file(folder / "study/study.csv");
  const std::size_t found = table.find(line);
  ASSERT_NE(found, std::string::npos) << table;
  EXPECT_NEAR(std::stod(table.substr(found + line.size())), 2.0e-5, 0.3e-5);
}

TEST_F(Study, BadInputIsRefusedBeforeAnythingRuns) {
  expect_refused({"convergence", "elastic_piston", "--vary", "grid.facto=4,8"}, "did you mean \"factor\"?");
  expect_refused({"convergence", "elastic_piston", "--vary", "time.cfl=0.5,2"}, "(0, 1]");
  expect_refused({"convergence", "shock_rigid_sticks", "--against", "exact"}, "no exact solution");
  expect_refused({"convergence", "elastic_piston", "--set", "gas.gama=1.3"}, "did you mean \"gamma\"?");
  expect_refused({"convergence", "elastic_piston", "--levels", "1"}, "integer from 2");
  expect_refused({"cost", "elastic_piston", "--schemes", "rigid"}, "cannot run this scene");
  expect_refused({"cost", "elastic_piston", "--schemes", "projetion"}, "did you mean \"projection\"?");
  expect_refused({"cost", "sod"}, "couples nothing");
  expect_refused({"stability", "resting_tube", "--vary", "solid.scale"}, "needs values");
  expect_refused({"stability", "resting_tube", "--vary", "solid.scale=0.5,-1"}, "solid.scale = -1");
  expect_refused({"stability", "resting_tube", "--vary", "solid.scale=1,2", "--schemes", "rigid"}, "cannot run this");
  expect_refused({"stress", "--minutes", "0"}, "must be a number > 0");
  expect_refused({"published", "--only", "rigid_pistn"}, "did you mean \"rigid_piston\"?");
  expect_refused({"convergance", "sod"}, "did you mean \"convergence\"?");
}

}  // namespace
}  // namespace mortise::testing
