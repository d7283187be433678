#include "mortise/grids/output/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

void write_every_kind(const std::string& path) {
  HDF5File file = HDF5File::create(path);
  file.write("a/b/doubles", std::vector<double>{1.5, -0.0, std::numeric_limits<double>::infinity(), 4, 5, 6}, {2, 3});
  file.write("integers", std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), 7}, {2});
  file.write("bytes", std::vector<std::uint8_t>{0, 1, 255}, {3, 1});
  file.write("none", std::vector<double>{}, {0});
  file.write_texts("texts", {"short", "", "ρ, a longer one"});
  file.write_attribute("/", "time", 0.1);
  file.write_attribute("a/b/doubles", "count", std::int64_t{6});
  file.close();
}

TEST(HDF5File, ReturnsWhatWasWritten) {
  const ScratchFolder folder;
  write_every_kind(folder / "f.h5");
  const HDF5File file = HDF5File::open(folder / "f.h5");
  EXPECT_EQ(file.read_doubles("a/b/doubles"),
            (std::vector<double>{1.5, -0.0, std::numeric_limits<double>::infinity(), 4, 5, 6}));
  EXPECT_EQ(file.shape("a/b/doubles"), (HDF5File::Shape{2, 3}));
  EXPECT_EQ(file.read_integers("integers"), (std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min(), 7}));
  EXPECT_EQ(file.read_bytes("bytes"), (std::vector<std::uint8_t>{0, 1, 255}));
  EXPECT_EQ(file.shape("bytes"), (HDF5File::Shape{3, 1}));
  EXPECT_TRUE(file.read_doubles("none").empty());
  EXPECT_EQ(file.read_texts("texts"), (std::vector<std::string>{"short", "", "ρ, a longer one"}));
  EXPECT_EQ(file.double_attribute("/", "time"), 0.1);
  EXPECT_EQ(file.integer_attribute("a/b/doubles", "count"), 6);
  EXPECT_TRUE(file.has("a/b/doubles"));
  EXPECT_FALSE(file.has("a/c/doubles"));
}

TEST(HDF5File, SameDataGiveTheSameBytesAtAnotherTime) {
  const ScratchFolder folder;
  write_every_kind(folder / "f.h5");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // time stamps would count seconds
  write_every_kind(folder / "g.h5");
  EXPECT_EQ(read_file(folder / "f.h5"), read_file(folder / "g.h5"));
}

TEST(HDF5File, RefusesDataThatDoNotFillTheShape) {
  const ScratchFolder folder;
  HDF5File file = HDF5File::create(folder / "f.h5");
  EXPECT_THROW(file.write("x", std::vector<double>{1, 2, 3}, {2, 2}), EnvironmentError);
}

TEST(HDF5File, NamesFileAndDatasetInErrors) {
  const ScratchFolder folder;
  EXPECT_THROW(HDF5File::create(folder / "no/f.h5"), EnvironmentError);
  EXPECT_THROW(HDF5File::open(folder / "f.h5"), EnvironmentError);
  write_every_kind(folder / "f.h5");
  const HDF5File file = HDF5File::open(folder / "f.h5");
  EXPECT_THROW(file.read_texts("integers"), EnvironmentError);
  EXPECT_THROW(file.double_attribute("/", "none"), EnvironmentError);
  try {
    file.read_doubles("velocity");
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("velocity"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find(folder / "f.h5"), std::string::npos);
  }
}

}  // namespace
}  // namespace mortise
