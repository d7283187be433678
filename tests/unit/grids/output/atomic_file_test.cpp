#include "mortise/grids/output/atomic_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "mortise/grids/core/error.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

TEST(AtomicFile, ReplacesTheContentAndLeavesNoTemporaryFile) {
  const ScratchFolder folder;
  write_file(folder / "a", "first, longer");
  write_file(folder / "a", std::string("sec\0ond", 7));
  EXPECT_EQ(read_file(folder / "a"), std::string("sec\0ond", 7));
  EXPECT_EQ(folder.files(), 1);
}

TEST(AtomicFile, KeepsTheOldFileWhenTheNewOneCannotBeWritten) {
  const ScratchFolder folder;
  write_file(folder / "a", "old");
  std::filesystem::create_directory(temporary_name(folder / "a"));  // in the way
  EXPECT_THROW(write_file(folder / "a", "new"), EnvironmentError);
  EXPECT_EQ(read_file(folder / "a"), "old");
}

TEST(AtomicFile, NamesThePathThatFailed) {
  const ScratchFolder folder;
  try {
    write_file(folder / "missing/a", "x");
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find(folder / "missing/a"), std::string::npos) << error.what();
  }
  EXPECT_THROW(read_file(folder / "b"), EnvironmentError);
}

TEST(AtomicFile, MakesNestedFolders) {
  const ScratchFolder folder;
  make_folder(folder / "x/y");
  make_folder(folder / "x/y");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "x/y"));
  write_file(folder / "file", "");
  EXPECT_THROW(make_folder(folder / "file/z"), EnvironmentError);
}

TEST(AtomicFile, ShortestFormReadsBackExactly) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1.0), "1");
  for (const double value : {1.0 / 3, 6.02214076e23, 5e-324, -0.0, std::numeric_limits<double>::max()})
    EXPECT_EQ(std::strtod(shortest(value).c_str(), nullptr), value) << shortest(value);
}

}  // namespace
}  // namespace mortise
