#include "mortise/grids/output/checkpoint.hpp"

#include <bit>
#include <cstring>
#include <exception>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

/// Fowler-Noll-Vo hash by 8-byte words, rotated so that high bits spread too.
class Checksum {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* from = static_cast<const unsigned char*>(data);
    for (; bytes >= 8; bytes -= 8, from += 8) {
      std::uint64_t word;
      std::memcpy(&word, from, 8);
      mix(word);
    }
    for (; bytes > 0; --bytes, ++from) mix(*from);
  }
  std::uint64_t value() const { return sum_; }

 private:
  void mix(std::uint64_t word) { sum_ = std::rotl((sum_ ^ word) * 0x100000001b3ULL, 23); }
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

template <class T>
std::uint64_t checksum(const std::vector<T>& values) {
  Checksum sum;
  sum.add(values.data(), values.size() * sizeof(T));
  const std::uint64_t count = values.size();
  sum.add(&count, sizeof count);
  return sum.value();
}

std::uint64_t checksum(const std::vector<std::string>& texts) {
  Checksum sum;
  for (const std::string& text : texts) {
    sum.add(text.data(), text.size());
    const std::uint64_t length = text.size();
    sum.add(&length, sizeof length);
  }
  return sum.value();
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path) : file_(HDF5File::create(path)) {
  file_.write_attribute("/", "mortise_checkpoint", checkpoint_format);
}

void CheckpointWriter::seal(const std::string& name, std::uint64_t checksum) {
  file_.write_attribute(name, "checksum", std::bit_cast<std::int64_t>(checksum));
}

void CheckpointWriter::write(const std::string& name, const std::vector<double>& values) {
  file_.write(name, values, {values.size()});
  seal(name, checksum(values));
}
void CheckpointWriter::write(const std::string& name, const std::vector<std::int64_t>& values) {
  file_.write(name, values, {values.size()});
  seal(name, checksum(values));
}
void CheckpointWriter::write(const std::string& name, const std::vector<std::uint8_t>& values) {
  file_.write(name, values, {values.size()});
  seal(name, checksum(values));
}
void CheckpointWriter::write(const std::string& name, const std::vector<std::string>& texts) {
  file_.write_texts(name, texts);
  seal(name, checksum(texts));
}

CheckpointReader::CheckpointReader(std::string path) : path_(std::move(path)) {
  std::int64_t format = 0;
  try {
    file_.emplace(HDF5File::open(path_));
    format = file_->integer_attribute("/", "mortise_checkpoint");
  } catch (const EnvironmentError&) {
    refuse("it is missing, incomplete or not a checkpoint of mortise");
  }
  if (format != checkpoint_format)
    refuse("its format is version " + std::to_string(format) + ", this program reads version " +
           std::to_string(checkpoint_format));
}

void CheckpointReader::refuse(const std::string& why) const {
  throw EnvironmentError("cannot read the restart \"" + path_ + "\": " + why);
}

template <class Read>
auto CheckpointReader::checked(const std::string& name, Read read) const {
  std::uint64_t expected = 0, found = 0;
  decltype(read()) values;
  try {
    values = read();
    found = checksum(values);
    expected = std::bit_cast<std::uint64_t>(file_->integer_attribute(name, "checksum"));
  } catch (const std::exception&) {  // of HDF5, or out of memory because a size is damaged
    refuse("\"" + name + "\" is missing or damaged");
  }
  if (found != expected) refuse("\"" + name + "\" is damaged (its checksum is wrong)");
  return values;
}

bool CheckpointReader::has(const std::string& name) const { return file_->has(name); }

std::vector<double> CheckpointReader::doubles(const std::string& name) const {
  return checked(name, [&] { return file_->read_doubles(name); });
}
std::vector<std::int64_t> CheckpointReader::integers(const std::string& name) const {
  return checked(name, [&] { return file_->read_integers(name); });
}
std::vector<std::uint8_t> CheckpointReader::bytes(const std::string& name) const {
  return checked(name, [&] { return file_->read_bytes(name); });
}
std::vector<std::string> CheckpointReader::texts(const std::string& name) const {
  return checked(name, [&] { return file_->read_texts(name); });
}

}  // namespace mortise
