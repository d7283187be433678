#include "mortise/grids/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mortise/grids/core/error.hpp"

namespace mortise {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  const int reason = errno;
  std::remove(temporary_name(path).c_str());
  throw EnvironmentError("cannot " + what + " \"" + path + "\": " + std::strerror(reason));
}

}  // namespace

std::string temporary_name(const std::string& path) { return path + ".part"; }

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw EnvironmentError("cannot create the folder \"" + folder + "\": " + error.message());
}

void publish(const std::string& path, Durable durable) {
  const std::string temporary = temporary_name(path);
  bool synced = true;
  if (durable == Durable::yes) {
    const int file = ::open(temporary.c_str(), O_RDONLY);
    if (file < 0) fail("write", path);
    synced = ::fsync(file) == 0 || errno == EINVAL;  // EINVAL: a file system without fsync
    ::close(file);
  }
  if (!synced || std::rename(temporary.c_str(), path.c_str()) != 0) fail("write", path);
}

void write_file(const std::string& path, std::string_view content, Durable durable) {
  std::FILE* file = std::fopen(temporary_name(path).c_str(), "wb");
  if (!file) fail("write", path);
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  if (std::fclose(file) != 0 || !written) fail("write", path);
  publish(path, durable);
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw EnvironmentError("cannot read \"" + path + "\": " + std::strerror(errno));
  std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw EnvironmentError("cannot read \"" + path + "\": " + std::strerror(errno));
  return content;
}

std::string shortest(double value) {
  if (value == std::trunc(value) && std::fabs(value) < 1e15 && (value != 0 || !std::signbit(value)))
    return std::to_string(static_cast<long long>(value));  // 100000 rather than 1e+05
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

}  // namespace mortise
