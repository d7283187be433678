#include "mortise/grids/output/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "scratch_folder.hpp"

namespace mortise {
namespace {

using test::ScratchFolder;

std::vector<double> numbers(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = std::sin(static_cast<double>(k) + 0.5);
  return values;
}

void write_checkpoint(const std::string& path) {
  CheckpointWriter writer(path);
  writer.write("background/density", numbers(10000));
  writer.write("step", std::vector<std::int64_t>{812});
  writer.write("mask", std::vector<std::uint8_t>{0, 1, 2, 1, 0});
  writer.write("case", std::vector<std::string>{"title = \"ρ\"\n[grid]\nfactor = 8\n"});
  writer.finish();
}

/// The sentence of the EnvironmentError thrown by `action`.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Checkpoint, ReturnsEveryBit) {
  const ScratchFolder folder;
  write_checkpoint(folder / "c.h5");
  const CheckpointReader reader(folder / "c.h5");
  const std::vector<double> read = reader.doubles("background/density"), written = numbers(10000);
  ASSERT_EQ(read.size(), written.size());
  EXPECT_EQ(std::memcmp(read.data(), written.data(), read.size() * sizeof(double)), 0);
  EXPECT_EQ(reader.integers("step"), std::vector<std::int64_t>{812});
  EXPECT_EQ(reader.bytes("mask"), (std::vector<std::uint8_t>{0, 1, 2, 1, 0}));
  EXPECT_EQ(reader.texts("case").at(0), "title = \"ρ\"\n[grid]\nfactor = 8\n");
  EXPECT_TRUE(reader.has("mask"));
  EXPECT_FALSE(reader.has("background/pressure"));
  EXPECT_EQ(folder.files(), 1);
}

TEST(Checkpoint, KeepsTheOldOneUntilTheNewOneIsFinished) {
  const ScratchFolder folder;
  write_checkpoint(folder / "c.h5");
  const std::string before = read_file(folder / "c.h5");
  {
    CheckpointWriter writer(folder / "c.h5");
    writer.write("step", std::vector<std::int64_t>{813});
    EXPECT_EQ(read_file(folder / "c.h5"), before);
  }
  EXPECT_EQ(read_file(folder / "c.h5"), before);
  EXPECT_EQ(folder.files(), 1);
}

TEST(Checkpoint, RefusesAMissingFile) {
  const ScratchFolder folder;
  const std::string sentence = refusal([&] { CheckpointReader reader(folder / "none.h5"); });
  EXPECT_EQ(sentence.find("cannot read the restart \"" + (folder / "none.h5")), 0U) << sentence;
}

TEST(Checkpoint, RefusesEveryTruncation) {
  const ScratchFolder folder;
  write_checkpoint(folder / "c.h5");
  const std::string whole = read_file(folder / "c.h5");
  for (const double part : {0.0, 0.001, 0.1, 0.5, 0.9, 0.9999}) {
    write_file(folder / "cut.h5", whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
    const std::string sentence = refusal([&] { CheckpointReader reader(folder / "cut.h5"); });
    EXPECT_EQ(sentence.find("cannot read the restart"), 0U) << part << ": " << sentence;
  }
}

TEST(Checkpoint, RefusesASingleFlippedBit) {
  const ScratchFolder folder;
  write_checkpoint(folder / "c.h5");
  std::string bytes = read_file(folder / "c.h5");
  const double marker = numbers(5001).back();  // somewhere inside the data
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&marker), sizeof marker));
  ASSERT_NE(at, std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  write_file(folder / "c.h5", bytes);
  const CheckpointReader reader(folder / "c.h5");
  EXPECT_EQ(reader.integers("step").at(0), 812);
  const std::string sentence = refusal([&] { reader.doubles("background/density"); });
  EXPECT_EQ(sentence.find("cannot read the restart"), 0U) << sentence;
  EXPECT_NE(sentence.find("background/density"), std::string::npos) << sentence;
}

TEST(Checkpoint, RefusesOtherFilesOtherFormatsAndMissingVectors) {
  const ScratchFolder folder;
  write_file(folder / "text.h5", "this is not a checkpoint");
  EXPECT_EQ(refusal([&] { CheckpointReader reader(folder / "text.h5"); }).find("cannot read the restart"), 0U);
  HDF5File other = HDF5File::create(folder / "other.h5");
  other.write_attribute("/", "mortise_checkpoint", checkpoint_format + 1);
  other.close();
  EXPECT_NE(refusal([&] { CheckpointReader reader(folder / "other.h5"); }).find("version 2"), std::string::npos);
  write_checkpoint(folder / "c.h5");
  const CheckpointReader reader(folder / "c.h5");
  EXPECT_EQ(refusal([&] { reader.doubles("pressure"); }).find("cannot read the restart"), 0U);
}

TEST(Checkpoint, ReportsAFolderThatIsNotThere) {
  const ScratchFolder folder;
  EXPECT_THROW(CheckpointWriter(folder / "no/c.h5"), EnvironmentError);
}

TEST(Checkpoint, SameStateSameBytes) {
  const ScratchFolder folder;
  write_checkpoint(folder / "a.h5");
  write_checkpoint(folder / "b.h5");
  EXPECT_EQ(read_file(folder / "a.h5"), read_file(folder / "b.h5"));
}

}  // namespace
}  // namespace mortise
