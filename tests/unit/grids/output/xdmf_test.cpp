#include "mortise/grids/output/xdmf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "mortise/grids/output/hdf5_file.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

GridSnapshot plane_grid(const std::string& name, int n, int m) {
  GridSnapshot grid;
  grid.name = name;
  grid.cells = {n, m};
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      grid.x.push_back(0.1 * i + 0.01 * j);
      grid.y.push_back(0.2 * j - 0.003 * i * j);
    }
  std::vector<double> density, pressure;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    grid.mask.push_back(static_cast<std::uint8_t>(c % 3));
    density.push_back(1 / (1.0 + static_cast<double>(c)));
    pressure.push_back(std::sqrt(static_cast<double>(c)));
  }
  grid.fields = {{"pressure", pressure}, {"density", density}};
  return grid;
}

Snapshot example(double time, int step) {
  Snapshot snapshot;
  snapshot.time = time;
  snapshot.step = step;
  snapshot.grids = {plane_grid("background", 5, 3), plane_grid("stick <0>/a", 4, 7),
                    line_grid("line", {0.0, 0.5, 1.0})};
  snapshot.grids.back().fields = {{"density", {1.0, 2.0}}};
  snapshot.grids[1].solid = true;
  snapshot.outlines = {{Point<2>(0, 0), Point<2>(1, 0), Point<2>(0, 1)},
                       {Point<2>(2, 2), Point<2>(3, 2), Point<2>(3, 3), Point<2>(2, 3)}};
  return snapshot;
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.outlines, b.outlines);
  ASSERT_EQ(a.grids.size(), b.grids.size());
  for (std::size_t k = 0; k < a.grids.size(); ++k) {
    EXPECT_EQ(a.grids[k].name, b.grids[k].name);
    EXPECT_EQ(a.grids[k].cells, b.grids[k].cells);
    EXPECT_EQ(a.grids[k].dimension, b.grids[k].dimension);
    EXPECT_EQ(a.grids[k].solid, b.grids[k].solid);
    EXPECT_EQ(a.grids[k].x, b.grids[k].x);
    EXPECT_EQ(a.grids[k].y, b.grids[k].y);
    EXPECT_EQ(a.grids[k].mask, b.grids[k].mask);
    EXPECT_EQ(a.grids[k].fields, b.grids[k].fields);
  }
}

std::vector<std::uint64_t> numbers(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::uint64_t>(stream), {}};
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Xdmf, SnapshotReadsBackToTheBit) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  series.write(example(0.1, 123));
  EXPECT_TRUE(std::filesystem::exists(folder / "fields/step_000123.h5"));
  EXPECT_EQ(folder.files(), 2);
  expect_same(read_snapshot(folder / "fields/step_000123.h5"), example(0.1, 123));
}

TEST(Xdmf, DeclaredDimensionsAreThoseOfTheDatasets) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  series.write(example(0.0, 0));
  const std::string xml = read_file(folder / "mortise.xdmf");
  const HDF5File file = HDF5File::open(folder / "fields/step_000000.h5");
  const std::regex item("<DataItem Dimensions=\"([0-9 ]+)\"[^>]*>fields/step_000000.h5:/([^<]+)</DataItem>");
  int items = 0;
  for (auto match = std::sregex_iterator(xml.begin(), xml.end(), item); match != std::sregex_iterator();
       ++match, ++items)
    EXPECT_EQ(numbers((*match)[1]), file.shape((*match)[2])) << (*match)[2];
  EXPECT_EQ(items, 3 + 3 * 2 + (2 + 2 + 1));  // nodes; mask and ghost type; fields
  EXPECT_NE(xml.find("<Topology TopologyType=\"2DSMesh\" Dimensions=\"4 6\"/>"), std::string::npos);
  EXPECT_NE(xml.find("<Topology TopologyType=\"2DSMesh\" Dimensions=\"2 3\"/>"),
            std::string::npos);  // one row of cells
  EXPECT_NE(xml.find("<Grid Name=\"stick &lt;0&gt;/a\""), std::string::npos);
}

TEST(Xdmf, HidesWhatIsNotActive) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  series.write(example(0.0, 0));
  const HDF5File file = HDF5File::open(folder / "fields/step_000000.h5");
  const auto mask = file.read_bytes("grids/0/mask"), ghost = file.read_bytes("grids/0/vtkGhostType");
  ASSERT_EQ(mask.size(), 15U);
  for (std::size_t c = 0; c < mask.size(); ++c) EXPECT_EQ(ghost[c], mask[c] == mask_active ? 0 : 32);
}

TEST(Xdmf, NodesAreInterleavedRowByRow) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  series.write(example(0.0, 0));
  const auto nodes = HDF5File::open(folder / "fields/step_000000.h5").read_doubles("grids/0/nodes");
  const GridSnapshot grid = example(0, 0).grids[0];
  EXPECT_EQ(nodes[2 * grid.node(4, 2)], grid.x[grid.node(4, 2)]);
  EXPECT_EQ(nodes[2 * grid.node(4, 2) + 1], grid.y[grid.node(4, 2)]);
  EXPECT_EQ(grid.node(4, 2), 2U * 6U + 4U);
}

TEST(Xdmf, IndexListsEveryStepOnceInOrder) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  for (const int step : {0, 10, 20}) series.write(example(0.1 * step, step));
  series.write(example(1.0, 10));  // again
  const std::string xml = read_file(folder / "mortise.xdmf");
  EXPECT_EQ(count(xml, "<Time Value="), 3);
  EXPECT_LT(xml.find("Name=\"step_0\""), xml.find("Name=\"step_10\""));
  EXPECT_LT(xml.find("Name=\"step_10\""), xml.find("Name=\"step_20\""));
}

TEST(Xdmf, RestartGivesTheFilesOfAnUninterruptedRun) {
  const ScratchFolder whole, broken;
  {
    SeriesWriter series(whole.path());
    for (const int step : {0, 10, 20, 30}) series.write(example(0.1 * step, step));
  }
  {
    SeriesWriter series(broken.path());
    for (const int step : {0, 10, 25, 37}) series.write(example(0.1 * step, step));
  }
  write_file(broken / "fields/step_000040.h5", "damaged");
  write_file(broken / "fields/notes.txt", "kept");
  SeriesWriter series(broken.path(), 1.0);
  EXPECT_EQ(series_files(broken.path()).size(), 2U);
  for (const int step : {20, 30}) series.write(example(0.1 * step, step));
  EXPECT_EQ(read_file(broken / "mortise.xdmf"), read_file(whole / "mortise.xdmf"));
  ASSERT_EQ(series_files(broken.path()).size(), 4U);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(read_file(series_files(broken.path())[k]), read_file(series_files(whole.path())[k]));
  EXPECT_EQ(read_file(broken / "fields/notes.txt"), "kept");
}

TEST(Xdmf, AFreshSeriesForgetsTheOldOne) {
  const ScratchFolder folder;
  SeriesWriter(folder.path()).write(example(0.5, 5));
  const SeriesWriter fresh(folder.path());
  EXPECT_TRUE(series_files(folder.path()).empty());
  EXPECT_EQ(folder.files(), 0);
}

TEST(Xdmf, AFailedStepLeavesNothingBehind) {
  const ScratchFolder folder;
  SeriesWriter series(folder.path());
  Snapshot wrong = example(0.0, 0);
  wrong.grids[0].fields[0].second.pop_back();
  EXPECT_THROW(series.write(wrong), EnvironmentError);
  EXPECT_EQ(folder.files(), 0);
  EXPECT_THROW(read_snapshot(folder / "fields/step_000000.h5"), EnvironmentError);
}

TEST(Xdmf, SeriesFilesOfAFolderWithoutFields) { EXPECT_TRUE(series_files("/nowhere").empty()); }

TEST(Snapshot, LineGridIsOneRowAsHighAsACellIsWide) {
  const GridSnapshot grid = line_grid("line", {-1.0, -0.5, 0.0, 0.5});
  EXPECT_EQ(grid.cells, (Index<2>{3, 1}));
  EXPECT_EQ(grid.dimension, 1);
  EXPECT_EQ(grid.x, (std::vector<double>{-1, -0.5, 0, 0.5, -1, -0.5, 0, 0.5}));
  EXPECT_EQ(grid.y, (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(grid.mask, std::vector<std::uint8_t>(3, mask_active));
}

}  // namespace
}  // namespace mortise
