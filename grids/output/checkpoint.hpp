// Checkpoints: named vectors in one HDF5 file that is published only when complete. Every vector carries a checksum,
// so that a damaged file is refused rather than continued from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mortise/grids/output/hdf5_file.hpp"

namespace mortise {

/// Version of the layout of checkpoints; a reader refuses any other.
inline constexpr std::int64_t checkpoint_format = 1;

/// Names may be paths ("background/density"). All members throw EnvironmentError when the disk is full or the folder
/// cannot be written; an older checkpoint at `path` stays untouched until finish().
class CheckpointWriter {
 public:
  explicit CheckpointWriter(const std::string& path);

  void write(const std::string& name, const std::vector<double>& values);
  void write(const std::string& name, const std::vector<std::int64_t>& values);
  void write(const std::string& name, const std::vector<std::uint8_t>& values);
  void write(const std::string& name, const std::vector<std::string>& texts);
  /// Brings everything to the disk, whole or not at all; without it nothing is written.
  void finish() { file_.close(); }

 private:
  void seal(const std::string& name, std::uint64_t checksum);

  HDF5File file_;
};

/// Throws EnvironmentError "cannot read the restart …" when the file is missing, truncated, damaged, of another format
/// version, or lacks what is asked for.
class CheckpointReader {
 public:
  explicit CheckpointReader(std::string path);

  bool has(const std::string& name) const;
  std::vector<double> doubles(const std::string& name) const;
  std::vector<std::int64_t> integers(const std::string& name) const;
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  std::vector<std::string> texts(const std::string& name) const;

 private:
  template <class Read>
  auto checked(const std::string& name, Read read) const;
  [[noreturn]] void refuse(const std::string& why) const;

  std::string path_;
  std::optional<HDF5File> file_;
};

}  // namespace mortise
