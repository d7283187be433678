// What a run with an incompressible fluid writes: histories of solids and probes, contours, oscillations.
#include <cmath>

#include "mortise/grids/output/xdmf.hpp"
#include "verification/program_scenes.hpp"

namespace mortise::testing {
namespace {

class ProgramFlow : public ::testing::Test {
 protected:
  void run(const Arguments& scene) const {
    const Outcome outcome =
        run_program(Arguments{"run"} + scene + Arguments{"--quiet", "--output", out, "--overwrite"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
  }
  static double value(const CsvRow& row, const std::string& column) { return std::stod(row.at(column)); }

  const ScratchFolder folder;
  const std::string out = folder / "out";
};

/// All moves with (0.5, 0.25), the disk too, whose density is that of the fluid.
const Arguments drift = {"spinning_disk",
                         "--frames",
                         "0",
                         "--set",
                         "solids.0.angular_velocity=0",
                         "--set",
                         "initial.state=[1, 0.5, 0.25, 1]",
                         "--set",
                         "probes=[{name=\"free\", position=[0.9, -0.7]}, {name=\"inside\", position=[0.2, 0.1]}]"};

TEST_F(ProgramFlow, TracersMoveWithAUniformFlow) {
  run(drift);
  EXPECT_EQ(lines(read_file(out + "/tracers.csv")).at(0), "t,probe,x,y");
  const std::vector<CsvRow> rows = csv_rows(out + "/tracers.csv");
  ASSERT_EQ(rows.size(), 2 * (summary_of(out)["steps"].get<std::size_t>() + 1));
  EXPECT_EQ(value(rows[0], "t"), 0);
  EXPECT_NEAR(value(rows.back(), "t"), 0.3, 1e-12);
  for (std::size_t k = 0; k < rows.size(); k += 2) {
    const double t = value(rows[k], "t");
    EXPECT_EQ(rows[k].at("probe"), "free");
    EXPECT_EQ(rows[k + 1].at("probe"), "inside");
    EXPECT_NEAR(value(rows[k], "x"), 0.9 + 0.5 * t, 1e-7);  // through the periodic side at x = 1
    EXPECT_NEAR(value(rows[k], "y"), -0.7 + 0.25 * t, 1e-7);
    EXPECT_NEAR(value(rows[k + 1], "x"), 0.2 + 0.5 * t, 1e-7);
    EXPECT_NEAR(value(rows[k + 1], "y"), 0.1 + 0.25 * t, 1e-7);
  }
}

TEST_F(ProgramFlow, SolidsCarryTheirMomentum) {
  run(drift);
  EXPECT_EQ(lines(read_file(out + "/solids.csv")).at(0), "t,solid,x,y,velocity_x,velocity_y,angular_momentum,volume");
  const std::vector<CsvRow> rows = csv_rows(out + "/solids.csv");
  ASSERT_EQ(rows.size(), summary_of(out)["steps"].get<std::size_t>() + 1);
  for (const CsvRow& row : rows) {
    const double t = value(row, "t");
    EXPECT_EQ(row.at("solid"), "disk");
    EXPECT_NEAR(value(row, "x"), 0.5 * t, 1e-3);
    EXPECT_NEAR(value(row, "y"), 0.25 * t, 1e-3);
    EXPECT_NEAR(value(row, "velocity_x"), 0.5, 1e-6);
    EXPECT_NEAR(value(row, "velocity_y"), 0.25, 1e-6);
    EXPECT_NEAR(value(row, "volume"), M_PI / 4, 2e-3);
  }
}

TEST_F(ProgramFlow, ProbeInASolidTurnsWithIt) {
  run(spinning_disk());
  const std::vector<CsvRow> rows = csv_rows(out + "/tracers.csv");
  std::vector<CsvRow> inside;
  for (const CsvRow& row : rows)
    if (row.at("probe") == "inside") inside.push_back(row);
  const double x = value(inside.back(), "x"), y = value(inside.back(), "y");
  EXPECT_NEAR(std::hypot(x, y), 0.25, 2e-3);
  EXPECT_LT(std::atan2(y, x), 2 * 0.1);  // ω t, but the fluid brakes it
  EXPECT_GT(std::atan2(y, x), 0.17);
}

TEST_F(ProgramFlow, OscillationsOfProbesAreInTheSummary) {
  run({"spinning_disk", "--frames", "0", "--set", "solids.0.angular_velocity=0", "--set", "grid.factor=1.6", "--set",
       "time.end=2", "--set", "solids.0.anchors=[{radius=0.3, angle=\"0.1*sin(8*pi*t)\"}]", "--set",
       "probes=[{name=\"arm\", position=[0.2, 0]}]", "--set", "output.oscillation=[0.5, 2]"});
  const nlohmann::json all = summary_of(out)["oscillations"];
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0]["component"], "x");
  EXPECT_EQ(all[1]["component"], "y");
  EXPECT_EQ(all[1]["probe"], "arm");
  EXPECT_NEAR(all[1]["frequency"], 4, 0.05);
  EXPECT_NEAR(all[1]["amplitude"], 0.02, 0.005);
  EXPECT_NEAR(all[1]["mean"], 0, 0.002);
  EXPECT_GT(all[1]["half_range"], 0.9 * all[1]["amplitude"].get<double>());
}

TEST_F(ProgramFlow, PicturesOfPressureAndContours) {
  run(spinning_disk() +
      Arguments{"--set", "output.pictures=[\"pressure\", \"velocity\"]", "--set", "output.contours=true"});
  for (const char* name : {"pressure_0000", "pressure_0001", "velocity_0001"})
    EXPECT_EQ(read_file(out + "/frames/" + name + ".png").substr(1, 3), "PNG") << name;
  const Snapshot last = read_snapshot(series_files(out).back());
  EXPECT_EQ(last.surfaces.size(), 1U);
  ASSERT_GE(last.contours.size(), 6U);
  for (const auto& line : last.contours)
    for (const Point<2>& x : line) EXPECT_LT(x.norm(), 0.51);
  run(spinning_disk());
  EXPECT_TRUE(read_snapshot(series_files(out).back()).contours.empty());
}

}  // namespace
}  // namespace mortise::testing
