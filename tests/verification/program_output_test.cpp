// What a run writes: histories, fields and their index, pictures, the summary, progress.
#include <hdf5.h>

#include <cmath>
#include <regex>

#include "mortise/grids/output/hdf5_file.hpp"
#include "mortise/grids/output/xdmf.hpp"
#include "verification/program_run.hpp"

namespace mortise::testing {
namespace {

/// Uniform flow through two grids that move as prescribed, with probes in the gas and inside a body.
const Arguments still = {"run", "stream.toml", "--output", "out"}, stream = still + Arguments{"--frames", "3"};

class ProgramOutput : public ::testing::Test {
 protected:
  ProgramOutput() {
    const std::string probes =
        "\n[[probes]]\nname = \"stream\"\nposition = [-1.2, -1.1]\n"
        "\n[[probes]]\nname = \"near\"\nposition = [-0.6, 0.72]\n"
        "\n[[probes]]\nposition = [-0.6, 0.5]\n";
    write_file(folder / "stream.toml", read_file(MORTISE_SOURCE_DIR "/cases/free_stream/case.toml") + probes);
  }
  Outcome run(const Arguments& arguments) const {
    const Outcome outcome = run_program(arguments, {.folder = folder.path()});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    return outcome;
  }

  const ScratchFolder folder;
  const std::string out = folder / "out";
};

double value(const CsvRow& row, const std::string& column) { return std::stod(row.at(column)); }

TEST_F(ProgramOutput, BodiesFollowTheirMotion) {
  run(stream);
  EXPECT_EQ(lines(read_file(out + "/bodies.csv")).at(0), "t,body,x,y,angle,vx,vy,omega,fx,fy,torque");
  const std::vector<CsvRow> rows = csv_rows(out + "/bodies.csv");
  EXPECT_EQ(rows.size(), 2 * (summary_of(out)["steps"].get<std::size_t>() + 1));
  double last = -1;
  for (std::size_t k = 0; k < rows.size(); k += 2) {
    const double t = value(rows[k], "t");
    EXPECT_GT(t, last);
    last = t;
    EXPECT_EQ(value(rows[k + 1], "t"), t);
    EXPECT_EQ(rows[k].at("body"), "ellipse");
    EXPECT_EQ(rows[k + 1].at("body"), "stick");
    EXPECT_NEAR(value(rows[k], "x"), -0.6 + 0.5 / 3 * std::sin(3 * t), 1e-13);
    EXPECT_NEAR(value(rows[k], "y"), 0.5 - 0.4 * t, 1e-13);
    EXPECT_NEAR(value(rows[k], "angle"), 34 * M_PI / 180 + 2 * t, 1e-13);
    EXPECT_NEAR(value(rows[k + 1], "angle"), -20 * M_PI / 180 - 3 * t, 1e-13);
  }
  EXPECT_EQ(value(rows[0], "t"), 0);
  EXPECT_EQ(value(rows[0], "x"), -0.6);
  EXPECT_EQ(last, 0.6);
  const nlohmann::json ellipse = summary_of(out)["bodies"][0];
  EXPECT_EQ(ellipse["name"], "ellipse");
  EXPECT_EQ(ellipse["position"][0], value(rows[rows.size() - 2], "x"));
  EXPECT_EQ(ellipse["angle"], value(rows[rows.size() - 2], "angle"));
}

TEST_F(ProgramOutput, ProbesSeeTheStream) {
  run(stream);
  EXPECT_EQ(lines(read_file(out + "/probes.csv")).at(0), "t,probe,density,velocity_x,velocity_y,pressure");
  const std::vector<CsvRow> rows = csv_rows(out + "/probes.csv");
  EXPECT_EQ(rows.size(), 3 * (summary_of(out)["steps"].get<std::size_t>() + 1));
  EXPECT_EQ(value(rows[0], "t"), 0);
  for (std::size_t k = 0; k < rows.size(); k += 3) {
    EXPECT_EQ(rows[k].at("probe"), "stream");
    EXPECT_EQ(rows[k + 2].at("probe"), "probe_2");
    for (std::size_t p : {k, k + 1}) {
      EXPECT_NEAR(value(rows[p], "density"), 1.0, 1e-11);
      EXPECT_NEAR(value(rows[p], "velocity_x"), 0.5, 1e-11);
      EXPECT_NEAR(value(rows[p], "velocity_y"), 0.3, 1e-11);
      EXPECT_NEAR(value(rows[p], "pressure"), 1.0, 1e-11);
    }
  }
  EXPECT_EQ(rows[2].at("density"), "nan");  // inside the ellipse at t = 0
}

TEST_F(ProgramOutput, SummaryHasEveryKey) {
  run(stream);
  const nlohmann::json summary = summary_of(out);
  for (const char* key : {"case", "scheme", "status", "reason", "time", "steps", "ranks", "wall_seconds",
                          "cell_updates", "cell_updates_per_second", "skipped_fraction", "phases", "memory_bytes",
                          "cells", "errors", "bodies", "overlap"})
    EXPECT_TRUE(summary.contains(key)) << key;
  EXPECT_EQ(summary["case"], "stream");
  EXPECT_EQ(summary["scheme"], "rigid");
  EXPECT_EQ(summary["status"], "finished");
  EXPECT_EQ(summary["reason"], "");
  EXPECT_EQ(summary["time"], 0.6);
  EXPECT_EQ(summary["ranks"], 1);
  EXPECT_EQ(summary["cells"].size(), 3U);
  EXPECT_EQ(summary["cells"]["background"], 76 * 76);
  for (const char* error :
       {"fluid.density", "fluid.velocity_x", "fluid.velocity_y", "fluid.pressure", "fluid.temperature"})
    for (const char* norm : {"l1", "l2", "max"}) EXPECT_LT(summary["errors"][error][norm], 1e-11) << error;
  for (const char* key : {"orphans", "fringe", "holes"})
    EXPECT_TRUE(summary["overlap"][key].is_number_integer()) << key;
  EXPECT_EQ(summary["overlap"]["orphans"], 0);
  for (const char* key : {"version", "git", "dirty", "compiler", "flags", "case_text"})
    EXPECT_TRUE(summary["provenance"].contains(key)) << key;
  EXPECT_EQ(summary["provenance"]["case_text"], read_file(folder / "stream.toml"));
  EXPECT_GT(summary["memory_bytes"], 1 << 20);
  EXPECT_GT(summary["phases"]["fluid"], 0);
}

TEST_F(ProgramOutput, ConservationInAClosedBox) {
  const Arguments closed = {
      "--set", "boundaries={left=\"periodic\", right=\"periodic\", bottom=\"periodic\", top=\"periodic\"}"};
  run(Arguments{"run", "oblique_shock", "--output", "out", "--quiet", "--frames", "0", "--set", "grid.factor=2",
                "--until", "0.1", "--set", "exact=none"} +
      closed);
  for (const char* key : {"mass", "momentum", "energy"})
    EXPECT_LT(std::abs(summary_of(out)["conservation"][key].get<double>()), 1e-13);
}

/// Every opened element is closed, in order.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z]+)[^<>]*?(/?)>");
  for (std::sregex_iterator found(xml.begin(), xml.end(), tag), end; found != end; ++found) {
    const std::string name = (*found)[2];
    if ((*found)[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), name);
      open.pop_back();
    } else if ((*found)[3] != "/") {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
}

/// Class and size of the numbers in a dataset.
std::pair<H5T_class_t, std::size_t> number_type(const std::string& path, const std::string& name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
              set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(set);
  const std::pair<H5T_class_t, std::size_t> result(H5Tget_class(type), H5Tget_size(type));
  H5Tclose(type);
  H5Dclose(set);
  H5Fclose(file);
  return result;
}

TEST_F(ProgramOutput, IndexDescribesTheFields) {
  run(stream);
  const std::string xml = read_file(out + "/mortise.xdmf");
  expect_well_formed(xml);
  const std::regex item(
      "<DataItem Dimensions=\"([0-9 ]+)\" Format=\"HDF\" NumberType=\"(\\w+)\" "
      "Precision=\"(\\d)\">([^:<]+):/([^<]+)</");
  int items = 0;
  for (std::sregex_iterator found(xml.begin(), xml.end(), item), end; found != end; ++found, ++items) {
    const std::string path = out + "/" + (*found)[4].str(), name = (*found)[5];
    std::string shape;
    for (const auto extent : HDF5File::open(path).shape(name))
      shape += (shape.empty() ? "" : " ") + std::to_string(extent);
    EXPECT_EQ(shape, (*found)[1]) << path << ' ' << name;
    const bool real = (*found)[2] == "Float";
    EXPECT_EQ(number_type(path, name),
              std::pair(real ? H5T_FLOAT : H5T_INTEGER, static_cast<std::size_t>(real ? 8 : 1)))
        << name;
    EXPECT_EQ((*found)[3], real ? "8" : "1");
  }
  EXPECT_EQ(items, count(xml, "<DataItem"));
  EXPECT_EQ(items, 4 * 3 * 8);  // steps, grids; nodes, 5 fields, mask, ghosts
  EXPECT_EQ(count(xml, "TopologyType=\"2DSMesh\""), 12);
  for (const auto& [grid, cells] : summary_of(out)["cells"].items())
    EXPECT_EQ(count(xml, "<Grid Name=\"" + grid + "\""), 4) << grid;
  EXPECT_NE(xml.find("<Time Value=\"0\"/>"), std::string::npos);
  EXPECT_NE(xml.find("<Time Value=\"0.6\"/>"), std::string::npos);
}

TEST_F(ProgramOutput, FieldsHideWhatIsNotActive) {
  run(stream);
  ASSERT_EQ(series_files(out).size(), 4U);
  const std::string last = series_files(out).back();
  const Snapshot snapshot = read_snapshot(last);
  EXPECT_EQ(snapshot.time, 0.6);
  EXPECT_EQ(snapshot.step, summary_of(out)["steps"]);
  ASSERT_EQ(snapshot.grids.size(), 3U);
  std::set<int> kinds;
  for (std::size_t g = 0; g < 3; ++g) {
    const GridSnapshot& grid = snapshot.grids[g];
    const std::vector<std::uint8_t> hidden =
        HDF5File::open(last).read_bytes("grids/" + std::to_string(g) + "/vtkGhostType");
    ASSERT_EQ(hidden.size(), grid.mask.size());
    for (std::size_t k = 0; k < hidden.size(); ++k) {
      kinds.insert(grid.mask[k]);
      ASSERT_EQ(hidden[k], grid.mask[k] == 0 ? 0 : 32);
      ASSERT_NEAR(grid.mask[k] == 0 ? grid.field("density")->at(k) : 1.0, 1.0, 1e-11);
    }
  }
  EXPECT_EQ(kinds, (std::set<int>{0, 1, 2}));
}

TEST_F(ProgramOutput, Frames) {
  run(stream + Arguments{"--set", "output.pictures=[\"pressure\", \"grids\"]"});
  std::set<std::string> pictures;
  for (const auto& item : std::filesystem::directory_iterator(out + "/frames")) {
    pictures.insert(item.path().filename().string());
    EXPECT_EQ(read_file(item.path().string()).substr(0, 8), "\x89PNG\r\n\x1a\n");
  }
  EXPECT_EQ(pictures,
            (std::set<std::string>{"pressure_0000.png", "pressure_0001.png", "pressure_0002.png", "pressure_0003.png",
                                   "grids_0000.png", "grids_0001.png", "grids_0002.png", "grids_0003.png"}));
  EXPECT_EQ(read_snapshot(series_files(out)[1]).time, 0.6 * 1 / 3);
  run(still + Arguments{"--frames", "0", "--overwrite"});
  EXPECT_EQ(files_in(out), (std::set<std::string>{"bodies.csv", "probes.csv", "summary.json"}));
}

TEST_F(ProgramOutput, Until) {
  run(stream + Arguments{"--until", "0.25"});
  EXPECT_EQ(summary_of(out)["time"], 0.25);
  EXPECT_EQ(summary_of(out)["status"], "finished");
  EXPECT_EQ(read_snapshot(series_files(out).back()).time, 0.25);
  EXPECT_EQ(series_files(out).size(), 3U);  // at 0, 0.2 and 0.25
}

TEST_F(ProgramOutput, ProgressIsPlainLinesAndQuietIsQuiet) {
  const Outcome told = run(stream);
  EXPECT_EQ(told.output.find('\r'), std::string::npos);
  const std::regex line(R"(\[[#.]{24}\] t [0-9.]+/0\.6  step \d+  dt [0-9.e-]+  [0-9.]+ Mcell/s  eta \d+ s)");
  int progress = 0;
  for (const std::string& text : lines(told.output)) progress += std::regex_match(text, line) ? 1 : 0;
  EXPECT_GE(progress, 10);
  EXPECT_LE(progress, 30);
  for (const char* part :
       {"finished at t = 0.6", "out/summary.json", "out/mortise.xdmf", "out/frames/grids_0003.png", "fluid.density"})
    EXPECT_NE(told.output.find(part), std::string::npos) << part;
  EXPECT_EQ(run(stream + Arguments{"--quiet", "--overwrite"}).output, "");
}

TEST_F(ProgramOutput, DefaultDirectoryIsNamedAfterTheCase) {
  run({"run", "sod", "--quiet", "--frames", "0"});
  EXPECT_EQ(summary_of(folder / "output/sod")["case"], "sod");
}

TEST_F(ProgramOutput, Render) {
  run(stream + Arguments{"--quiet"});
  const Outcome told = run({"render", "out", "--field", "pressure"});
  EXPECT_NE(told.output.find("4 pictures, the last one out/frames/pressure_0003.png"), std::string::npos)
      << told.output;
  for (const char* name : {"0000", "0001", "0002", "0003"})
    EXPECT_EQ(read_file(out + "/frames/pressure_" + name + ".png").substr(1, 3), "PNG");
  run({"render", "out"});
  EXPECT_TRUE(std::filesystem::exists(out + "/frames/schlieren_0003.png"));
  const Outcome wrong = run_program({"render", "out", "--field", "presure"}, {.folder = folder.path()});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.errors.find("did you mean \"pressure\"?"), std::string::npos) << wrong.errors;
}

TEST_F(ProgramOutput, Lists) {
  const auto listed = [&](const std::string& kind) { return lines(run({"list", kind}).output); };
  const auto has = [](const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  EXPECT_TRUE(has(listed("cases"), "shock_rigid_sticks"));
  EXPECT_TRUE(has(listed("schemes"), "traditional"));
  EXPECT_TRUE(has(listed("riemann"), "exact"));
  EXPECT_TRUE(has(listed("limiters"), "mc"));
  EXPECT_TRUE(has(listed("materials"), "neo_hookean"));
  EXPECT_TRUE(has(listed("keys"), "bodies.N.density"));
  const std::string all = run({"list"}).output;
  for (const char* kind : {"cases ", "schemes ", "riemann ", "limiters ", "shapes ", "boundaries ", "pictures "})
    EXPECT_NE(all.find(kind), std::string::npos) << kind;
}

// Each line says the name of one case that check accepts.
TEST_F(ProgramOutput, EveryShippedCaseIsValid) {
  for (const std::string& name : lines(run({"list", "cases"}).output))
    EXPECT_EQ(run({"check", name}).output, name + ": the case is valid\n");
}

TEST_F(ProgramOutput, Help) {
  const std::string help = run({"--help"}).output;
  for (const char* word :
       {"run", "check", "list", "render", "--version", "Exit status: 0 done; 2", "mortise run shock_rigid_sticks"})
    EXPECT_NE(help.find(word), std::string::npos) << word;
  const std::string of_run = run({"run", "--help"}).output;
  for (const char* word : {"--set KEY=VALUE", "--output DIR", "--until T", "--no-skip", "--frames N", "--restart DIR",
                           "--quiet", "--overwrite"})
    EXPECT_NE(of_run.find(word), std::string::npos) << word;
  EXPECT_EQ(lines(run({"--version"}).output).size(), 1U);
}

}  // namespace
}  // namespace mortise::testing
