#include "mortise/grids/output/csv.hpp"

#include <gtest/gtest.h>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

const std::vector<std::string> columns{"t", "body", "x"};

TEST(Csv, WritesHeaderAndRowsAtOnce) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "bodies.csv", columns);
  EXPECT_EQ(read_file(folder / "bodies.csv"), "t,body,x\n");
  csv.row({0.0, "stick_0", 1.0 / 3});
  EXPECT_EQ(read_file(folder / "bodies.csv"), "t,body,x\n0,stick_0,0.3333333333333333\n");
  csv.row({0.1, "stick_0", std::int64_t{-7}});
  EXPECT_EQ(read_file(folder / "bodies.csv"), "t,body,x\n0,stick_0,0.3333333333333333\n0.1,stick_0,-7\n");
}

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "a.csv", columns);
  csv.row({1.0, "two, \"words\"", 2.0});
  csv.row({1.0, "two\nlines", 2.0});
  EXPECT_EQ(read_file(folder / "a.csv"), "t,body,x\n1,\"two, \"\"words\"\"\",2\n1,two lines,2\n");
}

TEST(Csv, NumbersReadBackExactly) {
  const ScratchFolder folder;
  CsvWriter csv(folder / "a.csv", {"t", "v"});
  const double value = 0.1 + 0.2;
  csv.row({5e-324, value});
  const std::string text = read_file(folder / "a.csv");
  EXPECT_EQ(std::stod(text.substr(text.rfind(',') + 1)), value);
  EXPECT_NE(text.find("5e-324,"), std::string::npos);
}

TEST(Csv, ContinuesAfterARestart) {
  const ScratchFolder folder;
  {
    CsvWriter csv(folder / "a.csv", columns);
    for (const double t : {0.0, 0.1, 0.2, 0.3})
      for (const char* body : {"one", "two"}) csv.row({t, body, 10 * t});
  }
  write_file(folder / "a.csv", read_file(folder / "a.csv") + "0.1,half a r");  // the run was killed while writing
  {
    CsvWriter csv = CsvWriter::truncate_after(folder / "a.csv", columns, 0.1);
    csv.row({0.15, "one", 1.5});
  }
  EXPECT_EQ(read_file(folder / "a.csv"), "t,body,x\n0,one,0\n0,two,0\n0.1,one,1\n0.1,two,1\n0.15,one,1.5\n");
  EXPECT_EQ(folder.files(), 1);
}

TEST(Csv, StartsAnewWhenThereIsNothingToContinue) {
  const ScratchFolder folder;
  CsvWriter::truncate_after(folder / "a.csv", columns, 0.1).row({0.2, "one", 1.0});
  EXPECT_EQ(read_file(folder / "a.csv"), "t,body,x\n0.2,one,1\n");
}

TEST(Csv, RefusesToContinueOtherColumns) {
  const ScratchFolder folder;
  write_file(folder / "a.csv", "t,body,y\n0,one,1\n");
  EXPECT_THROW(CsvWriter::truncate_after(folder / "a.csv", columns, 1), EnvironmentError);
  EXPECT_EQ(read_file(folder / "a.csv"), "t,body,y\n0,one,1\n");
}

TEST(Csv, ReportsAFullDisk) { EXPECT_THROW(CsvWriter("/dev/full", columns), EnvironmentError); }

TEST(Csv, ReportsAFolderThatIsNotThere) {
  const ScratchFolder folder;
  EXPECT_THROW(CsvWriter(folder / "no/a.csv", columns), EnvironmentError);
}

}  // namespace
}  // namespace mortise
