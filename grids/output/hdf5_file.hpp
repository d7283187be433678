// One HDF5 file, opened, used and closed by one process. Named datasets of double, int64, uint8 and text, and
// attributes. Nothing in the file depends on the time of writing: the same data give the same bytes.
// A new file is put together in memory and written by close(), so that the HDF5 library, which does not survive a full
// disk, never meets one.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {

/// Owns the file; closes it when destroyed. Names are paths ("grids/background/density"), folders are made as needed.
/// Every member throws EnvironmentError naming the file, and the dataset if there is one.
class HDF5File {
 public:
  using Shape = std::vector<std::uint64_t>;  // slowest direction first

  /// For writing; the folder must be there. An existing file at `path` stays as it is until close().
  static HDF5File create(const std::string& path);
  /// For reading.
  static HDF5File open(const std::string& path);

  ~HDF5File();
  HDF5File(HDF5File&& other) noexcept;
  HDF5File& operator=(HDF5File&&) = delete;

  /// Brings a new file to the disk, whole or not at all, and closes it. Without it nothing is written.
  void close(Durable durable = Durable::no);

  void write(const std::string& name, std::span<const double> values, const Shape& shape);
  void write(const std::string& name, std::span<const std::int64_t> values, const Shape& shape);
  void write(const std::string& name, std::span<const std::uint8_t> values, const Shape& shape);
  void write_texts(const std::string& name, const std::vector<std::string>& texts);  // no embedded zero bytes
  /// Attribute of an existing dataset or folder ("/": the file).
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);

  bool has(const std::string& name) const;
  Shape shape(const std::string& name) const;
  std::vector<double> read_doubles(const std::string& name) const;
  std::vector<std::int64_t> read_integers(const std::string& name) const;
  std::vector<std::uint8_t> read_bytes(const std::string& name) const;
  std::vector<std::string> read_texts(const std::string& name) const;
  double double_attribute(const std::string& object, const std::string& name) const;
  std::int64_t integer_attribute(const std::string& object, const std::string& name) const;

 private:
  HDF5File(std::string path, std::int64_t file, bool created) : path_(std::move(path)), file_(file), created_(created) {}

  [[noreturn]] void fail(const std::string& what, const std::string& name) const;
  void write_raw(const std::string& name, std::int64_t type, const void* values, std::size_t count, const Shape& shape);
  template <class T>
  std::vector<T> read_raw(const std::string& name, std::int64_t type) const;

  std::string path_;
  std::int64_t file_ = -1;  // HDF5 identifier; −1: closed
  bool created_;            // in memory
};

}  // namespace mortise
